// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_mesh_flag_channel_h
#define semilunar_mesh_flag_channel_h

#include <semilunar/mesh/mesh.h>

namespace semilunar::mesh
{
  /// Fill a mesh with the channel of the Turek-Hron benchmarks: a cylinder with a flag of wall
  /// cells behind it (doc/theory/mesh.md). Boundaries: `inlet`, `outlet`, `wall`, `cylinder`, and
  /// `root`, where the flag is fixed to the cylinder.
  void make_flag_channel(Mesh<2> &mesh);

  /// The flag alone. Boundaries: `root` and `sides`.
  void make_flag(Mesh<2> &mesh);
} // namespace semilunar::mesh

#endif
