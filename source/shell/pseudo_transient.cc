// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/shell/newton.h>

#include <cmath>

namespace semilunar::shell
{
  using Vector = NonlinearSystem::Vector;

  namespace
  {
    /// How far the residual after a step may lie from its linear prediction, relative to the
    /// residual before: a step with a larger error is repeated; one with a smaller error than the
    /// second lets the next step grow.
    constexpr double largest_error = 1.0, good_error = 0.25;
    constexpr double shift_growth = 4., shift_decay = 0.25;
    /// Shifts below this part of the first one are as good as none.
    constexpr double negligible_shift = 1e-10;
    constexpr unsigned int max_rejections = 25;

    /// The shift with which the first step, were there no stiffness, would just be as large as it
    /// may.
    double first_shift(const NonlinearSystem &system, const Vector &r)
    {
      double largest = 0.;
      for (unsigned int i = 0; i < r.size(); ++i)
        largest = std::max(largest, std::abs(r[i]) / system.lumped_area()[i]);
      const double change = system.largest_change();
      return std::isfinite(change) ? largest / change
                                   : largest * std::sqrt(system.lumped_area().l1_norm());
    }
  } // namespace

  IterationResult solve_pseudo_transient(NonlinearSystem &system, const double load, Vector &u,
                                         const IterationParameters &parameters)
  {
    IterationResult result;
    Vector state = u, r(u.size()), r_next(u.size()), du(u.size()), next(u.size()),
           predicted(u.size());
    double scale = system.residual(state, load, r);
    double norm = r.l2_norm();
    result.residual = norm / scale;
    const double shift_0 = first_shift(system, r);
    double shift = shift_0;
    unsigned int rejections = 0;
    for (; result.residual > parameters.tolerance; ++result.iterations)
    {
      if (result.iterations == parameters.max_iterations || rejections == max_rejections ||
          parameters.interrupted() || !std::isfinite(norm))
      {
        result.failure =
            "no equilibrium after " + std::to_string(result.iterations) + " pseudo-transient steps";
        return result;
      }
      try
      {
        system.linearize(state, load, shift);
      }
      catch (const NumericsError &)
      {
        shift *= shift_growth;
        ++rejections;
        continue;
      }
      du = r;
      du *= -1.;
      system.solve(du);
      if (!(du * r < 0.)) // uphill: the shifted stiffness is indefinite
      {
        shift *= shift_growth;
        ++rejections;
        continue;
      }
      const double largest = du.linfty_norm();
      const double fraction = std::min(1., system.largest_change() / largest);
      // (K + shift M) du = -r predicts r + fraction K du
      predicted.equ(1. - fraction, r);
      for (unsigned int i = 0; i < r.size(); ++i)
        predicted[i] -= fraction * shift * system.lumped_area()[i] * du[i];
      next = state;
      next.add(fraction, du);
      const double next_scale = system.residual(next, load, r_next);
      predicted -= r_next;
      const double error = predicted.l2_norm() / norm;
      if (!(error <= largest_error) && !(r_next.l2_norm() / next_scale < 0.5 * result.residual))
      {
        shift *= shift_growth;
        ++rejections;
        continue;
      }
      rejections = 0;
      if (error < good_error)
        shift *= shift_decay;
      if (shift < negligible_shift * shift_0)
        shift = 0.;
      std::swap(state, next);
      std::swap(r, r_next);
      scale = next_scale;
      norm = r.l2_norm();
      result.residual = norm / scale;
    }
    u = state;
    result.converged = true;
    return result;
  }
} // namespace semilunar::shell
