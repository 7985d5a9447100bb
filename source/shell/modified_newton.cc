// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/shell/modified_newton.h>

#include <cmath>

namespace semilunar::shell
{
  using Vector = NonlinearSystem::Vector;

  namespace
  {
    /// A tangent is kept if the residual falls to this part with it. A new tangent costs about
    /// eight iterations with an old one, and wins about as many decades as the old one loses.
    constexpr double quick_fall = 0.3;

    double distance(const Vector &a, const Vector &b)
    {
      double largest = 0.;
      for (unsigned int i = 0; i < a.size(); ++i)
        largest = std::max(largest, std::abs(a[i] - b[i]));
      return largest;
    }
  } // namespace

  /// A state with its residual.
  struct ModifiedNewton::Iterate
  {
    Vector w, r;
    double norm = 0., scale = 1.;

    void evaluate(NonlinearSystem &system)
    {
      scale = system.residual(w, 1., r);
      norm = r.l2_norm();
    }
    double relative() const { return norm / scale; }
  };

  IterationResult ModifiedNewton::solve(NonlinearSystem &system, const Vector &start, Vector &w,
                                        const IterationParameters &parameters)
  {
    IterationResult result;
    const auto fail = [&](const std::string &why)
    {
      has_tangent = false;
      result.failure = why;
      return result;
    };
    Iterate current, next;
    current.w = w;
    current.evaluate(system);
    if (!std::isfinite(current.norm))
      return fail("the residual is not finite");
    bool is_new = false;
    Vector dw;
    while (!((result.residual = current.relative()) <= parameters.tolerance))
    {
      parameters.observe(result.residual);
      if (result.iterations++ == parameters.max_iterations || parameters.interrupted())
        return fail("no convergence in " + std::to_string(parameters.max_iterations) +
                    " iterations");
      try
      {
        if (!has_tangent)
        {
          system.linearize(current.w, 1., 0.);
          ++factorizations;
          is_new = has_tangent = true;
        }
      }
      catch (const NumericsError &error)
      {
        return fail(error.what());
      }
      dw = current.r;
      dw *= -1.;
      system.solve(dw);
      if (is_new && dw.linfty_norm() <= system.smallest_change())
        break; // rounding of the internal forces is all that is left
      next.w = current.w;
      next.w += dw;
      next.evaluate(system);
      const bool falls = next.norm < current.norm, quick = next.norm < quick_fall * current.norm;
      if (falls)
        std::swap(current, next);
      else if (is_new)
      {
        const unsigned int left = parameters.max_iterations - result.iterations;
        const IterationResult rest =
            solve_newton(system, 1., current.w,
                         {parameters.tolerance, left, parameters.interrupted, parameters.observe});
        factorizations += rest.iterations;
        result.iterations += rest.iterations;
        result.residual = rest.residual;
        if (!rest.converged)
          return fail(rest.failure);
        break;
      }
      has_tangent = quick;
      is_new = false;
    }
    if (distance(current.w, start) > system.largest_change())
      return fail("the solution lies further away than one step may go");
    w = current.w;
    result.converged = true;
    return result;
  }
} // namespace semilunar::shell
