// SPDX-License-Identifier: LGPL-2.1-or-later
// Decaying vortices of Taylor and Green: second order in time, linear-implicit and with Newton's
// method, equal and changing steps. Beltrami flow of Ethier and Steinman: third order in space.
#include "flow_tests.h"

using namespace semilunar;
using namespace semilunar::tests;

namespace
{
  const double pi = dealii::numbers::PI;

  template <int dim>
  struct ExactFlow
  {
    std::string name;
    double left, viscosity;
    unsigned int degree, level;
    VectorFunction<dim> velocity;
    PressureFunction<dim> pressure;
  };

  ExactFlow<2> taylor_green()
  {
    const double k = 2. * pi, nu = 0.02;
    const auto g = [=](const double t) { return std::exp(-2. * nu * k * k * t); };
    return {"Taylor-Green",
            0.,
            nu,
            3,
            4,
            [=](const Point<2> &x, const double t)
            {
              return g(t) * Tensor<1, 2>({-std::cos(k * x[0]) * std::sin(k * x[1]),
                                          std::sin(k * x[0]) * std::cos(k * x[1])});
            },
            [=](const Point<2> &x, const double t)
            { return -(std::cos(2. * k * x[0]) + std::cos(2. * k * x[1])) * g(t) * g(t) / 4.; }};
  }

  ExactFlow<3> beltrami()
  {
    const double a = pi / 4., d = pi / 2., nu = 0.1;
    const auto f = [=](const double t) { return std::exp(-nu * d * d * t); };
    return {"Beltrami",
            -1.,
            nu,
            2,
            2,
            [=](const Point<3> &x, const double t)
            {
              Tensor<1, 3> u;
              for (unsigned int i = 0; i < 3; ++i)
              {
                const double x1 = x[i], x2 = x[(i + 1) % 3], x3 = x[(i + 2) % 3];
                u[i] = -a * f(t) *
                       (std::exp(a * x1) * std::sin(a * x2 + d * x3) +
                        std::exp(a * x3) * std::cos(a * x1 + d * x2));
              }
              return u;
            },
            [=](const Point<3> &x, const double t)
            {
              double sum = 0.;
              for (unsigned int i = 0; i < 3; ++i)
              {
                const double x1 = x[i], x2 = x[(i + 1) % 3], x3 = x[(i + 2) % 3];
                sum += std::exp(2. * a * x1) + 2. * std::sin(a * x1 + d * x2) *
                                                   std::cos(a * x3 + d * x1) *
                                                   std::exp(a * (x2 + x3));
              }
              return -a * a / 2. * sum * f(t) * f(t);
            }};
  }

  /// Errors at t = 0.4. @param alternate steps of 4/3 and 2/3 dt in turn
  template <int dim>
  Errors solve(const ExactFlow<dim> &exact, const std::string &nonlinear, const double dt,
               const bool alternate)
  {
    Mesh<dim> mesh(MPI_COMM_WORLD);
    dealii::GridGenerator::hyper_cube(mesh, exact.left, 1., true);
    mesh.refine_global(exact.level);
    flow::Parameters prm;
    prm.viscosity = exact.viscosity;
    prm.degree = exact.degree;
    prm.nonlinear = nonlinear;
    prm.linear_tolerance = nonlinear == "linear-implicit" ? 1e-7 : 1e-2;
    prm.nonlinear_tolerance = 1e-7;
    BoundaryConditions<dim> bc;
    for (unsigned int id = 0; id < 2 * dim; ++id)
      bc.set_velocity(id, exact.velocity);
    Timers timers;
    FlowSolver<dim> solver(prm, mesh, dealii::MappingQ<dim>(1), bc, timers);
    solver.initialise(0., exact.velocity, exact.pressure, dt);
    for (unsigned int step = 0; step < std::lround(0.4 / dt); ++step)
      solver.advance(alternate ? (step % 2 == 0 ? 4. : 2.) / 3. * dt : dt);
    return errors_of<dim>(solver, exact.velocity, exact.pressure, true);
  }

  template <int dim>
  void order(const ExactFlow<dim> &exact, const std::string &nonlinear, const double dt,
             const bool alternate = false)
  {
    const Errors coarse = solve(exact, nonlinear, dt, alternate),
                 fine = solve(exact, nonlinear, dt / 2., alternate);
    if (first_rank())
    {
      log() << exact.name << ", " << nonlinear << (alternate ? ", changing steps" : "")
            << std::endl;
      check("  velocity: order in time below 2 by",
            std::max(0., 2. - std::log2(coarse.velocity / fine.velocity)), 0.25);
      if (nonlinear ==
          "linear-implicit") // with Newton's method the error in space is the larger one
        check("  pressure: order in time below 2 by",
              std::max(0., 2. - std::log2(coarse.pressure / fine.pressure)), 0.25);
    }
  }
  template <int dim>
  void order_in_space(ExactFlow<dim> exact, const double dt)
  {
    const Errors coarse = solve(exact, "linear-implicit", dt, false);
    ++exact.level;
    const Errors fine = solve(exact, "linear-implicit", dt, false);
    if (first_rank())
    {
      log() << exact.name << std::endl;
      check("  velocity: order in space below 3 by",
            std::max(0., 3. - std::log2(coarse.velocity / fine.velocity)), 0.25);
      check("  pressure: order in space below 2 by",
            std::max(0., 2. - std::log2(coarse.pressure / fine.pressure)), 0.25);
    }
  }
} // namespace

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const char *scheme : {"linear-implicit", "Newton"})
    order(taylor_green(), scheme, 0.1);
  order(taylor_green(), "linear-implicit", 0.1, true);
  order_in_space(beltrami(), 0.05);
}
