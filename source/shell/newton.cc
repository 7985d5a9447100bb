// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/shell/newton.h>

#include <cmath>
#include <limits>

namespace semilunar::shell
{
  using Vector = NonlinearSystem::Vector;

  namespace
  {
    /// A step is taken whole if the work of the residual along it falls to this part, or the
    /// residual's norm falls.
    constexpr double sufficient_decrease = 0.8;
    constexpr unsigned int max_searches = 6;
    /// By so much, relative, a step of the largest length may be exceeded.
    constexpr double rounding = 1e-12;

    /// Residual at u + fraction du, its relative norm, and its work along du.
    struct Trial
    {
      Vector u, r;
      double norm = 0., work = 0.;

      void evaluate(NonlinearSystem &system, const double load, const Vector &start,
                    const Vector &du, const double fraction)
      {
        u = start;
        u.add(fraction, du);
        const double scale = system.residual(u, load, r);
        norm = r.l2_norm() / scale;
        work = du * r;
      }
      bool finite() const { return std::isfinite(norm) && std::isfinite(work); }
    };

    /// Find a fraction of du that brings the work of the residual near zero: secants from the
    /// start.
    void search_line(NonlinearSystem &system, const double load, const Trial &start,
                     const Vector &du, double fraction, Trial &trial)
    {
      const double work_0 = du * start.r;
      for (unsigned int k = 0; k < max_searches; ++k)
      {
        trial.evaluate(system, load, start.u, du, fraction);
        if (!trial.finite())
          fraction *= 0.25;
        else if (trial.norm < start.norm ||
                 std::abs(trial.work) <= sufficient_decrease * std::abs(work_0))
          return;
        else if (trial.work * work_0 > 0.)
          return; // no sign change ahead: further along is better
        else
          fraction *= std::max(work_0 / (work_0 - trial.work), 0.1);
      }
    }

    double fraction_within(const NonlinearSystem &system, const Vector &du)
    {
      const double largest = du.linfty_norm();
      return largest > system.largest_change() ? system.largest_change() / largest : 1.;
    }

    double distance(const Vector &a, const Vector &b)
    {
      double largest = 0.;
      for (unsigned int i = 0; i < a.size(); ++i)
        largest = std::max(largest, std::abs(a[i] - b[i]));
      return largest;
    }

    enum class Steps
    {
      whole,      // with the stress that the linearisation predicts
      line_search // with the stress of the state
    };
    /// Whole steps are given up where they grow to this multiple of the first two.
    constexpr double largest_growth = 10.;

    /// Newton's method from a start to a solution, or to a reason why not.
    class Newton
    {
    public:
      Newton(NonlinearSystem &system, const double load, const Vector &start,
             const IterationParameters &parameters, const Steps steps)
          : system(system), load(load), start(start), parameters(parameters), steps(steps),
            du(start.size())
      {
        current.evaluate(system, load, start, du, 0.);
      }

      IterationResult run()
      {
        for (; may_go_on(); ++result.iterations)
        {
          du = current.r;
          du *= -1.;
          system.solve(du);
          if (du.linfty_norm() <= system.smallest_change())
          {
            result.converged = true; // rounding of the internal forces is all that is left
            break;
          }
          if (steps == Steps::whole && diverges())
            break;
          move();
        }
        return result;
      }

      const Vector &solution() const { return current.u; }

    private:
      NonlinearSystem &system;
      const double load;
      const Vector &start;
      const IterationParameters &parameters;
      const Steps steps;
      Trial current, next;
      Vector du;
      double first_steps = 0.; // the longer one of the first two
      IterationResult result;

      /// Whether there is a linearised system to solve; otherwise the result is final.
      bool may_go_on()
      {
        result.residual = current.norm;
        parameters.observe(result.residual);
        if (!current.finite())
          return fail("the residual is not finite");
        if (distance(current.u, start) > system.largest_change() * (1. + rounding))
          return fail("the solution lies further away than one step may go");
        result.converged = current.norm <= parameters.tolerance;
        if (result.converged)
          return false;
        if (result.iterations == parameters.max_iterations || parameters.interrupted())
          return fail("no convergence in " + std::to_string(result.iterations) + " iterations");
        try
        {
          if (steps == Steps::whole && result.iterations > 0)
            system.linearize_predicted(current.u, load);
          else
            system.linearize(current.u, load, 0.);
        }
        catch (const NumericsError &error)
        {
          return fail(error.what());
        }
        return true;
      }

      bool fail(const std::string &why)
      {
        result.failure = why;
        return false;
      }

      bool diverges()
      {
        const double length = du.l2_norm();
        if (result.iterations < 2)
          first_steps = std::max(first_steps, length);
        return length > largest_growth * first_steps && !fail("the corrections grow");
      }

      void move()
      {
        const double fraction = fraction_within(system, du);
        if (steps == Steps::whole)
          next.evaluate(system, load, current.u, du, fraction);
        else
          search_line(system, load, current, du, fraction, next);
        std::swap(current, next);
      }
    };
  } // namespace

  IterationResult solve_newton(NonlinearSystem &system, const double load, Vector &u,
                               const IterationParameters &parameters)
  {
    IterationResult result;
    for (const Steps steps : {Steps::whole, Steps::line_search})
    {
      Newton newton(system, load, u, parameters, steps);
      const unsigned int before = result.iterations;
      result = newton.run();
      result.iterations += before;
      if (result.converged)
      {
        u = newton.solution();
        break;
      }
    }
    return result;
  }
} // namespace semilunar::shell
