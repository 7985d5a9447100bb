// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The artery: its maps against each other and against finite differences, volume and surface
// against closed forms, quality of the cells, refinement against a finer grid, symmetry.
#include <semilunar/core/exceptions.h>
#include <semilunar/mesh/parameters.h>
#include <semilunar/mesh/quality.h>
#include <semilunar/mesh/tube_shape.h>

#include <deal.II/base/mpi.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/grid_tools.h>

#include "../tests.h"

using namespace semilunar;
using dealii::Point;
using mesh::TubeShape;
constexpr double pi = dealii::numbers::PI;

void test_maps(const mesh::TubeParameters &tube)
{
  const TubeShape shape(tube);
  double inverse_error = 0., gradient_error = 0.;
  for (const auto chart : {TubeShape::Chart::core, TubeShape::Chart::shell})
    for (unsigned int i = 0; i < 200; ++i)
    {
      // a low-discrepancy sequence
      const double a = std::fmod(0.5 + i * 0.8191725134, 1.),
                   b = std::fmod(0.1 + i * 0.6710436067, 1.),
                   c = std::fmod(0.2 + i * 0.5497004779, 1.);
      const Point<3> x = chart == TubeShape::Chart::core
                             ? Point<3>(0.8 * (a - 0.5), 0.8 * (b - 0.5), c)
                             : Point<3>(1.8 * a + 0.01, 2. * pi * b, c);
      inverse_error =
          std::max(inverse_error, shape.coordinates(chart, shape.position(chart, x)).distance(x));
      const auto gradient = shape.gradient(chart, x);
      for (unsigned int d = 0; d < 3; ++d)
      {
        const double step = 1e-5;
        Point<3> plus = x, minus = x;
        plus[d] += step;
        minus[d] -= step;
        const auto difference =
            (shape.position(chart, plus) - shape.position(chart, minus)) / (2. * step);
        for (unsigned int i = 0; i < 3; ++i)
          gradient_error = std::max(gradient_error, std::abs(difference[i] - gradient[i][d]));
      }
    }
  tests::check("inverse of the map", inverse_error, 1e-12);
  tests::check("its gradient against differences", gradient_error, 2e-5);
  tests::check("lobe radius", shape.radius(2. * pi / 3., 1.) - 1.95, 1e-14);
  tests::check("commissure radius", shape.radius(pi, 1.) - 1.45, 1e-14);
  tests::check("radius outside of the sinus", shape.radius(0.3, 2.6) - 1.3, 1e-14);
}

void test_mesh(const mesh::MeshParameters &parameters)
{
  const auto mesh = mesh::make_mesh<3>(parameters, MPI_COMM_WORLD);
  const mesh::Quality quality = mesh::measure<3>(mesh->triangulation, dealii::MappingQ<3>(2));
  const double volume = parameters.artery.lumen_volume();
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    tests::log() << parameters.artery.n_cells_around << " cells around, "
                 << mesh->triangulation.n_global_active_cells()
                 << " cells, smallest and mean scaled Jacobian " << quality.min_scaled_jacobian
                 << " " << quality.mean_scaled_jacobian << ", volume error in 1e-6 "
                 << 1e6 * (quality.volume / volume - 1.) << std::endl;
}

/// Vertices of a refined mesh lie where the finer grid has them.
void test_refinement(mesh::MeshParameters parameters)
{
  parameters.artery.n_layers = 4;
  parameters.artery.n_cells_along = 20;
  parameters.artery.n_cells_around = 12;
  const auto fine = mesh::make_mesh<3>(parameters, MPI_COMM_SELF);
  parameters.artery.n_layers = 2;
  parameters.artery.n_cells_along = 10;
  parameters.artery.n_cells_around = 6;
  parameters.refinement.n_global = 1;
  const auto refined = mesh::make_mesh<3>(parameters, MPI_COMM_SELF);
  tests::log() << "vertices: " << fine->triangulation.n_used_vertices() << " "
               << refined->triangulation.n_used_vertices() << std::endl;
  double farthest = 0.;
  const auto &points = fine->triangulation.get_vertices();
  for (const auto &vertex : refined->triangulation.get_vertices())
  {
    double nearest = 1e100;
    for (const auto &point : points)
      nearest = std::min(nearest, vertex.distance(point));
    // the layers divide the angle between two points of the hexagon, not its side
    farthest = std::max(farthest, nearest);
  }
  tests::check("refined mesh against the finer grid", farthest, 0.02);
}

