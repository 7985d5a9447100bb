// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_mesh_tube_h
#define semilunar_mesh_tube_h

#include <semilunar/mesh/mesh.h>
#include <semilunar/mesh/tube_parameters.h>

namespace semilunar::mesh
{
  /// Fill a mesh with the cells of a tube. Boundaries: `inlet` (z = begin), `outlet`, and `wall`,
  /// the lumen's surface. Where there are wall cells, the lumen ends at them without a boundary,
  /// and the boundaries of the wall are `outer_wall`, `wall_inlet` and `wall_outlet`.
  /// @throws InputError from TubeParameters::check(section)
  void make_tube(Mesh<3> &mesh, const TubeParameters &tube, const std::string &section);
} // namespace semilunar::mesh

#endif
