// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_mesh_cylinder_channel_h
#define semilunar_mesh_cylinder_channel_h

#include <semilunar/mesh/mesh.h>

namespace semilunar::mesh
{
  struct CylinderChannelParameters;

  /// Fill a mesh with the channel of the DFG benchmarks (doc/theory/mesh.md). Boundaries: `inlet`,
  /// `outlet`, `wall` and `cylinder`.
  template <int dim>
  void make_cylinder_channel(Mesh<dim> &mesh, const CylinderChannelParameters &parameters);
} // namespace semilunar::mesh

#endif
