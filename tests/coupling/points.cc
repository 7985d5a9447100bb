// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Points of a surface in the fluid's mesh: swept through a pipe and over the borders of ranks, none
// is lost; the mesh follows them; a stretching surface gets more, with the forces that it bore.
#include <semilunar/core/exceptions.h>
#include <semilunar/coupling/immersed_points.h>
#include <semilunar/coupling/point_density.h>
#include <semilunar/coupling/refinement_near_points.h>
#include <semilunar/coupling/shell_in_flow.h>
#include <semilunar/mesh/parameters.h>
#include <semilunar/spline/primitives.h>

#include <deal.II/base/mpi.h>
#include <deal.II/fe/mapping_q.h>

#include "../tests.h"

using namespace semilunar;
using tests::check;
using tests::log;

namespace
{
  using Positions = std::vector<dealii::Tensor<1, 3>>;

  bool first_rank()
  {
    return dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  }

  struct Pipe
  {
    Pipe()
    {
      mesh::MeshParameters parameters;
      parameters.shape = mesh::Shape::pipe;
      parameters.pipe = mesh::TubeParameters::pipe(1., 3.);
      parameters.pipe.n_cells_around = 12;
      parameters.pipe.n_cells_along = 12;
      mesh = mesh::make_mesh<3>(parameters, MPI_COMM_WORLD);
    }

    std::unique_ptr<flow::FlowSolver<3>> make_flow()
    {
      flow::BoundaryConditions<3> conditions;
      conditions.set_wall(mesh->boundary_ids.at("wall"));
      for (const char *name : {"inlet", "outlet"})
        conditions.set_open(mesh->boundary_ids.at(name),
                            std::make_shared<flow::PrescribedPressure>([](double) { return 0.; }));
      auto flow = std::make_unique<flow::FlowSolver<3>>(flow::Parameters(), mesh->triangulation,
                                                        dealii::MappingQ<3>(2), conditions, timers);
      flow->initialise(0.,
                       [](const dealii::Point<3> &x, double) {
                         return dealii::Tensor<1, 3>({0., 0., 1. - x[0] * x[0] - x[1] * x[1]});
                       });
      return flow;
    }

    std::unique_ptr<mesh::Mesh<3>> mesh;
    Timers timers;
  };

  /// A tilted square in the pipe, its middle at this height.
  Positions plate(const double z, const unsigned int n)
  {
    Positions x;
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
      {
        const double s = -0.5 + (i + 0.5) / n, t = -0.5 + (j + 0.5) / n;
        x.push_back(dealii::Tensor<1, 3>({s, t + 0.01, z + 0.4 * s + 0.1 * t}));
      }
    return x;
  }

  /// Largest error of the places of all points, each of which one rank has; and how many it has.
  void check_places(const flow::FlowSolver<3> &flow, const coupling::ImmersedPoints &points,
                    const Positions &x, double &error, unsigned int &n_elsewhere)
  {
    const coupling::CellMap map(flow);
    std::vector<unsigned int> owners(x.size(), 0);
    std::vector<bool> is_held(flow.spaces().velocity_dofs().get_triangulation().n_active_cells());
    for (const auto &cell : flow.spaces().velocity_dofs().active_cell_iterators())
      for (const auto &point : points.local())
        if (point.active_cell_index == cell->active_cell_index())
        {
          ++owners[point.q];
          error = std::max(error, (map.position({cell, point.unit_point}) - x[point.q]).norm());
        }
    n_elsewhere += first_rank() ? x.size() - points.local().size() : 0;
    dealii::Utilities::MPI::sum(owners, MPI_COMM_WORLD, owners);
    for (const unsigned int n : owners)
      if (n != 1)
        error = 1.;
    error = dealii::Utilities::MPI::max(error, MPI_COMM_WORLD);
  }

