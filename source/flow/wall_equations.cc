// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/flow/wall_equations.h>

namespace semilunar::flow
{
  template <int dim>
  WallEquations<dim>::WallEquations(const Spaces<dim> &spaces, const WallParameters &parameters)
      : spaces(spaces), prm(parameters), wall_nodes(spaces),
        forms(WallForms<dim>::create(spaces, prm))
  {
  }

  template <int dim>
  void WallEquations<dim>::reinit(const Vector &reference)
  {
    wall_nodes.reinit();
    forms->set_reference(reference);
    past.reinit(spaces.velocities());
    moved.reinit(spaces.velocities());
  }

  template <int dim>
  void WallEquations<dim>::start_step(const Bdf &new_bdf, const Vector &old_positions,
                                      const Vector &older_positions)
  {
    bdf = new_bdf;
    past.zero_out_ghost_values();
    past.equ(-bdf.alpha[1] / bdf.alpha[0], old_positions);
    if (bdf.alpha[2] != 0.)
      past.add(-bdf.alpha[2] / bdf.alpha[0], older_positions);
    spaces.make_readable_velocity(past);
  }

  template <int dim>
  const Vector &WallEquations<dim>::positions(const Vector &velocity) const
  {
    moved.zero_out_ghost_values();
    moved.equ(1. / bdf.alpha[0], velocity);
    moved.add(1., past);
    spaces.make_readable_velocity(moved);
    return moved;
  }

  template <int dim>
  void WallEquations<dim>::linearise(const Vector &velocity)
  {
    forms->linearise(positions(velocity), bdf.alpha[0]);
  }

  template <int dim>
  void WallEquations<dim>::add_residual(const Vector &velocity, const Vector &history,
                                        Vector &momentum) const
  {
    forms->add_residual(positions(velocity), velocity, history, bdf.alpha[0], momentum);
  }

  template class WallEquations<2>;
  template class WallEquations<3>;
} // namespace semilunar::flow
