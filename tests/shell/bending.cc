// SPDX-License-Identifier: LGPL-2.1-or-later
// From supports and loads to equilibrium: a clamped square plate and a cantilever under small loads
// against plate and beam theory, a cantilever bent far against the elastica, an edge that is moved.

#include <semilunar/shell/equilibrium.h>
#include <semilunar/shell/loads.h>
#include <semilunar/shell/section_parameters.h>
#include <semilunar/shell/static_solver.h>
#include <semilunar/shell/supports.h>

#include "../tests.h"
#include "shell_cases.h"

using namespace semilunar;
using namespace semilunar::shell;
using namespace semilunar::spline;
using namespace semilunar::tests;

namespace
{
  constexpr double youngs_modulus = 2e6;

  struct Case
  {
    Surface surface;
    std::string supports;
    LoadParameters loads;
    double thickness, poisson_ratio;
    unsigned int n_load_steps = 1;
  };

  /// The deformed surface.
  Surface solve(const Case &c)
  {
    SectionParameters parameters;
    parameters.material = "Saint Venant-Kirchhoff";
    parameters.thickness = c.thickness;
    parameters.saint_venant_kirchhoff = {youngs_modulus, c.poisson_ratio};
    const auto section = parameters.make_section();
    const QuadraturePoints points(c.surface);
    const Assembly assembly(c.surface, points, *section,
                            [](const Tensor<1, 3> &, const std::array<Tensor<1, 3>, 2> &) {
                              return std::array<double, 2>{{1., 0.}};
                            });
    const Equations equations = make_equations(c.surface, {c.supports});
    const Vectors forces = dead_forces(c.surface, points, c.loads, 1.);
    Timers timers;
    Equilibrium system(c.surface, points, equations, assembly, c.loads.follower_pressure(), forces,
                       nullptr, timers);
    StaticSolverParameters solver;
    solver.method = "Newton";
    solver.n_load_steps = c.n_load_steps;
    solver.tolerance = 1e-8;
    double load = 0.;
    dealii::Vector<double> u(system.n_unknowns());
    solve_static(system, u, solver,
                 {[&](const LoadStep &step, const dealii::Vector<double> &) { load = step.load; }});
    check("load factor", load - 1., 0.);
    Surface deformed = c.surface;
    const Vectors x = system.positions(u, 1.);
    for (unsigned int i = 0; i < x.size(); ++i)
      deformed.control_points[i].position = Point<3>(x[i]);
    return deformed;
  }

  /// Uniform pressure q on a square of side a: 0.00126531909 q a^4 / D (by Ritz' method with
  /// polynomials).
  double plate_error(const unsigned int n_elements)
  {
    const double a = 2., h = 0.2, nu = 0.3, q = 1.; // deflection h / 1e4
    const double D = youngs_modulus * h * h * h / (12. * (1. - nu * nu));
    LoadParameters loads;
    loads.pressure = q;
    const Surface deformed =
        solve({plate(a, a, {{3, 3}}, {{n_elements, n_elements}}),
               "clamp left; clamp right; clamp bottom; clamp top", loads, h, nu});
    const unsigned int centre = n_elements / 2 * (n_elements + 1); // its corner xi = 0
    const SurfaceJet jet = evaluate(deformed, {centre, {0., 0.}});
    check("centre of the plate", std::hypot(jet[value][0] - a / 2., jet[value][1] - a / 2.), 1e-8);
    return -jet[value][2] / (0.00126531909 * q * std::pow(a, 4) / D) - 1.;
  }

  void check_plate()
  {
    const double coarse = plate_error(4), medium = plate_error(8), fine = plate_error(16);
    check("clamped plate, 4 x 4 elements", coarse, 0.02);
    check("clamped plate, 16 x 16 elements", fine, 1e-5);
    check("clamped plate, order 4", std::log2(coarse / medium) - 4., 0.7);
    check("clamped plate, order 4 again", std::log2(medium / fine) - 4., 0.4);
  }

