// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_flow_wall_equations_h
#define semilunar_flow_wall_equations_h

#include <semilunar/flow/bdf.h>
#include <semilunar/flow/velocity_constraints.h>
#include <semilunar/flow/wall_forms.h>
#include <semilunar/flow/wall_nodes.h>
#include <semilunar/flow/wall_support.h>

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
    /// After that, if there is tissue around the wall. @param faces with the geometry at rest
    void reinit_support(const BoundaryFaces<dim> &faces,
                        const std::set<dealii::types::boundary_id> &ids, const Vector &reference);

    /// After reinit(): balance the pressure of the blood that the parameters tell, at rest.
    /// Collective. @throws NumericsError if nothing holds the wall against it
    void balance_pressure(const CellForms<dim> &cells, const BoundaryFaces<dim> &faces,
                          const VelocityConstraints<dim> &constraints, const Vector &reference);

    void start_step(const Bdf &bdf, const Vector &old_positions, const Vector &older_positions);
    /// Positions at the new time of nodes that move with a velocity: of the wall's.
    const Vector &positions(const Vector &velocity) const;

    void linearise(const Vector &velocity);
    /// @param history alpha_1 u_old + alpha_2 u_older
    void add_residual(const Vector &velocity, const Vector &history, Vector &momentum) const;
    void add_jacobian(const Vector &velocity, Vector &momentum) const;
    /// Calls add(row, column, entry) with the support's part of the derivative between stored
    /// nodes, the same for all components; that of other ranks' faces is lumped.
    template <class Add>
    void support_matrix(const Add &add) const
    {
      if (support)
        support->matrix([&](const unsigned int row, const unsigned int column, const double mass)
                        { add(row, column, support_impedance() * mass); });
    }
    bool has_support() const { return support != nullptr; }
    /// Of the tissue around the wall, per area at rest: traction over velocity [dyn s/cm^3].
    double support_impedance() const
    {
      return prm.support_stiffness / bdf.alpha[0] + prm.support_damping;
    }

    const WallNodes<dim> &nodes() const { return wall_nodes; }
    const WallForms<dim> &solid() const { return *forms; }
    const WallParameters &parameters() const { return prm; }

  private:
    const Spaces<dim> &spaces;
    const WallParameters prm;
    WallNodes<dim> wall_nodes;
    const std::unique_ptr<WallForms<dim>> forms;
    std::unique_ptr<WallSupport<dim>> support; ///< nullptr: there is none
    Bdf bdf;
    Vector past; ///< -(alpha_1 x_old + alpha_2 x_older) / alpha_0
    mutable Vector moved;
    Vector rest;                   ///< positions at rest, if there is a support
    mutable Vector support_values; ///< what its traction is proportional to
  };
} // namespace semilunar::flow

#endif
