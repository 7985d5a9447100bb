// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Boxes, channels, the DFG channel, files, local refinement: names and sizes of boundaries,
// volumes, quality, messages.
#include <semilunar/core/exceptions.h>
#include <semilunar/mesh/parameters.h>
#include <semilunar/mesh/quality.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/grid_out.h>

#include <iostream>

#include "../tests.h"

using namespace semilunar;

bool first_rank()
{
  return dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
}

template <int dim>
double area(const mesh::Mesh<dim> &mesh, const std::string &name)
{
  const dealii::MappingQ<dim> mapping(3);
  const dealii::FE_Nothing<dim> fe;
  dealii::FEFaceValues<dim> values(mapping, fe, dealii::QGauss<dim - 1>(4),
                                   dealii::update_JxW_values);
  const auto id = mesh.boundary_id(name, "test");
  double sum = 0.;
  for (const auto &cell : mesh.triangulation.active_cell_iterators())
    if (cell->is_locally_owned())
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary() && cell->face(f)->boundary_id() == id)
        {
          values.reinit(cell, f);
          for (const double JxW : values.get_JxW_values())
            sum += JxW;
        }
  return dealii::Utilities::MPI::sum(sum, MPI_COMM_WORLD);
}

template <int dim>
std::unique_ptr<mesh::Mesh<dim>> report(const std::string &name,
                                        const mesh::MeshParameters &parameters)
{
  auto mesh = mesh::make_mesh<dim>(parameters, MPI_COMM_WORLD);
  const mesh::Quality quality = mesh::measure<dim>(mesh->triangulation, dealii::MappingQ<dim>(3));
  if (first_rank())
    tests::log() << name << ": " << mesh::describe(quality) << ", volume " << quality.volume
                 << std::endl;
  for (const auto &[boundary, id] : mesh->boundary_ids)
  {
    const double size = area(*mesh, boundary);
    if (first_rank())
      tests::log() << "  " << boundary << " " << size << std::endl;
  }
  return mesh;
}

void report_solid(const std::string &name, const mesh::MeshParameters &parameters)
{
  const auto mesh = mesh::make_mesh<2>(parameters, MPI_COMM_WORLD);
  const mesh::Quality quality =
      mesh::measure<2>(mesh->triangulation, dealii::MappingQ<2>(3), mesh::wall);
  if (first_rank())
    tests::log() << name << ": " << mesh::describe(quality) << ", volume " << quality.volume
                 << std::endl;
}

void expect_error(const std::string &what, const std::function<void()> &action)
{
  try
  {
    action();
    tests::check(what + ": no error", 1., 0.);
  }
  catch (const InputError &error)
  {
    if (first_rank())
      tests::log() << what << ": " << error.what() << std::endl;
  }
}

void test_file()
{
  mesh::MeshParameters parameters;
  parameters.shape = mesh::Shape::file;
  parameters.file.name = "mesh.msh";
  parameters.file.scale = 0.1;
  if (first_rank())
    std::ofstream("mesh.msh") << "$NOD\n6\n1 0 0 0\n2 10 0 0\n3 20 0 0\n4 0 10 0\n5 10 10 0\n"
                                 "6 20 10 0\n$ENDNOD\n$ELM\n4\n1 1 7 7 2 1 4\n2 1 8 8 2 3 6\n"
                                 "3 3 0 0 4 1 2 5 4\n4 3 0 0 4 2 3 6 5\n$ENDELM\n";
  MPI_Barrier(MPI_COMM_WORLD);
  expect_error("a boundary without a name",
               [&]() { mesh::make_mesh<2>(parameters, MPI_COMM_WORLD); });
  parameters.file.boundaries = {{"walls", 0}, {"entry", 7}, {"exit", 8}};
  const auto mesh = report<2>("file", parameters);
  expect_error("an unknown boundary", [&]() { mesh->boundary_id("entri", "Flow/Inlet"); });
  parameters.file.name = "no-such-mesh.msh";
  expect_error("no file", [&]() { mesh::make_mesh<2>(parameters, MPI_COMM_WORLD); });
}

void test_refinement()
{
  mesh::MeshParameters parameters;
  parameters.refinement.n_global = 1;
  parameters.refinement.n_boxes = 2;
  parameters.refinement.boxes = {{0., 0., 0.3, 0.3}};
  parameters.refinement.n_boundaries = 1;
  parameters.refinement.boundaries = {"top"};
  auto mesh = report<2>("refined box", parameters);
  // indicators that grow with x: cells on the right are refined, up to the bound on levels
  mesh::AdaptivityParameters adaptivity;
  adaptivity.max_level = 2;
  adaptivity.refined_share = 0.3;
  adaptivity.coarsened_share = 0.;
  for (unsigned int i = 0; i < 3; ++i)
  {
    dealii::Vector<float> indicators(mesh->triangulation.n_active_cells());
    for (const auto &cell : mesh->triangulation.active_cell_iterators())
      indicators[cell->active_cell_index()] =
          std::exp(cell->center()[0] + 1e-3 * cell->center()[1]);
    const bool changed = mesh::flag_cells(*mesh, indicators, adaptivity);
    mesh->triangulation.execute_coarsening_and_refinement();
    if (first_rank())
      tests::log() << "adapted: " << changed << " " << mesh->triangulation.n_global_active_cells()
                   << " cells, levels " << mesh->triangulation.n_global_levels() << std::endl;
  }
}

/// The Turek-Hron flag, with the channel and alone, and blocks of two materials.
void test_walls()
{
  mesh::MeshParameters parameters;
  parameters.shape = mesh::Shape::flag_in_channel;
  report<2>("flag in a channel", parameters);
  parameters.shape = mesh::Shape::flag;
  report_solid("flag", parameters);

  parameters.shape = mesh::Shape::blocks;
  auto &blocks = parameters.blocks;
  blocks.x = {0., 1., 3., 4.};
  blocks.n_cells_x = {1, 4, 1};
  blocks.y = {0., 1., 1.25};
  blocks.n_cells_y = {2, 1};
  blocks.materials = "lumen lumen lumen; none wall none";
  report<2>("channel with a wall", parameters);
  report_solid("its wall", parameters);
  blocks.x = {1., 1.5, 2.};
  blocks.n_cells_x = {1, 1};
  blocks.y = {0., 360.};
  blocks.n_cells_y = {12};
  blocks.materials = "wall lumen";
  blocks.polar = true;
  report<2>("ring around a ring", parameters);
  report_solid("that ring", parameters);
  blocks.materials = "wall blood";
  expect_error("an unknown material", [&]() { mesh::make_mesh<2>(parameters, MPI_COMM_WORLD); });
  blocks.materials = "wall";
  expect_error("a block too few", [&]() { mesh::make_mesh<2>(parameters, MPI_COMM_WORLD); });
  blocks.x = {1., 1., 2.};
  expect_error("blocks of no width", [&]() { mesh::make_mesh<2>(parameters, MPI_COMM_WORLD); });
}

int main(int argc, char *argv[])
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  mesh::MeshParameters parameters;
  report<3>("box", parameters);
  parameters.shape = mesh::Shape::channel;
  parameters.box.upper = {4., 1.};
  parameters.box.lower = {0., 0.};
  parameters.box.n_cells = {8, 4};
  report<2>("channel", parameters);
  parameters.shape = mesh::Shape::cylinder_in_channel;
  report<2>("cylinder in a plane channel", parameters);
  report<3>("cylinder in a duct", parameters);
  parameters.shape = mesh::Shape::pipe;
  report<3>("pipe", parameters);
  test_file();
  test_refinement();
  test_walls();
}
