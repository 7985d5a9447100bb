// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/shell/static_solver.h>

#include <cmath>

namespace semilunar::shell
{
  using Vector = NonlinearSystem::Vector;

  namespace
  {
    /// Load steps grow by this factor after a quick step and shrink by its square after a failed
    /// one.
    constexpr double step_growth = 1.5;
    constexpr unsigned int quick = 8; // iterations
    constexpr double end_of_path = 1. - 1e-12;

    /// The first of the load factors beyond this one, or 1.
    double next_target(const std::vector<double> &load_factors, const double load)
    {
      double target = 1.;
      for (const double factor : load_factors)
        if (factor > load + (1. - end_of_path) && factor < target)
          target = factor;
      return target;
    }

    std::string at_load(const double load)
    {
      return "load factor " + std::to_string(load);
    }

    /// Solves at one load by the method asked for.
    class Iteration
    {
    public:
      Iteration(NonlinearSystem &system, const StaticSolverParameters &parameters,
                const StaticSolverHooks &hooks)
          : system(system), parameters(parameters), hooks(hooks)
      {
      }

      unsigned int total_iterations = 0;

      IterationResult operator()(const double load, const Vector &guess, Vector &u,
                                 const char *&method)
      {
        IterationResult result;
        if (parameters.method != "pseudo-transient")
        {
          method = "Newton";
          Vector trial = guess;
          result = count(solve_newton(
              system, load, trial,
              {parameters.tolerance, parameters.max_iterations, hooks.interrupted, hooks.observe}));
          if (result.converged && !within_reach(u, trial))
          {
            result.converged = false;
            result.failure = "the solution lies further away than one step may go";
          }
          if (result.converged)
            u = trial;
        }
        if (!result.converged && parameters.method != "Newton")
        {
          method = "pseudo-transient";
          result = count(solve_pseudo_transient(system, load, u,
                                                {parameters.tolerance, parameters.max_pseudo_steps,
                                                 hooks.interrupted, hooks.observe}));
        }
        return result;
      }

    private:
      NonlinearSystem &system;
      const StaticSolverParameters &parameters;
      const StaticSolverHooks &hooks;

      /// The guess may lie as far from the last state as one step may go, and the solution from it.
      bool within_reach(const Vector &last, Vector next) const
      {
        next -= last;
        return next.linfty_norm() <= system.largest_change();
      }

      IterationResult count(const IterationResult &result)
      {
        total_iterations += result.iterations;
        return result;
      }
    };

    /// One solve with the tangent of the undeformed shell. The residual reported is what the
    /// nonlinear equations have left at the full load: the smaller, the better the approximation.
    unsigned int solve_linear(NonlinearSystem &system, Vector &u, const StaticSolverHooks &hooks)
    {
      if (std::isfinite(system.largest_change()))
        throw InputError("Solver/Method", "linear", "contact is not linear",
                         "disable contact, or use automatic");
      Vector r(u.size());
      system.load_derivative(u, 0., r);
      system.linearize(u, 0., 0.);
      r *= -1.;
      system.solve(r);
      u += r;
      const double scale = system.residual(u, 1., r);
      system.accept(u, 1.);
      hooks.accepted({1, 1., 1, r.l2_norm() / scale, "linear"}, u);
      return 1;
    }
  } // namespace

  void StaticSolverParameters::add_parameters(dealii::ParameterHandler &prm)
  {
    using namespace dealii;
    prm.enter_subsection("Solver");
    prm.add_parameter(
        "Method", method,
        "Newton's method with line search; pseudo-transient continuation (robust for contact and "
        "buckling); automatic: the first, and the second where it fails; arc length: follows "
        "the path through limit points; linear: the response to infinitesimal loads, scaled to "
        "the full ones (no contact).",
        Patterns::Selection("automatic|Newton|pseudo-transient|arc length|linear"));
    prm.add_parameter("Load steps", n_load_steps,
                      "Number of equal steps to begin with; they shrink and grow by need.",
                      Patterns::Integer(1));
    prm.add_parameter("Smallest load step", smallest_load_step,
                      "The solver gives up below this change of the load factor.",
                      Patterns::Double(1e-12, 1.));
    prm.add_parameter(
        "Tolerance", tolerance,
        "Norm of the residual relative to that of the forces at full load, or of the "
        "reactions if displacements drive the shell. A state that rounding keeps from "
        "getting better is taken, too.",
        Patterns::Double(1e-14, 1e-2));
    prm.add_parameter("Iterations", max_iterations, "Newton iterations per load step at most.",
                      Patterns::Integer(1));
    prm.add_parameter("Pseudo-transient steps", max_pseudo_steps, "Per load step at most.",
                      Patterns::Integer(1));
    prm.add_parameter("Arc length steps", max_arc_steps,
                      "In all at most: the solver gives up where the load is not complete then.",
                      Patterns::Integer(1));
    prm.add_parameter("Largest arc", largest_arc,
                      "Arcs grow by need up to this multiple of the first one, whose length is that "
                      "of the first load step of a linear shell: a small number gives a path of "
                      "close points [-].",
                      Patterns::Double(1e-6));
    prm.add_parameter("Stop after steps", stop_after_steps,
                      "The run ends well after so many accepted steps, whatever the load is then; "
                      "0 for no such end.",
                      Patterns::Integer(0));
    prm.add_parameter("Load factors", load_factors,
                      "Load factors between 0 and 1 at which a load step ends, to have the states "
                      "there (not for arc length).",
                      Patterns::List(Patterns::Double(0., 1.)));
    prm.leave_subsection();
  }

  unsigned int solve_static(NonlinearSystem &system, Vector &u,
                            const StaticSolverParameters &parameters,
                            const StaticSolverHooks &hooks)
  {
    if (parameters.method == "arc length")
      return follow_path(system, u, parameters, hooks);
    if (parameters.method == "linear")
      return solve_linear(system, u, hooks);

    Iteration iterate(system, parameters, hooks);
    const double first_step = 1. / parameters.n_load_steps;
    double load = 0., step = first_step, previous_step = 0.;
    Vector previous = u, guess;
    for (unsigned int number = 1; load < end_of_path;)
    {
      const double target = next_target(parameters.load_factors, load);
      const double part = std::min(step, target - load);
      const double next = target - load - part < 1. - end_of_path ? target : load + part;
      guess = u;
      if (previous_step > 0.) // extrapolate from the last two states
      {
        guess.sadd(1. + part / previous_step, -part / previous_step, previous);
        Vector change = guess;
        change -= u;
        if (change.linfty_norm() > system.largest_change())
          guess = u;
      }
      Vector trial = u;
      const char *method = nullptr;
      const auto result = iterate(next, guess, trial, method);
      if (result.converged)
      {
        previous = u;
        u = trial;
        system.accept(u, next);
        previous_step = next - load;
        load = next;
        hooks.accepted({number++, load, result.iterations, result.residual, method}, u);
        if (result.iterations <= quick)
          step *= step_growth;
      }
      else
        step = part / (step_growth * step_growth);
      if (hooks.interrupted() ||
          (result.converged && (number - 1 == parameters.stop_after_steps || hooks.finished())))
        return iterate.total_iterations;
      if (!result.converged && step < parameters.smallest_load_step)
        throw NumericsError("the load step fell below its bound: " + result.failure, at_load(next),
                            "");
    }
    return iterate.total_iterations;
  }
} // namespace semilunar::shell
