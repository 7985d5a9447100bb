// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/mesh/blocks.h>
#include <semilunar/mesh/cylinder_channel.h>
#include <semilunar/mesh/flag_channel.h>
#include <semilunar/mesh/parameters.h>
#include <semilunar/mesh/tube.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_in.h>
#include <deal.II/grid/grid_tools.h>

#include <set>

namespace semilunar::mesh
{
  namespace
  {
    /// Its faces have the ids 0 ... 2 dim - 1, in pairs for each direction.
    template <int dim>
    void make_box(Mesh<dim> &mesh, const BoxParameters &box)
    {
      dealii::Point<dim> lower, upper;
      for (unsigned int d = 0; d < dim; ++d)
      {
        lower[d] = box.lower[d];
        upper[d] = box.upper[d];
      }
      const std::vector<unsigned int> n_cells(box.n_cells.begin(), box.n_cells.begin() + dim);
      dealii::GridGenerator::subdivided_hyper_rectangle(mesh.triangulation, n_cells, lower, upper,
                                                        true);
      mesh.boundary_ids = {{"left", 0}, {"right", 1}, {"bottom", 2}, {"top", 3}};
      if (dim == 3)
        mesh.boundary_ids.insert({{"back", 4}, {"front", 5}});
    }

    /// Material ids that a generator or a file has set mean nothing here.
    template <int dim>
    void fill_with_lumen(Mesh<dim> &mesh)
    {
      for (const auto &cell : mesh.triangulation.cell_iterators_on_level(0))
        cell->set_material_id(lumen);
    }

    template <int dim>
    void make_channel(Mesh<dim> &mesh, const BoxParameters &box)
    {
      make_box(mesh, box);
      mesh.boundary_ids = {{"inlet", 0}, {"outlet", 1}, {"wall", 2}};
      for (const auto &cell : mesh.triangulation.cell_iterators_on_level(0))
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() && face->boundary_id() > 2)
            face->set_boundary_id(2);
    }

    template <int dim>
    void check_boundaries(const Mesh<dim> &mesh, const FileParameters &file)
    {
      std::set<dealii::types::boundary_id> named;
      for (const auto &[name, id] : file.boundaries)
        named.insert(id);
      for (const dealii::types::boundary_id id : mesh.triangulation.get_boundary_ids())
        if (named.count(id) == 0)
          throw InputError("Mesh/File/Boundaries", "",
                           "the boundary id " + std::to_string(id) + " of " + file.name +
                               " has no name",
                           "add 'NAME: " + std::to_string(id) + "'");
    }

    template <int dim>
    void read_file(Mesh<dim> &mesh, const FileParameters &file)
    {
      try
      {
        dealii::GridIn<dim> reader(mesh.triangulation);
        reader.read(file.name);
      }
      catch (const dealii::ExceptionBase &error)
      {
        throw InputError("Mesh/File/Name", file.name, "the mesh cannot be read",
                         "check the file: " + std::string(error.get_exc_name()));
      }
      if (file.scale != 1.)
        dealii::GridTools::scale(file.scale, mesh.triangulation);
      mesh.boundary_ids = file.boundaries;
      check_boundaries(mesh, file);
    }

    // What MeshParameters::check() refuses.
    void make_flag_channel(Mesh<3> &)
    {
      AssertThrow(false, dealii::ExcInternalError());
    }

    void make_flag(Mesh<3> &)
    {
      AssertThrow(false, dealii::ExcInternalError());
    }

    void make_blocks(Mesh<3> &, const BlocksParameters &)
    {
      AssertThrow(false, dealii::ExcInternalError());
    }

    void make_tube(Mesh<2> &, const TubeParameters &, const std::string &)
    {
      AssertThrow(false, dealii::ExcInternalError());
    }

    /// Whether the mesh has cells of walls.
    bool has_materials(const Shape shape)
    {
      return shape == Shape::pipe || shape == Shape::artery || shape == Shape::flag_in_channel ||
             shape == Shape::flag || shape == Shape::blocks;
    }
  } // namespace

  template <int dim>
  std::unique_ptr<Mesh<dim>> make_mesh(const MeshParameters &parameters,
                                       const MPI_Comm communicator)
  {
    parameters.check(dim);
    auto mesh = std::make_unique<Mesh<dim>>(communicator);
    switch (parameters.shape)
    {
    case Shape::box:
      make_box(*mesh, parameters.box);
      break;
    case Shape::channel:
      make_channel(*mesh, parameters.box);
      break;
    case Shape::cylinder_in_channel:
      make_cylinder_channel(*mesh, parameters.cylinder);
      break;
    case Shape::flag_in_channel:
      make_flag_channel(*mesh);
      break;
    case Shape::flag:
      make_flag(*mesh);
      break;
    case Shape::blocks:
      make_blocks(*mesh, parameters.blocks);
      break;
    case Shape::pipe:
      make_tube(*mesh, parameters.pipe, "Mesh/Pipe");
      break;
    case Shape::artery:
      make_tube(*mesh, parameters.artery, "Mesh/Artery");
      break;
    case Shape::file:
      read_file(*mesh, parameters.file);
      break;
    }
    if (!has_materials(parameters.shape))
      fill_with_lumen(*mesh);
    refine(*mesh, parameters.refinement);
    return mesh;
  }

  template std::unique_ptr<Mesh<2>> make_mesh(const MeshParameters &, MPI_Comm);
  template std::unique_ptr<Mesh<3>> make_mesh(const MeshParameters &, MPI_Comm);
} // namespace semilunar::mesh
