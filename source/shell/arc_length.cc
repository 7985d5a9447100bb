// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/shell/static_solver.h>

#include <cmath>

namespace semilunar::shell
{
  using Vector = NonlinearSystem::Vector;

  namespace
  {
    /// Steps are scaled towards this number of corrections.
    constexpr unsigned int wanted_corrections = 5;
    /// An arc that needs more than these is too long.
    constexpr unsigned int most_corrections = 15;
    constexpr double smallest_scale = 0.5, largest_scale = 1.5;
    /// A step may turn the path by this cosine at most; where it turns more, several shorter steps
    /// tell a bend from a way back. Arcs are not cut further than this part of the first for it.
    constexpr double sharpest_turn = 0.5, smallest_arc_of_turn = 0.01;
    /// The arc may shrink to this part of the first one.
    constexpr double smallest_arc = 1e-6;

    /// Crisfield's cylindrical arc-length method: |u - u_n| is given, the load is unknown.
    class ArcLength
    {
    public:
      /// @param u start of the path, at load factor zero
      ArcLength(NonlinearSystem &system, const StaticSolverParameters &parameters, const Vector &u)
          : system(system), parameters(parameters), r(system.n_unknowns()),
            correction(system.n_unknowns()),
            smallest_force(system.residual(u, 1. / parameters.n_load_steps, r))
      {
      }

      unsigned int iterations = 0;

      /// Solve for the tangent du/dload at (u, load).
      void make_tangent(const Vector &u, const double load)
      {
        system.load_derivative(u, load, tangent);
        system.linearize(u, load, 0.);
        solve_tangent();
      }

      const Vector &path_tangent() const { return tangent; }

      /// From (u, load) a step of the given length, in the direction of the last change.
      /// @return the new load factor, or NaN if it did not converge or met a singular tangent (a
      /// limit point itself); change and residual are set
      double step(const Vector &u, const double load, const double arc, const Vector &last_change,
                  Vector &change, double &residual, unsigned int &corrections)
      {
        try
        {
          return correct(u, load, arc, last_change, change, residual, corrections);
        }
        catch (const NumericsError &)
        {
          return std::nan("");
        }
      }

    private:
      void solve_tangent()
      {
        tangent *= -1.;
        system.solve(tangent);
      }

      NonlinearSystem &system;
      const StaticSolverParameters &parameters;
      Vector r, tangent, correction;
      /// Residuals are compared with no less than the forces of the first step: a path may cross
      /// load factor zero, where there are none.
      const double smallest_force;

      double correct(const Vector &u, const double load, const double arc,
                     const Vector &last_change, Vector &change, double &residual,
                     unsigned int &corrections)
      {
        make_tangent(u, load);
        const double forward = last_change.all_zero() || tangent * last_change > 0. ? 1. : -1.;
        const unsigned int max_corrections = std::min(most_corrections, parameters.max_iterations);
        double new_load = load + forward * arc / tangent.l2_norm();
        change.equ(forward * arc / tangent.l2_norm(), tangent);
        for (corrections = 0; corrections < max_corrections; ++corrections)
        {
          Vector state = u;
          state += change;
          const double force = system.residual(state, new_load, r);
          residual = r.l2_norm() / std::max(force, smallest_force);
          if (!std::isfinite(residual))
            break;
          if (residual <= parameters.tolerance)
            return new_load;
          ++iterations;
          system.load_derivative(state, new_load, tangent);
          system.linearize_predicted(state, new_load);
          solve_tangent();
          correction = r;
          correction *= -1.;
          system.solve(correction);
          const double load_change = load_correction(change, arc);
          if (!std::isfinite(load_change))
            break;
          correction.add(load_change, tangent);
          change += correction;
          new_load += load_change;
          if (correction.linfty_norm() <= system.smallest_change())
          {
            ++corrections;
            return new_load; // rounding of the internal forces is all that is left
          }
        }
        return std::nan("");
      }

      /// The root of |change + correction + x tangent| = arc that turns the change least.
      double load_correction(const Vector &change, const double arc) const
      {
        Vector moved = change;
        moved += correction;
        const double a = tangent * tangent, b = moved * tangent, c = moved * moved - arc * arc;
        const double discriminant = b * b - a * c;
        if (discriminant < 0.)
          return std::nan("");
        const double root_1 = (-b + std::sqrt(discriminant)) / a,
                     root_2 = (-b - std::sqrt(discriminant)) / a;
        return change * tangent > 0. ? root_1 : root_2;
      }
    };

    bool turns_sharply(const Vector &last_change, const Vector &change)
    {
      return last_change * change < sharpest_turn * last_change.l2_norm() * change.l2_norm();
    }
  } // namespace

  unsigned int follow_path(NonlinearSystem &system, Vector &u,
                           const StaticSolverParameters &parameters, const StaticSolverHooks &hooks)
  {
    ArcLength path(system, parameters, u);
    path.make_tangent(u, 0.);
    const double first_arc = path.path_tangent().l2_norm() / parameters.n_load_steps;
    double load = 0., arc = first_arc;
    Vector last_change(u.size()), change(u.size());
    const auto give_up = [&load](const std::string &what)
    { return NumericsError(what, "load factor " + std::to_string(load), ""); };
    for (unsigned int number = 1; number <= parameters.max_arc_steps; ++number)
    {
      double residual = 0., new_load;
      unsigned int corrections = 0;
      while (!std::isfinite(
                 new_load = path.step(u, load, arc, last_change, change, residual, corrections)) ||
             (arc > smallest_arc_of_turn * first_arc && turns_sharply(last_change, change)))
      {
        arc *= smallest_scale;
        if (arc < smallest_arc * first_arc)
          throw give_up("the arc length fell below its bound");
        if (hooks.interrupted())
          return path.iterations;
      }
      Vector next = u;
      next += change;
      const bool at_end = new_load >= 1.;
      if (at_end) // end at the full load itself
      {
        const double fraction = (1. - load) / (new_load - load);
        next = u;
        next.add(fraction, change);
        new_load = 1.;
        const auto result =
            solve_newton(system, new_load, next,
                         {parameters.tolerance, parameters.max_iterations, hooks.interrupted});
        path.iterations += result.iterations;
        residual = result.residual;
        if (!result.converged)
          throw give_up("the last step to the full load did not converge");
      }
      u = next;
      load = new_load;
      last_change.swap(change);
      system.accept(u, load);
      hooks.accepted({number, load, corrections, residual, "arc length"}, u);
      if (at_end || number == parameters.stop_after_steps || hooks.finished() ||
          hooks.interrupted())
        return path.iterations;
      const double scale = std::sqrt(double(wanted_corrections) / std::max(corrections, 1u));
      arc *= std::min(std::max(scale, smallest_scale), largest_scale);
      arc = std::min(arc, parameters.largest_arc * first_arc);
    }
    throw give_up("the load did not reach its end within the allowed number of arc length steps");
  }
} // namespace semilunar::shell
