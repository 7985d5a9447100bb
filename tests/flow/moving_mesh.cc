// SPDX-License-Identifier: LGPL-2.1-or-later
// Exact flows on meshes that move: free stream, breathing cylinder, piston; with hanging nodes.
#include "flow_tests.h"

#include <deal.II/grid/grid_tools.h>

using namespace semilunar;
using namespace semilunar::tests;

namespace
{
  const double pi = dealii::numbers::PI;

  /// Errors must fall with the square of the time step.
  void check_second_order(const std::string &what, const double coarse, const double fine)
  {
    if (first_rank())
      check(what + ": order in time below 2 by", std::max(0., 2. - std::log2(coarse / fine)), 0.3);
  }

  /// Refine the cells in a corner once more than others.
  template <int dim>
  void refine_corner(Mesh<dim> &mesh)
  {
    for (const auto &cell : mesh.active_cell_iterators())
      if (cell->is_locally_owned() && cell->center().norm() < 0.6)
        cell->set_refine_flag();
    mesh.execute_coarsening_and_refinement();
  }

  flow::Parameters tight()
  {
    flow::Parameters prm;
    prm.nonlinear = "Newton";
    prm.linear_tolerance = 1e-4;
    prm.nonlinear_tolerance = 1e-11;
    return prm;
  }

  template <int dim>
  void free_stream(const std::string &scheme)
  {
    Mesh<dim> mesh(MPI_COMM_WORLD);
    dealii::GridGenerator::hyper_cube(mesh, 0., 1., true);
    mesh.refine_global(dim == 2 ? 3 : 2);
    refine_corner(mesh);
    flow::Parameters prm = tight();
    prm.nonlinear = scheme;
    if (scheme == "linear-implicit")
      prm.linear_tolerance = 1e-12;
    Tensor<1, dim> stream;
    for (unsigned int c = 0; c < dim; ++c)
      stream[c] = 1. + 0.5 * c;
    const VectorFunction<dim> u = [=](const Point<dim> &, double) { return stream; };
    BoundaryConditions<dim> bc;
    for (unsigned int id = 0; id < 2 * dim - 1; ++id)
      bc.set_velocity(id, u);
    bc.set_open(2 * dim - 1, std::make_shared<PrescribedPressure>([](double) { return 3.; }));
    Timers timers;
    FlowSolver<dim> solver(prm, mesh, dealii::MappingQ<dim>(2), bc, timers);
    solver.set_mesh_motion(
        [](const Point<dim> &x, const double t)
        {
          double bump = 0.08 * std::sin(2. * pi * t);
          for (unsigned int d = 0; d < dim; ++d)
            bump *= std::sin(2. * pi * x[d]);
          Tensor<1, dim> moved = x;
          for (unsigned int c = 0; c < dim; ++c)
            moved[c] += bump;
          return moved;
        });
    solver.initialise(0., u); // the pressure has to be found
    const double steps[] = {0.05, 0.1, 0.03, 0.15};
    for (const double dt : steps)
      solver.advance(dt);
    const Errors e = errors_of<dim>(
        solver, u, [](const Point<dim> &, double) { return 3.; }, false);
    if (first_rank())
    {
      log() << "free stream, " << dim << "D, " << scheme << std::endl;
      check("  velocity error", e.velocity, 1e-10);
      check("  pressure error", e.pressure, 1e-9);
    }
  }

