// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/core/nearest_name.h>
#include <semilunar/mesh/mesh.h>

#include <set>

namespace semilunar::mesh
{
  template <int dim>
  Mesh<dim>::Mesh(const MPI_Comm communicator)
      : triangulation(communicator,
                      // cells that touch differ by one level at most; further smoothing would make
                      // the mesh depend on how it is divided among ranks
                      dealii::Triangulation<dim>::limit_level_difference_at_vertices,
                      // the order of cells, and with it rounding, depends on the mesh alone and not
                      // on how it came about: a run that is loaded goes on bit for bit
                      dealii::parallel::distributed::Triangulation<
                          dim>::mesh_reconstruction_after_repartitioning)
  {
  }

  template <int dim>
  dealii::types::boundary_id Mesh<dim>::boundary_id(const std::string &name,
                                                    const std::string &where) const
  {
    const auto found = boundary_ids.find(name);
    if (found != boundary_ids.end())
      return found->second;
    std::vector<std::string> names;
    for (const auto &[known, id] : boundary_ids)
      names.push_back(known);
    throw InputError(where, name, "the mesh has no boundary of this name", suggest(name, names));
  }

  template <int dim>
  BoundaryIds Mesh<dim>::lumen_boundary_ids() const
  {
    std::set<dealii::types::boundary_id> ids;
    for (const auto &cell : triangulation.cell_iterators_on_level(0)) // the same on all ranks
      if (cell->material_id() == lumen)
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary())
            ids.insert(face->boundary_id());
    BoundaryIds result;
    for (const auto &[name, id] : boundary_ids)
      if (ids.count(id) > 0)
        result[name] = id;
    return result;
  }

  template class Mesh<2>;
  template class Mesh<3>;
} // namespace semilunar::mesh
