// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A rigid disk closes a pipe, tilted and off the grid: it holds a pressure difference, bears the
// force of it, and leaks little, which without the accumulated incompressibility it does not.
#include <semilunar/coupling/fluid_structure.h>
#include <semilunar/mesh/parameters.h>

#include <deal.II/base/mpi.h>
#include <deal.II/fe/mapping_q.h>

#include "../tests.h"

using namespace semilunar;
using tests::check;
using tests::log;

namespace
{
  constexpr double radius = 1., pressure = 1e5, dt = 1e-3, tilt = 0.2;
  constexpr unsigned int n_steps = 60;

  /// A square plate across the pipe; what lies outside takes no part.
  coupling::SurfacePoints disk(const unsigned int n)
  {
    const double half = 1.2, h = 2. * half / n;
    const dealii::Tensor<1, 3> normal({std::sin(tilt), 0., std::cos(tilt)}),
        along({std::cos(tilt), 0., -std::sin(tilt)}), across({0., 1., 0.}),
        centre({0.013, 0.007, 0.031});
    coupling::SurfacePoints points;
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
      {
        const double s = -half + (i + 0.5) * h, t = -half + (j + 0.5) * h;
        points.positions.push_back(centre + s * along + t * across);
        points.normals.push_back(normal);
        points.areas.push_back(h * h);
      }
    return points;
  }

  struct Result
  {
    double leak, force; ///< means of the last steps
    double imbalance;   ///< of the power, largest relative to the dissipation
    unsigned int n_inside;
  };

  Result run(const double incompressibility)
  {
    mesh::MeshParameters mesh_parameters;
    mesh_parameters.shape = mesh::Shape::pipe;
    mesh_parameters.pipe = mesh::TubeParameters::pipe(radius, 3.);
    mesh_parameters.pipe.n_cells_around = 12;
    mesh_parameters.pipe.n_cells_along = 12;
    const auto mesh = mesh::make_mesh<3>(mesh_parameters, MPI_COMM_WORLD);
    const auto id = [&](const char *name) { return mesh->boundary_ids.at(name); };
    flow::BoundaryConditions<3> conditions;
    conditions.set_wall(id("wall"));
    // a pressure that comes smoothly does not ring
    conditions.set_open(id("inlet"), std::make_shared<flow::PrescribedPressure>(
                                         [](const double t)
                                         {
                                           const double s = std::min(1., t / (0.5 * n_steps * dt));
                                           return pressure * s * s * (3. - 2. * s);
                                         }));
    conditions.set_open(id("outlet"),
                        std::make_shared<flow::PrescribedPressure>([](double) { return 0.; }));
    flow::Parameters fluid;
    fluid.linear_tolerance = 1e-3;
    Timers timers;
    flow::FlowSolver<3> solver(fluid, mesh->triangulation, dealii::MappingQ<3>(2), conditions,
                               timers);
    solver.initialise(0.);

    coupling::Parameters parameters;
    parameters.incompressibility = incompressibility;
    const spline::Surface no_surface;
    const shell::QuadraturePoints no_points(no_surface);
    coupling::FluidStructure coupled(solver, {nullptr, no_surface, no_points, 0.}, disk(60),
                                     fluid, parameters, timers);
    Result result{0., 0., 0., coupled.rigid_points()->n_inside()};
    constexpr unsigned int n_last = 10;
    for (unsigned int step = 0; step < n_steps; ++step)
    {
      const coupling::CoupledReport report = coupled.advance(dt);
      result.imbalance = std::max(result.imbalance, std::abs(report.power.imbalance()) /
                                                        std::abs(report.power.dissipation));
      if (step < n_steps - n_last)
        continue;
      result.leak += report.flow.flow_rate.at(id("outlet")) / n_last;
      result.force += report.force_on_rigid[2] / n_last;
    }
    return result;
  }
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const Result result = run(0.4), plain = run(0.);
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    return 0;
  // An ellipse of the pipe's radius, seen along its tilted normal.
  const double area = dealii::numbers::PI * radius * radius / std::cos(tilt);
  check("area that the points in the pipe stand for",
        result.n_inside * std::pow(2.4 / 60., 2) / area - 1., 0.02);
  check("force along the pipe, relative",
        result.force / (pressure * dealii::numbers::PI * radius * radius) - 1., 0.05);
  check("leak [cm^3/s]", result.leak, 1.);
  check("power across the interface", result.imbalance, 1e-10);
  log() << "without accumulated incompressibility the leak is more than 50 times as large: "
        << (std::abs(plain.leak) > 50. * std::abs(result.leak)) << std::endl;
}
