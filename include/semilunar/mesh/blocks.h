// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_mesh_blocks_h
#define semilunar_mesh_blocks_h

#include <semilunar/mesh/mesh.h>

namespace semilunar::mesh
{
  struct BlocksParameters;

  /// Fill a mesh with the cells of rectangular blocks, or those of blocks of a ring
  /// (doc/theory/mesh.md). Boundaries of the lumen: `left`, `right`, `bottom`, `top`, as far as
  /// there are any; of the wall: `wall_left`, ...
  void make_blocks(Mesh<2> &mesh, const BlocksParameters &parameters);
} // namespace semilunar::mesh

#endif
