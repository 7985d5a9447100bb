// SPDX-License-Identifier: LGPL-2.1-or-later
// The load path: steps that grow and are cut back, the end at the load itself, snap-through, and
// what is left when the solver gives up or is interrupted.

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

  void check_true(const std::string &what, const bool holds)
  {
    check(what, holds ? 0. : 1., 0.);
  }

  /// Runs the solver and keeps what it reports.
  struct Run
  {
    std::vector<LoadStep> steps;
    std::vector<Vector> states;
    Vector u = Vector(2);
    unsigned int iterations = 0;
    std::string error;

    Run(AlgebraicSystem &system, const StaticSolverParameters &parameters,
        const unsigned int interrupt_after = 1000)
    {
      const StaticSolverHooks hooks{[&](const LoadStep &step, const Vector &state)
                                    {
                                      steps.push_back(step);
                                      states.push_back(state);
                                    },
                                    [&] { return steps.size() >= interrupt_after; }};
      try
      {
        iterations = solve_static(system, u, parameters, hooks);
      }
      catch (const NumericsError &e)
      {
        error = e.what();
      }
    }
    double last_load() const { return steps.empty() ? 0. : steps.back().load; }
    double change(const unsigned int k) const
    {
      return steps[k].load - (k == 0 ? 0. : steps[k - 1].load);
    }
  };

  StaticSolverParameters parameters(const unsigned int n_load_steps, const double smallest = 1e-4,
                                    const std::string &method = "Newton")
  {
    StaticSolverParameters p;
    p.n_load_steps = n_load_steps;
    p.smallest_load_step = smallest;
    p.method = method;
    p.tolerance = 1e-12;
    return p;
  }

  /// Hardening springs f(u) = u + u^3.
  double f(const double u)
  {
    return u + u * u * u;
  }
  double slope(const double u)
  {
    return 1. + 3. * u * u;
  }

  void check_full_load()
  {
    for (const unsigned int n : {1, 3, 7, 10, 49})
    {
      AlgebraicSystem system = springs(f, slope, {{f(2.), f(-0.5)}});
      const Run run(system, parameters(n));
      const std::string name = std::to_string(n) + " load steps";
      check(name + ", load factor exactly 1", run.last_load() - 1., 0.);
      check(name + ", solution", std::hypot(run.u[0] - 2., run.u[1] + 0.5), 1e-12);
      check(name + ", first step", run.change(0) - 1. / n, 1e-15);
      bool grows = true, numbered = true;
      unsigned int sum = 0;
      for (unsigned int k = 0; k < run.steps.size(); ++k)
      {
        // all but the last, which is what remains
        grows = grows &&
                (k == 0 || k + 1 == run.steps.size() ||
                 (run.change(k) > run.change(k - 1) && run.change(k) < 1.6 * run.change(k - 1)));
        numbered = numbered && run.steps[k].number == k + 1 && run.steps[k].residual <= 1e-12;
        sum += run.steps[k].iterations;
      }
      check_true(name + ", steps grow", grows && numbered);
      check_true(name + ", counts",
                 sum == run.iterations && system.accepted.size() == run.steps.size());
    }
    // a stiffness that is too large makes every step slow: ten equal ones, whose sum is not quite 1
    AlgebraicSystem slow =
        springs(f, [](const double u) { return 1.2 * slope(u); }, {{f(2.), f(-0.5)}});
    const Run equal_steps(slow, parameters(10));
    check_true("slow steps do not grow", equal_steps.steps.size() == 10);
    check("slow steps, load factor exactly 1", equal_steps.last_load() - 1., 0.);
    // 0.2 + 0.3 + 0.45: what remains is less than the smallest step
    AlgebraicSystem system = springs(f, slope, {{f(2.), f(-0.5)}});
    const Run run(system, parameters(5, 0.1));
    check_true("a last step below the smallest one", run.error.empty());
    check("a last step below the smallest one, load factor", run.last_load() - 1., 0.);
    // the user's own step may be smaller than the bound, too
    const Run small(system, parameters(1000, 0.1));
    check("a first step below the smallest one, load factor", small.last_load() - 1., 0.);
  }

  /// The unknowns follow the load up to 0.3 and move twice as fast beyond: extrapolation from there
  /// is too short. No unknown may change by more than 0.03 in a step.
  void check_cut_back()
  {
    AlgebraicSystem system =
        springs([](const double u) { return u < 0.3 ? u : 0.3 + 0.5 * (u - 0.3); },
                [](const double u) { return u < 0.3 ? 1. : 0.5; }, {{1., -0.2}});
    system.limit = 0.03;
    const Run run(system, parameters(2));
    check("steps cut back, load factor", run.last_load() - 1., 0.);
    check("steps cut back, solution", std::hypot(run.u[0] - 1.7, run.u[1] + 0.2), 1e-12);
    double longest = 0., previous = 0.;
    for (const Vector &u : run.states)
    {
      longest = std::max(longest, u[0] - previous);
      previous = u[0];
    }
    check("steps cut back, longest step", longest, 0.03 * (1. + 1e-12));
    // they grow again as far as they can: 1.7 / 0.03 = 57 steps at least
    check_true("steps cut back and grown, number",
               run.steps.size() >= 57 && run.steps.size() < 100);
  }

  void check_ends()
  {
    StaticSolverParameters p = parameters(2);
    p.load_factors = {0.9, 0.05, 0.3, 1.};
    AlgebraicSystem system = springs(f, slope, {{f(2.), f(-0.5)}});
    const Run landed(system, p);
    double missed = 0.;
    for (const double factor : {0.05, 0.3, 0.9, 1.})
      missed += std::none_of(landed.steps.begin(), landed.steps.end(),
                             [&](const LoadStep &step) { return step.load == factor; });
    check("load steps end at the load factors asked for", missed, 0.);
    check_true("and take no more than they need", landed.steps.size() <= 6);

    p = parameters(10);
    p.stop_after_steps = 3;
    const Run stopped(system, p);
    check_true("stop after 3 steps", stopped.error.empty() && stopped.steps.size() == 3);

    Vector u(2);
    unsigned int n = 0;
    solve_static(system, u, parameters(10),
                 {[&](const LoadStep &, const Vector &) { ++n; }, [] { return false; },
                  [](double) {}, [&] { return n == 2; }});
    check_true("stop where the caller says", n == 2);
  }

  void check_giving_up()
  {
    // u (2 - u) = load / 0.6 has no solution beyond a load factor of 0.6
    const double limit = 0.6;
    AlgebraicSystem system =
        springs([=](const double u) { return limit * u * (2. - u); },
                [=](const double u) { return limit * 2. * (1. - u); }, {{1., 0.5}});
    const Run run(system, parameters(4));
    check("load reached before giving up", std::abs(run.last_load() - limit), 1e-3);
    check("state left when giving up",
          std::abs(run.u[0] - (1. - std::sqrt(1. - run.last_load() / limit))), 1e-6);
    const std::size_t place = run.error.find("load factor ");
    check_true("message when giving up", run.error.find("below its bound") != std::string::npos &&
                                             run.error.find("iterations") != std::string::npos &&
                                             place != std::string::npos);
    check("load factor in the message", std::stod(run.error.substr(place + 12)) - limit, 2e-3);
  }

  void check_interruption()
  {
    AlgebraicSystem system = springs(f, slope, {{f(2.), f(-0.5)}});
    for (const std::string method : {"Newton", "pseudo-transient", "automatic", "arc length"})
    {
      const Run run(system, parameters(40, 1e-4, method), 3);
      check_true(method + ", interrupted",
                 run.error.empty() && run.steps.size() == 3 && run.u == run.states.back());
    }
  }

  /// y^3 - 1.5 y - 0.5 with y = u - 1: rises from 0 to 0.207 at u = 0.293, falls to
  /// -1.207 at 1.707, rises to 0.625 at 2.5.
  void check_snap_through()
  {
    const auto cubic = [](const double u)
    {
      const double y = u - 1.;
      return y * y * y - 1.5 * y - 0.5;
    };
    const auto cubic_slope = [](const double u) { return 3. * (u - 1.) * (u - 1.) - 1.5; };
    for (const std::string method : {"automatic", "pseudo-transient"})
    {
      AlgebraicSystem system = springs(cubic, cubic_slope, {{0.625, 0.2}});
      const Run run(system, parameters(20, 1e-4, method));
      check(method + ", snap-through, load factor", run.last_load() - 1., 0.);
      check(method + ", snap-through, solution", run.u[0] - 2.5, 1e-11);
      // the second one has not snapped: the smallest root, 0.2 = y^3 - 1.5 y - 0.5
      check(method + ", no snap-through below the limit load", cubic(run.u[1]) - 0.2, 1e-11);
      check_true(method + ", on the first branch", run.u[1] > 0. && run.u[1] < 0.293);
      const bool continued = std::any_of(
          run.steps.begin(), run.steps.end(),
          [](const LoadStep &step) { return std::string(step.method) == "pseudo-transient"; });
      check_true(method + ", by continuation", continued);
    }
  }
} // namespace

int main()
{
  check_full_load();
  check_cut_back();
  check_ends();
  check_giving_up();
  check_interruption();
  check_snap_through();
}
