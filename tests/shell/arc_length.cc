// SPDX-License-Identifier: LGPL-2.1-or-later
// The arc-length method through limit points: a cubic path and the von Mises truss, both in closed
// form; exactly singular states; paths that never get to the full load.

#include <semilunar/shell/static_solver.h>

#include <algorithm>

#include "../tests.h"
#include "algebraic_system.h"

using namespace semilunar;
using namespace semilunar::shell;
using namespace semilunar::tests;

namespace
{
  using Vector = NonlinearSystem::Vector;
  using Two = AlgebraicSystem::Two;
  using Matrix = std::array<Two, 2>;

  void check_true(const std::string &what, const bool holds)
  {
    check(what, holds ? 0. : 1., 0.);
  }

  struct Path
  {
    std::vector<double> loads;
    std::vector<Two> states;
    std::string error;

    Path(AlgebraicSystem &system, const unsigned int n_load_steps, const unsigned int max_steps)
    {
      StaticSolverParameters p;
      p.method = "arc length";
      p.n_load_steps = n_load_steps;
      p.max_arc_steps = max_steps;
      p.tolerance = 1e-11;
      Vector u(2);
      const StaticSolverHooks hooks{[&](const LoadStep &step, const Vector &state)
                                    {
                                      loads.push_back(step.load);
                                      states.push_back(AlgebraicSystem::components(state));
                                    },
                                    [] { return false; }};
      try
      {
        solve_static(system, u, p, hooks);
      }
      catch (const NumericsError &e)
      {
        error = e.what();
      }
    }
    /// The load factor at the first state after which the path goes down (1), or up again (-1).
    double turning_point(const double sign) const
    {
      for (unsigned int k = 1; k + 1 < loads.size(); ++k)
        if (sign * (loads[k] - loads[k - 1]) > 0. && sign * (loads[k + 1] - loads[k]) < 0.)
          return loads[k];
      return std::nan("");
    }
  };

  /// A load-carrying formula load(v) for the first coordinate in a frame turned by an angle; the
  /// second coordinate has a spring of its own and no load.
  AlgebraicSystem turned(const std::function<double(double)> &f,
                         const std::function<double(double)> &slope, const double angle)
  {
    const double c = std::cos(angle), s = std::sin(angle);
    AlgebraicSystem system;
    system.force = [=](const Two &u, const double load)
    {
      const double along = f(c * u[0] + s * u[1]) - load, across = 2. * (c * u[1] - s * u[0]);
      return Two{{c * along - s * across, s * along + c * across}};
    };
    system.stiffness = [=](const Two &u, double)
    {
      const double k = slope(c * u[0] + s * u[1]);
      return Matrix{{{{c * c * k + 2. * s * s, c * s * (k - 2.)}},
                     {{c * s * (k - 2.), s * s * k + 2. * c * c}}}};
    };
    system.force_by_load = [=](const Two &, double) { return Two{{-c, -s}}; };
    return system;
  }

  /// (y^3 - 1.5 y - 0.5) / 0.625, y = v - 1: from 0 at v = 0 to 1 at v = 2.5, between them limit
  /// points at v = 1 -+ 1/sqrt(2) with the loads (-0.5 +- 1/sqrt(2)) / 0.625.
  double cubic(const double v)
  {
    return (std::pow(v - 1., 3) - 1.5 * (v - 1.) - 0.5) / 0.625;
  }
  double cubic_slope(const double v)
  {
    return (3. * (v - 1.) * (v - 1.) - 1.5) / 0.625;
  }

  void check_cubic()
  {
    for (const double angle : {0., 0.5})
    {
      AlgebraicSystem system = turned(cubic, cubic_slope, angle);
      const Path path(system, 60, 500);
      double error = 0., previous = 0.;
      bool forward = true;
      for (unsigned int k = 0; k < path.loads.size(); ++k)
      {
        const Two &u = path.states[k];
        const double v = std::cos(angle) * u[0] + std::sin(angle) * u[1];
        error = std::max({error, std::abs(cubic(v) - path.loads[k]),
                          std::abs(std::cos(angle) * u[1] - std::sin(angle) * u[0])});
        forward = forward && v > previous;
        previous = v;
      }
      const std::string name = angle == 0. ? "cubic path" : "cubic path, turned";
      check_true(name + ", no error", path.error.empty());
      check(name + ", states on the path", error, 1e-10);
      check_true(name + ", never back", forward);
      check(name + ", load at its end", path.loads.back() - 1., 0.);
      check(name + ", end", previous - 2.5, 1e-10);
      check(name + ", first limit load", path.turning_point(1.) - 0.33137085, 0.03);
      check(name + ", second limit load", path.turning_point(-1.) + 1.93137085, 0.03);
      check_true(name + ", every state accepted", system.accepted == path.loads);
    }
  }