  void check_cantilever()
  {
    const double L = 3., b = 0.5, h = 0.3, P = 0.1;
    const double EI = youngs_modulus * b * h * h * h / 12.;
    LoadParameters loads;
    loads.edge_loads = "right: (0, 0, " + std::to_string(P / b) + ")";
    const Surface deformed = solve({plate(L, b, {{3, 3}}, {{4, 1}}), "clamp left", loads, h, 0.});
    const SurfaceJet tip = evaluate(deformed, {3, {1., 0.5}});
    const double w = P * L * L * L / (3. * EI), slope = P * L * L / (2. * EI);
    check("cantilever, deflection", tip[value][2] / w - 1., 1e-6);
    check("cantilever, slope", tip[d1][2] / tip[d1][0] / slope - 1., 1e-6);
  }

  struct Tip
  {
    double x, z;
  };

  /// theta'' = -k cos(theta), theta(0) = 0, theta'(1) = 0: Runge-Kutta and bisection of theta'(0).
  Tip elastica(const double k)
  {
    double low = 0., high = k;
    Tip tip{};
    for (unsigned int bisection = 0; bisection < 60; ++bisection)
    {
      std::array<double, 4> y{{0., 0.5 * (low + high), 0., 0.}}; // theta, theta', x, z
      const unsigned int n = 400;
      const auto rate = [k](const std::array<double, 4> &s) {
        return std::array<double, 4>{{s[1], -k * std::cos(s[0]), std::cos(s[0]), std::sin(s[0])}};
      };
      const auto moved =
          [](std::array<double, 4> s, const double dt, const std::array<double, 4> &v)
      {
        for (unsigned int i = 0; i < 4; ++i)
          s[i] += dt * v[i];
        return s;
      };
      for (unsigned int step = 0; step < n; ++step)
      {
        const double dt = 1. / n;
        const auto k1 = rate(y), k2 = rate(moved(y, dt / 2., k1)), k3 = rate(moved(y, dt / 2., k2)),
                   k4 = rate(moved(y, dt, k3));
        for (unsigned int i = 0; i < 4; ++i)
          y[i] += dt / 6. * (k1[i] + 2. * k2[i] + 2. * k3[i] + k4[i]);
      }
      (y[1] > 0. ? high : low) = 0.5 * (low + high);
      tip = {y[2], y[3]};
    }
    return tip;
  }

  void check_elastica()
  {
    const double h = 0.01, b = 0.25, k = 4., EI = youngs_modulus * b * h * h * h / 12.;
    char load[60];
    std::snprintf(load, sizeof(load), "right: (0, 0, %.17g)", k * EI / b);
    LoadParameters loads;
    loads.edge_loads = load;
    const Tip expected = elastica(k);
    check("elastica, published deflections",
          std::hypot(1. - expected.x - 0.329, expected.z - 0.670), 1e-3);
    const Surface deformed =
        solve({plate(1., b, {{3, 3}}, {{16, 1}}), "clamp left", loads, h, 0., 10});
    const Tensor<1, 3> tip = evaluate(deformed, {15, {1., 0.5}})[value];
    check("far bent cantilever", std::hypot(tip[0] - expected.x, tip[2] - expected.z), 1e-4);
  }

  /// Stretched by moved edges: uniform strain, also for an inner point.
  void check_moved_edge()
  {
    const Surface deformed = solve({plate(2., 1., {{3, 2}}, {{3, 2}}),
                                    "fix left xz; fix right z; fix (0, 0, 0) y; move right x 0.3",
                                    {},
                                    0.05,
                                    0.,
                                    2});
    const Tensor<1, 3> point = evaluate(deformed, {1, {0.25, 0.5}})[value];
    check("moved edge",
          (point - Tensor<1, 3>({1.15 * (2. / 3. + 0.25 * 2. / 3.), 0.25, 0.})).norm(), 1e-8);
  }
} // namespace

int main()
{
  check_plate();
  check_cantilever();
  check_elastica();
  check_moved_edge();
}
