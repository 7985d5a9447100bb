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
    /// A step that misses the prediction is taken all the same if the residual falls to this part.
    constexpr double sufficient_fall = 0.5;
    constexpr double shift_growth = 4., shift_decay = 0.25;
    /// Shifts below this part of the first one are as good as none.
    constexpr double negligible_shift = 1e-10;
    constexpr unsigned int max_rejections = 25;

    class PseudoTransient
    {
    public:
      PseudoTransient(NonlinearSystem &system, const double load, const Vector &u)
          : system(system), load(load), state(u), du(u.size())
      {
        evaluate();
        shift = first_shift = shift_of_largest_step();
      }

      double residual() const { return norm / scale; }
      const Vector &solution() const { return state; }

      /// @return whether the state has moved; if not, the shift has grown
      bool step()
      {
        if (!find_direction())
        {
          shift *= shift_growth;
          return false;
        }
        const double fraction = std::min(1., system.largest_change() / du.linfty_norm());
        next = state;
        next.add(fraction, du);
        const double next_scale = system.residual(next, load, r_next);
        const double error = prediction_error(fraction);
        const bool falls = r_next.l2_norm() / next_scale < sufficient_fall * residual();
        if (!(error <= largest_error) && !falls)
        {
          shift *= shift_growth;
          return false;
        }
        if (fraction < 1.) // longer than contact can follow: the shift is too small
          shift = std::max(shift * shift_growth, negligible_shift * first_shift);
        else if (error < good_error)
          shift *= shift_decay;
        if (shift < negligible_shift * first_shift)
          shift = 0.;
        state.swap(next);
        system.accept(state, load);
        evaluate();
        return true;
      }

    private:
      NonlinearSystem &system;
      const double load;
      Vector state, next, r, r_next, du, predicted;
      double norm = 0., scale = 1., shift = 0., first_shift = 0.;

      void evaluate()
      {
        scale = system.residual(state, load, r);
        norm = r.l2_norm();
      }

      /// The shift with which the first step, were there no stiffness, would be as long as it may.
      double shift_of_largest_step() const
      {
        double fastest = 0.;
        for (unsigned int i = 0; i < r.size(); ++i)
          fastest = std::max(fastest, std::abs(r[i]) / system.lumped_area()[i]);
        const double change = system.largest_change();
        return fastest / (std::isfinite(change) ? change : extent());
      }

      /// A length of the order of the shell's size.
      double extent() const { return std::sqrt(system.lumped_area().l1_norm()); }

      /// Solve (K + shift M) du = -r. @return whether du points downhill
      bool find_direction()
      {
        try
        {
          system.linearize(state, load, shift);
        }
        catch (const NumericsError &)
        {
          return false;
        }
        du = r;
        du *= -1.;
        system.solve(du);
        return du * r < 0.;
      }

      /// Distance of r_next from the prediction (K11), relative to r.
      double prediction_error(const double fraction)
      {
        predicted = r;
        predicted *= 1. - fraction;
        for (unsigned int i = 0; i < r.size(); ++i)
          predicted[i] -= fraction * shift * system.lumped_area()[i] * du[i];
        predicted -= r_next;
        return predicted.l2_norm() / norm;
      }
    };
  } // namespace

  IterationResult solve_pseudo_transient(NonlinearSystem &system, const double load, Vector &u,
                                         const IterationParameters &parameters)
  {
    IterationResult result;
    PseudoTransient path(system, load, u);
    unsigned int rejections = 0;
    while (!((result.residual = path.residual()) <= parameters.tolerance))
    {
      if (result.iterations == parameters.max_iterations || rejections == max_rejections ||
          parameters.interrupted() || !std::isfinite(result.residual))
      {
        result.failure =
            "no equilibrium after " + std::to_string(result.iterations) + " pseudo-transient steps";
        return result;
      }
      parameters.observe(result.residual);
      rejections = path.step() ? 0 : rejections + 1;
      ++result.iterations;
    }
    u = path.solution();
    result.converged = true;
    return result;
  }
} // namespace semilunar::shell
