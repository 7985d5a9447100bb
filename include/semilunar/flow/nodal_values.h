// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_flow_nodal_values_h
#define semilunar_flow_nodal_values_h

#include <semilunar/flow/cell_forms.h>

#include <deal.II/fe/mapping.h>

namespace semilunar::flow
{
  /// A function at velocity nodes: readable, components interleaved.
  /// @param positions of the nodes, interleaved
  template <int dim>
  Vector nodal_velocities(const Spaces<dim> &spaces, const VectorFunction<dim> &function,
                          const Vector &positions, double time);

  /// A function at pressure nodes. They are not among those of the velocity in general: the mapping
  /// says where they are.
  template <int dim>
  Vector nodal_pressures(const Spaces<dim> &spaces, const dealii::Mapping<dim> &mapping,
                         const std::function<double(const dealii::Point<dim> &, double)> &function,
                         double time);

  /// Where a mapping puts the velocity nodes: readable.
  template <int dim>
  Vector nodal_positions(const Spaces<dim> &spaces, const dealii::Mapping<dim> &mapping);
} // namespace semilunar::flow

#endif