/// Turning by 120 degrees and reflecting in y = 0 map the mesh onto itself.
void test_symmetry(const mesh::Mesh<3> &mesh)
{
  const auto &vertices = mesh.triangulation.get_vertices();
  double turned = 0., reflected = 0.;
  const double c = std::cos(2. * pi / 3.), s = std::sin(2. * pi / 3.);
  for (const auto &p : vertices)
  {
    double nearest_turned = 1e100, nearest_reflected = 1e100;
    for (const auto &q : vertices)
    {
      nearest_turned = std::min(
          nearest_turned, q.distance(Point<3>(c * p[0] - s * p[1], s * p[0] + c * p[1], p[2])));
      nearest_reflected = std::min(nearest_reflected, q.distance(Point<3>(p[0], -p[1], p[2])));
    }
    turned = std::max(turned, nearest_turned);
    reflected = std::max(reflected, nearest_reflected);
  }
  tests::check("turned by a third", turned, 1e-12);
  tests::check("reflected", reflected, 1e-12);
}

double area(const mesh::Mesh<3> &mesh, const std::string &name)
{
  const auto id = mesh.boundary_id(name, "test");
  double area = 0.;
  for (const auto &cell : mesh.triangulation.active_cell_iterators())
    for (const auto &face : cell->face_iterators())
      if (face->at_boundary() && face->boundary_id() == id)
        area += face->measure();
  return area;
}

void test_wall(mesh::MeshParameters parameters)
{
  parameters.artery.n_cells_around = 48;
  parameters.artery.n_cells_along = 40;
  parameters.artery.n_layers = 2;
  parameters.artery.wall_thickness = 0.15;
  const auto mesh = mesh::make_mesh<3>(parameters, MPI_COMM_SELF);
  const mesh::Quality wall =
      mesh::measure<3>(mesh->triangulation, dealii::MappingQ<3>(2), mesh::wall);
  tests::log() << "wall cells " << wall.n_cells << ", smallest scaled Jacobian "
               << wall.min_scaled_jacobian << std::endl;
  const double ring = pi * (1.45 * 1.45 - 1.3 * 1.3);
  tests::check("ends of the wall", area(*mesh, "wall_inlet") / ring - 1., 0.01);
  tests::check("inlet", area(*mesh, "inlet") / (pi * 1.69) - 1., 0.01);
  tests::check("outlet", area(*mesh, "outlet") / (pi * 1.69) - 1., 0.01);
  // a wall of constant thickness h on an area A takes the volume h A + O(h^2)
  const double inner = [&]
  {
    const TubeShape shape(parameters.artery);
    double sum = 0.;
    const unsigned int n_z = 4000, n_theta = 120;
    for (unsigned int i = 0; i < n_z; ++i)
      for (unsigned int j = 0; j < n_theta; ++j)
      {
        const double z = -5. + 16. * (i + 0.5) / n_z, theta = 2. * pi * (j + 0.5) / n_theta;
        const double e = 1e-5, R = shape.radius(theta, z),
                     Rz = (shape.radius(theta, z + e) - shape.radius(theta, z - e)) / (2 * e),
                     Rt = (shape.radius(theta + e, z) - shape.radius(theta - e, z)) / (2 * e);
        sum += std::sqrt(R * R * (1. + Rz * Rz) + Rt * Rt);
      }
    return sum * 16. / n_z * 2. * pi / n_theta;
  }();
  parameters.artery.wall_thickness = 0.001;
  const auto thin = mesh::make_mesh<3>(parameters, MPI_COMM_SELF);
  const double volume =
      mesh::measure<3>(thin->triangulation, dealii::MappingQ<3>(2), mesh::wall).volume;
  tests::check("volume of a thin wall", volume / (0.001 * inner) - 1., 2e-3);
}

int main(int argc, char *argv[])
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  mesh::MeshParameters parameters;
  parameters.shape = mesh::Shape::artery;
  mesh::TubeParameters with_wall = parameters.artery;
  with_wall.wall_thickness = 0.15;
  test_maps(with_wall);
  for (const unsigned int n : {12, 24, 36})
  {
    parameters.artery.n_cells_around = n;
    test_mesh(parameters);
  }
  parameters.artery.n_cells_around = 12;
  test_symmetry(*mesh::make_mesh<3>(parameters, MPI_COMM_SELF));
  test_refinement(parameters);
  test_wall(parameters);
}
