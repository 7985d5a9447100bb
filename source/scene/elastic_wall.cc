// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/scene/elastic_wall.h>

namespace semilunar::scene
{
  template <int dim>
  void support_wall(const flow::WallParameters &wall, const mesh::Mesh<dim> &mesh,
                    flow::BoundaryConditions<dim> &conditions)
  {
    if (!wall.has_support())
      return;
    std::set<dealii::types::boundary_id> ids;
    for (const std::string &name : wall.supported)
      ids.insert(mesh.boundary_id(name, "Wall/Supported boundaries"));
    conditions.support_wall(ids);
  }

  void check_wall_exists(const flow::WallParameters &wall, const bool exists, Log &log)
  {
    const std::string remedy = "set the wall thickness of the mesh, as Mesh/Artery/Wall thickness";
    if (exists)
      return;
    if (!wall.changed.empty())
      throw InputError("Wall/" + wall.changed, "", "the mesh has no wall that this describes",
                       remedy + ", or leave the section out");
    if (wall.given)
      log.line("section Wall describes nothing: the mesh has no wall; " + remedy);
  }

  template void support_wall(const flow::WallParameters &, const mesh::Mesh<2> &,
                             flow::BoundaryConditions<2> &);
  template void support_wall(const flow::WallParameters &, const mesh::Mesh<3> &,
                             flow::BoundaryConditions<3> &);
} // namespace semilunar::scene
