// SPDX-License-Identifier: LGPL-2.1-or-later
// Newton's method and pseudo-transient continuation on small systems with known solutions: rates,
// walls, wells, bounds on steps, and what they leave behind when they fail.

#include <semilunar/shell/newton.h>

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

  Vector at(const double x, const double y)
  {
    return AlgebraicSystem::vector({{x, y}});
  }

  double distance(const Vector &u, const double x, const double y)
  {
    return std::hypot(u[0] - x, u[1] - y);
  }

  /// A circle and a hyperbola that meet in (3, 4).
  AlgebraicSystem circle()
  {
    AlgebraicSystem system;
    system.force = [](const Two &u, double) {
      return Two{{u[0] * u[0] + u[1] * u[1] - 25., u[0] * u[1] - 12.}};
    };
    system.stiffness = [](const Two &u, double) {
      return Matrix{{{{2. * u[0], 2. * u[1]}}, {{u[1], u[0]}}}};
    };
    return system;
  }

  /// Norms of the residual from iteration to iteration, down to rounding.
  std::vector<double> history(const AlgebraicSystem &system)
  {
    std::vector<double> norms = system.norms;
    norms.erase(std::unique(norms.begin(), norms.end()), norms.end());
    while (norms.back() < 1e-12)
      norms.pop_back();
    return norms;
  }

  double observed_order(const std::vector<double> &norms)
  {
    const unsigned int last = norms.size() - 1;
    return std::log(norms[last] / norms[last - 1]) / std::log(norms[last - 1] / norms[last - 2]);
  }

  void check_rate()
  {
    AlgebraicSystem system = circle();
    Vector u = at(2.5, 4.6);
    const IterationResult result = solve_newton(system, 1., u, {1e-14, 30});
    check("Newton, solution", distance(u, 3., 4.), 1e-13);
    check("Newton, order 2", observed_order(history(system)) - 2., 0.2);
    check_true("Newton, one residual per iteration",
               result.converged && system.norms.size() == result.iterations + 1 &&
                   result.failure.empty());
    check("Newton, reported residual", result.residual - system.norms.back(), 0.);
    check_true("nothing to do", solve_newton(system, 1., u, {1e-10, 0}).converged);

    system = circle();
    system.scale = 1e8;
    u = at(2.5, 4.6);
    check_true("tolerance relative to the forces",
               solve_newton(system, 1., u, {1e-6, 30}).iterations == 0);
  }

  /// Stiffness grows from 1 by 30 orders of magnitude or more within the first Newton step.
  void check_wall()
  {
    const double k = 1e3, small = 1e-9;
    AlgebraicSystem system =
        springs([=](const double u) { return u + small * std::expm1(k * u); },
                [=](const double u) { return 1. + small * k * std::exp(k * u); }, {{1., 0.3}});
    Vector u = at(0., 0.);
    check_true("Newton, exponential wall", solve_newton(system, 1., u, {1e-12, 60}).converged);
    // fixed point of u = log(1 + (p - u) / small) / k
    double x = 0., y = 0.;
    for (unsigned int i = 0; i < 100; ++i)
    {
      x = std::log1p((1. - x) / small) / k;
      y = std::log1p((0.3 - y) / small) / k;
    }
    check("Newton, exponential wall, solution", distance(u, x, y), 1e-12);
    u = at(0., 0.);
    check_true("pseudo-transient, exponential wall",
               solve_pseudo_transient(system, 1., u, {1e-12, 500}).converged);
    check("pseudo-transient, exponential wall, solution", distance(u, x, y), 1e-12);

    // not a number beyond 1.1, where the first Newton step leads
    system = springs([](const double u) { return 1. - std::sqrt(1.1 - u) - 0.1 * u; },
                     [](const double u) { return 0.5 / std::sqrt(1.1 - u) - 0.1; }, {{0.7, 0.6}});
    u = at(-3., 0.);
    check_true("Newton, edge of the admissible states",
               solve_newton(system, 1., u, {1e-12, 60}).converged);
    check("Newton, edge of the admissible states, residual", system.norms.back(), 1e-12);
  }

  /// A residual that jumps by 2e-7 at the solution, as rounding makes it.
  void check_noise()
  {
    AlgebraicSystem system = springs([](const double u) { return u + (u < 1. ? -1e-7 : 1e-7); },
                                     [](const double) { return 1.; }, {{1., 1.}});
    Vector u = at(0., 0.);
    check_true("Newton, noise above the tolerance",
               !solve_newton(system, 1., u, {1e-12, 30}).converged);
    system.noise = 1e-6;
    check_true("Newton, noise accepted", solve_newton(system, 1., u, {1e-12, 30}).converged);
    check("Newton, noise accepted, solution", distance(u, 1., 1.), 1e-6);
  }

  using Solver = IterationResult (&)(NonlinearSystem &, double, Vector &,
                                     const IterationParameters &);

  /// A failure with its reason; u must be left where it was.
  void check_failure(const std::string &what, Solver solve, AlgebraicSystem system,
                     const Vector &start, const IterationParameters &parameters,
                     const std::string &reason)
  {
    Vector u = start;
    const IterationResult result = solve(system, 1., u, parameters);
    if (result.failure.find(reason) == std::string::npos)
      std::fprintf(stderr, "%s: %s\n", what.c_str(), result.failure.c_str());
    check_true(what,
               !result.converged && result.failure.find(reason) != std::string::npos && u == start);
  }

  void check_failures()
  {
    const AlgebraicSystem root =
        springs([](const double u) { return std::sqrt(u); },
                [](const double u) { return 0.5 / std::sqrt(u); }, {{1., 1.}});
    check_failure("Newton, not a number", solve_newton, root, at(-1., 1.), {1e-8, 30},
                  "not finite");
    check_failure("pseudo-transient, not a number", solve_pseudo_transient, root, at(-1., 1.),
                  {1e-8, 30}, "no equilibrium after 0");
    // no solution: u^2 + 1 = 0
    const AlgebraicSystem none = springs([](const double u) { return u * u + 2.; },
                                         [](const double u) { return 2. * u; }, {{1., 1.}});
    check_failure("Newton, no solution", solve_newton, none, at(0.7, 0.3), {1e-8, 12},
                  "12 iterations");
    check_failure("pseudo-transient, no solution", solve_pseudo_transient, none, at(0.7, 0.3),
                  {1e-8, 40}, "no equilibrium after");
    check_failure("Newton, singular", solve_newton, none, at(0., 1.), {1e-8, 12}, "singular");
    check_failure("Newton, interrupted", solve_newton, circle(), at(2.5, 4.6),
                  {1e-14, 30, [] { return true; }}, "0 iterations");
    check_failure("pseudo-transient, interrupted", solve_pseudo_transient, circle(), at(2.5, 4.6),
                  {1e-14, 30, [] { return true; }}, "after 0");
  }

  void check_bounded_steps()
  {
    const auto f = [](const double u) { return u + 0.2 * u * u * u; };
    const auto slope = [](const double u) { return 1. + 0.6 * u * u; };
    AlgebraicSystem system = springs(f, slope, {{f(0.25), f(-0.1)}});
    system.limit = 0.3;
    Vector u = at(0., 0.);
    check_true("Newton within its bound", solve_newton(system, 1., u, {1e-12, 60}).converged);
    check("Newton within its bound, solution", distance(u, 0.25, -0.1), 1e-12);

    AlgebraicSystem beyond = springs(f, slope, {{f(0.35), f(-0.1)}});
    beyond.limit = 0.3;
    check_failure("Newton, solution just out of bounds", solve_newton, beyond, at(0., 0.),
                  {1e-12, 60}, "further away");
    AlgebraicSystem far = springs(f, slope, {{f(2.), f(-1.)}});
    far.limit = 0.3;
    check_failure("Newton, solution out of bounds", solve_newton, far, at(0., 0.), {1e-12, 60},
                  "further away");
    u = at(0., 0.);
    check_true("pseudo-transient continuation in bounded steps",
               solve_pseudo_transient(far, 1., u, {1e-12, 200}).converged);
    check("pseudo-transient, solution", distance(u, 2., -1.), 1e-12);
    check("pseudo-transient, largest step", far.largest_step(), 0.3 * (1. + 1e-12));
    const std::vector<double> norms = history(far);
    check("pseudo-transient, the contraction goes to zero with the shift",
          norms.back() / norms[norms.size() - 2], 2e-3);
  }

  /// Potential (x^2 - 1)^2 / 4 + (y - x)^2: wells at (1, 1) and (-1, -1), saddle at the origin.
  AlgebraicSystem two_wells(const double length = 1., const double force = 1.)
  {
    AlgebraicSystem system;
    system.force = [=](const Two &v, double)
    {
      const double x = v[0] / length, y = v[1] / length;
      return Two{{force * (x * x * x - x - 2. * (y - x)), force * 2. * (y - x)}};
    };
    system.stiffness = [=](const Two &v, double)
    {
      const double x = v[0] / length, k = force / length;
      return Matrix{{{{k * (3. * x * x + 1.), -2. * k}}, {{-2. * k, 2. * k}}}};
    };
    system.area = at(length * length, 3. * length * length);
    system.scale = force;
    return system;
  }

  void check_wells()
  {
    AlgebraicSystem system = two_wells();
    Vector u = at(0.1, 0.12);
    solve_newton(system, 1., u, {1e-12, 60});
    check("Newton's method goes to the saddle", distance(u, 0., 0.), 1e-9);
    for (const double side : {1., -1.})
    {
      u = at(0.1 * side, 0.12 * side);
      check_true("pseudo-transient, two wells",
                 solve_pseudo_transient(system, 1., u, {1e-12, 200}).converged);
      check("pseudo-transient continuation goes to the well on its side", distance(u, side, side),
            1e-11);
    }
    // the same wells in micrometres, millimetres, kilometres; in any unit of force
    for (const double length : {1e6, 1e3, 1e-3})
    {
      AlgebraicSystem scaled = two_wells(length, 7. * length);
      Vector first = at(0.1, 0.12), other = at(0.1 * length, 0.12 * length);
      AlgebraicSystem unscaled = two_wells();
      const auto expected = solve_pseudo_transient(unscaled, 1., first, {1e-9, 200}),
                 result = solve_pseudo_transient(scaled, 1., other, {1e-9, 200});
      check_true("pseudo-transient, steps do not depend on units",
                 result.iterations == expected.iterations && result.converged);
    }
  }
} // namespace

int main()
{
  check_rate();
  check_wall();
  check_noise();
  check_failures();
  check_bounded_steps();
  check_wells();
}
