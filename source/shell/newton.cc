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
  } // namespace

  IterationResult solve_newton(NonlinearSystem &system, const double load, Vector &u,
                               const IterationParameters &parameters)
  {
    IterationResult result;
    Trial current, next;
    Vector du(u.size());
    current.evaluate(system, load, u, du, 0.);
    for (;; ++result.iterations)
    {
      result.residual = current.norm;
      parameters.observe(result.residual);
      if (!current.finite())
      {
        result.failure = "the residual is not finite";
        return result;
      }
      if (distance(current.u, u) > system.largest_change() * (1. + rounding))
      {
        result.failure = "the solution lies further away than one step may go";
        return result;
      }
      if (current.norm <= parameters.tolerance)
        break;
      if (result.iterations == parameters.max_iterations || parameters.interrupted())
      {
        result.failure = "no convergence in " + std::to_string(result.iterations) + " iterations";
        return result;
      }
      try
      {
        system.linearize(current.u, load, 0.);
      }
      catch (const NumericsError &error)
      {
        result.failure = error.what();
        return result;
      }
      du = current.r;
      du *= -1.;
      system.solve(du);
      if (du.linfty_norm() <= system.smallest_change())
        break; // rounding of the internal forces is all that is left
      search_line(system, load, current, du, fraction_within(system, du), next);
      std::swap(current, next);
    }
    u = current.u;
    result.converged = true;
    return result;
  }
} // namespace semilunar::shell