  /// (error of velocity, error of pressure) at t = 0.2.
  Errors breathing_cylinder(const unsigned int level, const double dt, const bool tractions)
  {
    const double A = 0.2, w = 2. * pi, mu = 0.1;
    const auto R = [=](const double t) { return 1. + A * std::sin(w * t); };
    const auto alpha = [=](const double t) { return A * w * std::cos(w * t) / R(t); };
    const auto alpha_rate = [=](const double t)
    { return -A * w * w * std::sin(w * t) / R(t) - alpha(t) * alpha(t); };
    const VectorFunction<3> u = [=](const Point<3> &x, const double t) {
      return alpha(t) * Tensor<1, 3>({x[0], x[1], -2. * x[2]});
    };
    const PressureFunction<3> p = [=](const Point<3> &x, const double t)
    {
      const double a = alpha(t), rate = alpha_rate(t);
      return -((rate + a * a) * (x[0] * x[0] + x[1] * x[1]) / 2. +
               (2. * a * a - rate) * x[2] * x[2]);
    };
    Mesh<3> mesh(MPI_COMM_WORLD);
    dealii::GridGenerator::cylinder(mesh, 1., 0.5);
    dealii::GridTools::transform([](const Point<3> &x) { return Point<3>(-x[2], x[1], x[0]); },
                                 mesh);
    mesh.reset_all_manifolds();
    mesh.refine_global(level);
    flow::Parameters prm = tight();
    prm.viscosity = mu;
    prm.degree = 3;
    BoundaryConditions<3> bc;
    bc.set_velocity(0, u);
    for (const unsigned int id : {1, 2})
      if (tractions)
        bc.set_traction(
            id,
            [=](const Point<3> &x, const Tensor<1, 3> &n, const double t)
            {
              const double a = alpha(t);
              return -p(x, t) * n + 2. * mu * a * Tensor<1, 3>({n[0], n[1], -2. * n[2]});
            });
      else
        bc.set_velocity(id, u);
    Timers timers;
    FlowSolver<3> solver(prm, mesh, dealii::MappingQ<3>(3), bc, timers);
    solver.set_mesh_motion(
        [=](const Point<3> &x, const double t) {
          return Tensor<1, 3>({x[0] * R(t), x[1] * R(t), x[2]});
        });
    solver.initialise(0., u, p, dt);
    for (unsigned int step = 0; step < std::lround(0.2 / dt); ++step)
      solver.advance(dt);
    return errors_of<3>(solver, u, p, !tractions);
  }

  /// A slip channel behind a piston at x0(t) = A sin wt, traction-free at the other end.
  template <int dim>
  Errors piston(const double dt)
  {
    const double A = 0.1, w = 2. * pi, L = 1.;
    const VectorFunction<dim> u = [=](const Point<dim> &, const double t)
    { return A * w * std::cos(w * t) * Point<dim>::unit_vector(0); };
    const PressureFunction<dim> p = [=](const Point<dim> &x, const double t)
    { return -A * w * w * std::sin(w * t) * (L - x[0]); };
    Mesh<dim> mesh(MPI_COMM_WORLD);
    dealii::GridGenerator::hyper_cube(mesh, 0., L, true);
    mesh.refine_global(2);
    flow::Parameters prm = tight();
    BoundaryConditions<dim> bc;
    bc.set_wall(0);
    bc.set_traction(1, [](const Point<dim> &, const Tensor<1, dim> &, double)
                    { return Tensor<1, dim>(); });
    for (unsigned int id = 2; id < 2 * dim; ++id)
      bc.set_slip(id);
    Timers timers;
    FlowSolver<dim> solver(prm, mesh, dealii::MappingQ<dim>(2), bc, timers);
    solver.set_mesh_motion(
        [=](const Point<dim> &x, const double t)
        {
          Tensor<1, dim> moved = x;
          moved[0] += A * std::sin(w * t) * (1. - x[0] / L);
          return moved;
        });
    solver.initialise(0., u, p, dt);
    for (unsigned int step = 0; step < std::lround(0.3 / dt); ++step)
      solver.advance(dt);
    return errors_of<dim>(solver, u, p, false);
  }
} // namespace

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const char *scheme : {"linear-implicit", "Newton", "Picard"})
  {
    free_stream<2>(scheme);
    free_stream<3>(scheme);
  }
  {
    const Errors coarse = piston<2>(0.02), fine = piston<2>(0.01), solid = piston<3>(0.02);
    check_second_order("piston, velocity", coarse.velocity, fine.velocity);
    check_second_order("piston, pressure", coarse.pressure, fine.pressure);
    if (first_rank())
      check("piston: 3D differs from 2D", solid.velocity / coarse.velocity - 1., 1e-6);
  }
  for (const bool tractions : {false, true})
  {
    const Errors coarse = breathing_cylinder(0, 0.02, tractions),
                 fine = breathing_cylinder(0, 0.01, tractions);
    if (first_rank())
      log() << "breathing cylinder, " << (tractions ? "tractions" : "velocities") << " at the ends"
            << std::endl;
    check_second_order("  pressure", coarse.pressure, fine.pressure);
    if (tractions)
      check_second_order("  velocity", coarse.velocity, fine.velocity);
    else if (first_rank())
      check("  velocity error", fine.velocity, 1e-10);
  }
}