  constexpr double span = 1., height = 0.2, reference_load = 0.01;

  /// Two bars between (-+span, 0) and the apex (0, height), Green strain, EA = 1: energy of a bar
  /// L0 E^2 / 2; unknowns are the apex' displacements to the right and down, the load acts down.
  AlgebraicSystem truss()
  {
    constexpr double L0_square = span * span + height * height;
    const double L0 = std::sqrt(L0_square);
    AlgebraicSystem system;
    system.force = [=](const Two &u, const double load)
    {
      Two r{{0., -load * reference_load}};
      for (const double side : {-1., 1.})
      {
        const double dx = u[0] - side * span, dy = u[1] - height;
        const double E = (dx * dx + dy * dy - L0_square) / (2. * L0_square);
        r[0] += E * dx / L0;
        r[1] += E * dy / L0;
      }
      return r;
    };
    system.stiffness = [=](const Two &u, double)
    {
      Matrix K{};
      for (const double side : {-1., 1.})
      {
        const Two d{{u[0] - side * span, u[1] - height}};
        const double E = (d[0] * d[0] + d[1] * d[1] - L0_square) / (2. * L0_square);
        for (unsigned int i = 0; i < 2; ++i)
          for (unsigned int j = 0; j < 2; ++j)
            K[i][j] += d[i] * d[j] / (L0 * L0_square) + (i == j ? E / L0 : 0.);
      }
      return K;
    };
    system.force_by_load = [](const Two &, double) { return Two{{0., -reference_load}}; };
    system.scale = reference_load;
    return system;
  }

  void check_truss()
  {
    AlgebraicSystem system = truss();
    const Path path(system, 100, 500);
    const double L0 = std::sqrt(span * span + height * height);
    double error = 0., furthest = 0.;
    for (unsigned int k = 0; k < path.loads.size(); ++k)
    {
      const double v = path.states[k][1];
      const double load = v * (v - height) * (v - 2. * height) / std::pow(L0, 3) / reference_load;
      error = std::max({error, std::abs(load - path.loads[k]), std::abs(path.states[k][0])});
      furthest = std::max(furthest, v);
    }
    check("truss, states on the path", error, 1e-9);
    check("truss, load at its end", path.loads.back() - 1., 0.);
    check("truss, end of the path", path.states.back()[1] - furthest, 0.);
    // v = height (1 -+ 1/sqrt(3))
    const double limit =
        2. * std::pow(height, 3) / (3. * std::sqrt(3.)) / std::pow(L0, 3) / reference_load;
    check("truss, snap-through load", path.turning_point(1.) / limit - 1., 0.1);
    check("truss, snap-back load", path.turning_point(-1.) / limit + 1., 0.1);
  }

  /// The first step leads to the limit point itself, where the tangent is singular.
  void check_singular()
  {
    const auto f = [](const double u) { return u - 2. / 3. * u * u + u * u * u / 9.; };
    AlgebraicSystem system = turned(
        f, [](const double u) { return (1. - u) * (1. - u / 3.); }, 0.);
    const Path path(system, 1, 500);
    check_true("singular tangent, no error", path.error.empty());
    check("singular tangent, end of the path", f(path.states.back()[0]) - 1., 1e-11);
  }

  void check_giving_up()
  {
    // falls for ever after its limit point
    AlgebraicSystem system = turned([](const double u) { return u * (1. - u); },
                                    [](const double u) { return 1. - 2. * u; }, 0.3);
    const Path path(system, 10, 30);
    const std::size_t place = path.error.find("load factor ");
    check_true("falling path, message",
               path.error.find("within the allowed number") != std::string::npos &&
                   place != std::string::npos);
    check("falling path, load factor in the message",
          std::stod(path.error.substr(place + 12)) - path.loads.back(), 1e-5);
    check_true("falling path, steps", path.loads.size() == 30 && path.loads.back() < -1.);

    // ends: no equilibrium with u > 0.5
    AlgebraicSystem wall = turned([](const double u) { return u < 0.5 ? u : std::nan(""); },
                                  [](const double) { return 1.; }, 0.3);
    const Path end(wall, 10, 500);
    check_true("path with an end, message",
               end.error.find("fell below its bound at load factor 0.5") != std::string::npos ||
                   end.error.find("fell below its bound at load factor 0.49") != std::string::npos);
    check("path with an end, last load", end.loads.back() - 0.5, 1e-5);
  }
} // namespace

int main()
{
  check_cubic();
  check_truss();
  check_singular();
  check_giving_up();
}