  void sweep()
  {
    Pipe pipe;
    const auto flow = pipe.make_flow();
    constexpr unsigned int n = 24, n_steps = 40;
    coupling::ImmersedPoints points(*flow, plate(-1., n));
    double error = 0.;
    unsigned int n_elsewhere = 0;
    for (unsigned int step = 1; step <= n_steps; ++step)
    {
      const Positions x = plate(-1. + 2. * step / n_steps, n);
      points.move(x);
      check_places(*flow, points, x, error, n_elsewhere);
    }
    std::string message;
    try
    {
      points.move(plate(5., n));
    }
    catch (const NumericsError &lost)
    {
      message = lost.what();
    }
    if (!first_rank())
      return;
    log() << "swept through the pipe: " << points.n_points() << " points" << std::endl;
    check("  error of their places [cm]", error, 1e-10);
    const bool alone = dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1;
    log() << "  other ranks had some: " << ((n_elsewhere > 0) != alone) << std::endl
          << "  out of the pipe: " << (message.find("has left the fluid") != std::string::npos)
          << std::endl;
  }

  void mesh_that_follows()
  {
    Pipe pipe;
    coupling::RefinementParameters parameters;
    parameters.levels = 1;
    parameters.width = 1.;
    constexpr unsigned int n = 24, n_steps = 40;
    coupling::RefinementNearPoints refinement(pipe.mesh->triangulation, parameters, plate(-1., n));
    const auto flow = pipe.make_flow();
    coupling::ImmersedPoints points(*flow, plate(-1., n));
    const unsigned int n_before = pipe.mesh->triangulation.n_global_active_cells();
    double error = 0., flow_error = 0.;
    unsigned int n_elsewhere = 0, n_changes = 0, n_cells = 0;
    const double rate = flow->flow_rate(pipe.mesh->boundary_ids.at("outlet"));
    for (unsigned int step = 1; step <= n_steps; ++step)
    {
      const Positions x = plate(-1. + 2. * step / n_steps, n);
      points.move(x);
      std::vector<unsigned int> cells;
      for (const auto &point : points.local())
        cells.push_back(point.active_cell_index);
      if (refinement.due(step, cells) && refinement.flag(x))
      {
        flow->refine();
        points.search_again(x);
        ++n_changes;
      }
      check_places(*flow, points, x, error, n_elsewhere);
      cells.clear();
      for (const auto &point : points.local())
        cells.push_back(point.active_cell_index);
      if (refinement.due(step, cells))
        error = 1.; // a point next to a cell that is not fine
      n_cells = std::max(n_cells, unsigned(pipe.mesh->triangulation.n_global_active_cells()));
      flow_error = std::max(
          flow_error, std::abs(flow->flow_rate(pipe.mesh->boundary_ids.at("outlet")) / rate - 1.));
    }
    if (!first_rank())
      return;
    log() << "a mesh that follows: " << n_before << " cells, then at most " << n_cells << " and "
          << pipe.mesh->triangulation.n_global_active_cells() << ", changed " << n_changes
          << " times" << std::endl;
    check("  error of places", error, 1e-10);
    check("  flow rate, of curved cells that are divided", flow_error, 1e-4);
  }

  void bounded_mesh()
  {
    Pipe pipe;
    coupling::RefinementParameters parameters;
    parameters.levels = 2;
    parameters.max_cells = 1500;
    const coupling::RefinementNearPoints refinement(pipe.mesh->triangulation, parameters,
                                                    plate(0., 48));
    if (first_rank())
      log() << "bounded by " << parameters.max_cells << ": "
            << pipe.mesh->triangulation.n_global_active_cells() << " cells" << std::endl;
  }

  /// Force of tractions along the normals.
  dealii::Tensor<1, 3> force(const coupling::SurfacePoints &points,
                             const std::vector<double> &traction)
  {
    dealii::Tensor<1, 3> sum;
    for (unsigned int q = 0; q < traction.size(); ++q)
      sum += points.areas[q] * traction[q] * points.normals[q];
    return sum;
  }

