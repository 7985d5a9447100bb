// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/units.h>
#include <semilunar/flow/wall_equations.h>
#include <semilunar/flow/wall_prestress.h>

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
  void WallEquations<dim>::reinit_support(const BoundaryFaces<dim> &faces,
                                          const std::set<dealii::types::boundary_id> &ids,
                                          const Vector &reference)
  {
    support = std::make_unique<WallSupport<dim>>(spaces);
    support->reinit(faces, ids);
    for (Vector *vector : {&rest, &support_values})
      vector->reinit(spaces.velocities());
    rest = reference;
  }

  template <int dim>
  void WallEquations<dim>::balance_pressure(const CellForms<dim> &cells,
                                            const BoundaryFaces<dim> &faces,
                                            const VelocityConstraints<dim> &constraints,
                                            const Vector &reference)
  {
    prestress(spaces, wall_nodes, constraints,
              pressure_load(spaces, wall_nodes, cells, faces, mmHg * prm.prestress), reference, prm,
              *forms);
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
    const Vector &x = positions(velocity);
    forms->add_residual(x, velocity, history, bdf.alpha[0], momentum);
    if (!support)
      return;
    support_values.zero_out_ghost_values();
    support_values.equ(prm.support_stiffness, x);
    support_values.add(-prm.support_stiffness, rest, prm.support_damping, velocity);
    spaces.make_readable_velocity(support_values);
    support->add(1., support_values, momentum);
  }

  template <int dim>
  void WallEquations<dim>::add_jacobian(const Vector &velocity, Vector &momentum) const
  {
    forms->add_jacobian(velocity, momentum);
    if (support)
      support->add(support_impedance(), velocity, momentum);
  }

  template class WallEquations<2>;
  template class WallEquations<3>;
} // namespace semilunar::flow
