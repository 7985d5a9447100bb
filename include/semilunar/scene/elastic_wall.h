// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_scene_elastic_wall_h
#define semilunar_scene_elastic_wall_h

#include <semilunar/core/log.h>
#include <semilunar/flow/boundary_conditions.h>
#include <semilunar/flow/wall_parameters.h>
#include <semilunar/mesh/mesh.h>

namespace semilunar::scene
{
  /// Tell the conditions about the tissue around an elastic wall, if there is any.
  /// @throws InputError for boundaries that are none
  template <int dim>
  void support_wall(const flow::WallParameters &wall, const mesh::Mesh<dim> &mesh,
                    flow::BoundaryConditions<dim> &conditions);

  /// Section "Wall" describes nothing if the mesh has no wall.
  /// @throws InputError if entries differ from their defaults; says so if they were only written
  void check_wall_exists(const flow::WallParameters &wall, bool exists, Log &log);
} // namespace semilunar::scene

#endif
