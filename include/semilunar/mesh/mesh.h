// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_mesh_mesh_h
#define semilunar_mesh_mesh_h

#include <deal.II/distributed/tria.h>

#include <map>
#include <string>

namespace semilunar::mesh
{
  /// What a cell consists of: its material id.
  enum Material : dealii::types::material_id
  {
    lumen = 0,
    wall = 1
  };

  /// The ids of the parts of the boundary, by name.
  using BoundaryIds = std::map<std::string, dealii::types::boundary_id>;

  /// The distributed mesh of a flow: cells with manifolds and material ids, and named boundaries.
  template <int dim>
  class Mesh
  {
  public:
    explicit Mesh(MPI_Comm communicator);
    Mesh(const Mesh &) = delete;

    dealii::parallel::distributed::Triangulation<dim> triangulation;
    BoundaryIds boundary_ids;

    /// @param where entry that names the boundary
    /// @throws InputError naming @p where and the names there are
    dealii::types::boundary_id boundary_id(const std::string &name, const std::string &where) const;

    /// The parts of the boundary that cells of the lumen have faces of.
    BoundaryIds lumen_boundary_ids() const;
  };
} // namespace semilunar::mesh

#endif