  /// Part of a cylinder whose control points move apart along z, and around it more and more.
  void stretching_surface()
  {
    spline::NurbsPatch patch = spline::cylinder(1., 0., 1., 0., 1.);
    patch.elevate_degree(0);
    patch.elevate_degree(1, 2);
    patch.refine_to(0, 4);
    patch.refine_to(1, 4);
    const spline::Surface surface = spline::to_surface(patch);
    const unsigned int n_elements = surface.elements.size();
    constexpr double per_cell = 3., width = 0.2;
    auto gauss = std::make_unique<shell::QuadraturePoints>(surface, 2);
    std::vector<double> traction;
    double force_error = 0., widest = 0.;
    unsigned int n_changes = 0, n_at_first = 0;
    for (unsigned int step = 0; step <= 20; ++step)
    {
      shell::ControlVectors x = spline::positions(surface);
      for (auto &p : x)
      {
        p[2] *= 1. + 0.1 * step * p[2];
        p[0] *= 1. + 0.05 * step;
      }
      const auto numbers =
          coupling::adapted_numbers(*gauss, coupling::surface_points(surface, *gauss, x).positions,
                                    std::vector<double>(n_elements, width), per_cell);
      if (numbers != coupling::point_numbers(*gauss, n_elements))
      {
        auto more = std::make_unique<shell::QuadraturePoints>(surface, numbers);
        if (step > 0)
        {
          const std::vector<double> carried =
              coupling::transfer(traction, *gauss, *more, n_elements);
          const auto before = force(coupling::surface_points(surface, *gauss, x), traction),
                     after = force(coupling::surface_points(surface, *more, x), carried);
          force_error = std::max(force_error, (after - before).norm() / before.norm());
          ++n_changes;
        }
        gauss = std::move(more);
      }
      const coupling::SurfacePoints points = coupling::surface_points(surface, *gauss, x);
      if (step == 0)
        n_at_first = gauss->n_points();
      traction.clear();
      for (const auto &p : points.positions)
        traction.push_back(1e4 * (1. + 0.5 * std::sin(3. * p[2]) * p[0]));
      const auto of_elements = coupling::point_numbers(*gauss, n_elements);
      for (unsigned int e = 0; e < n_elements; ++e)
        for (unsigned int q = gauss->first_point(e); q + 1 < gauss->first_point(e + 1); ++q)
          if ((q + 1 - gauss->first_point(e)) % of_elements[e][0] != 0)
            widest = std::max(widest, (points.positions[q + 1] - points.positions[q]).norm());
    }
    log() << "stretched: from " << n_at_first << " to " << gauss->n_points() << " points, changed "
          << n_changes << " times" << std::endl;
    check("  largest distance beyond half a cell", std::max(widest / width - 0.5, 0.), 0.);
    check("  force, largest error of a change", force_error, 1e-4);
  }

  /// A polynomial is carried exactly, to more points and back to fewer.
  void exact_transfer()
  {
    spline::NurbsPatch patch =
        spline::quadrilateral({{{0., 0., 0.}, {1., 0., 0.}, {0., 1., 0.}, {1., 1., 0.}}});
    const spline::Surface surface = spline::to_surface(patch);
    const shell::QuadraturePoints few(surface, coupling::PointNumbers{{{2, 4}}}),
        many(surface, coupling::PointNumbers{{{5, 6}}});
    const auto polynomial = [](const shell::QuadraturePoints &points)
    {
      std::vector<double> values;
      for (unsigned int q = 0; q < points.n_points(); ++q)
        values.push_back((1. - points.xi(q)[0]) * std::pow(points.xi(q)[1], 3));
      return values;
    };
    const auto difference = [](const std::vector<double> &a, const std::vector<double> &b)
    {
      double largest = 0.;
      for (unsigned int q = 0; q < a.size(); ++q)
        largest = std::max(largest, std::abs(a[q] - b[q]));
      return largest;
    };
    check("polynomial, to more points",
          difference(coupling::transfer(polynomial(few), few, many, 1), polynomial(many)), 1e-14);
    check("polynomial, to fewer points",
          difference(coupling::transfer(polynomial(many), many, few, 1), polynomial(few)), 1e-14);
  }
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  sweep();
  mesh_that_follows();
  bounded_mesh();
  if (!first_rank())
    return 0;
  stretching_surface();
  exact_transfer();
}
