// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_flow_wall_equations_h
#define semilunar_flow_wall_equations_h

#include <semilunar/flow/bdf.h>
#include <semilunar/flow/wall_forms.h>
#include <semilunar/flow/wall_nodes.h>

namespace semilunar::flow
{
  /// The wall's part of the discrete equations of a time step: its positions follow from the
  /// velocity by equation (4) of doc/theory/wall.md. All vectors that are given are readable.
  template <int dim>
  class WallEquations
  {
  public:
    WallEquations(const Spaces<dim> &spaces, const WallParameters &parameters);

    /// After the mesh was refined. @param reference positions of the nodes
    void reinit(const Vector &reference);

    void start_step(const Bdf &bdf, const Vector &old_positions, const Vector &older_positions);
    /// Positions at the new time of nodes that move with a velocity: of the wall's.
    const Vector &positions(const Vector &velocity) const;

    void linearise(const Vector &velocity);
    /// @param history alpha_1 u_old + alpha_2 u_older
    void add_residual(const Vector &velocity, const Vector &history, Vector &momentum) const;
    void add_jacobian(const Vector &velocity, Vector &momentum) const
    {
      forms->add_jacobian(velocity, momentum);
    }

    const WallNodes<dim> &nodes() const { return wall_nodes; }
    const WallForms<dim> &solid() const { return *forms; }
    const WallParameters &parameters() const { return prm; }

  private:
    const Spaces<dim> &spaces;
    const WallParameters prm;
    WallNodes<dim> wall_nodes;
    const std::unique_ptr<WallForms<dim>> forms;
    Bdf bdf;
    Vector past; ///< -(alpha_1 x_old + alpha_2 x_older) / alpha_0
    mutable Vector moved;
  };
} // namespace semilunar::flow

#endif
