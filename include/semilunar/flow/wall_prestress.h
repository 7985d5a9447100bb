// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_flow_wall_prestress_h
#define semilunar_flow_wall_prestress_h

#include <semilunar/flow/boundary_faces.h>
#include <semilunar/flow/velocity_constraints.h>
#include <semilunar/flow/wall_forms.h>
#include <semilunar/flow/wall_nodes.h>

namespace semilunar::flow
{
  /// Forces of a uniform pressure of the blood on the nodes of the wall, zero elsewhere:
  /// equation (P2) of doc/theory/wall.md. Collective.
  /// @param faces, cells with the geometry at rest
  template <int dim>
  Vector pressure_load(const Spaces<dim> &spaces, const WallNodes<dim> &nodes,
                       const CellForms<dim> &cells, const BoundaryFaces<dim> &faces,
                       double pressure);

  /// Give the wall the stress (P3) that balances these forces at rest. Collective.
  /// @param constraints of the wall at rest
  /// @throws NumericsError if that does not converge
  template <int dim>
  void prestress(const Spaces<dim> &spaces, const WallNodes<dim> &nodes,
                 const VelocityConstraints<dim> &constraints, Vector load, const Vector &reference,
                 const WallParameters &prm, WallForms<dim> &forms);
} // namespace semilunar::flow

#endif
