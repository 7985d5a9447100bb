// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_shell_static_solver_h
#define semilunar_shell_static_solver_h

#include <semilunar/shell/newton.h>

#include <deal.II/base/parameter_handler.h>

namespace semilunar::shell
{
  struct StaticSolverParameters
  {
    std::string method = "automatic";
    unsigned int n_load_steps = 10;
    double smallest_load_step = 1e-4;
    double tolerance = 1e-8;
    unsigned int max_iterations = 25;
    unsigned int max_pseudo_steps = 1000;
    unsigned int max_arc_steps = 500;
    double largest_arc = 1000.;        ///< in units of the first
    unsigned int stop_after_steps = 0; ///< 0: where the load is complete
    std::vector<double> load_factors;  ///< that load steps end at, besides 1; in any order

    void add_parameters(dealii::ParameterHandler &prm);
  };

  /// An accepted state on the load path.
  struct LoadStep
  {
    unsigned int number; ///< counted from 1
    double load;         ///< load factor
    unsigned int iterations;
    double residual; ///< relative
    const char *method;
  };

  /// What the caller wants to know and to say while the load goes up.
  struct StaticSolverHooks
  {
    std::function<void(const LoadStep &, const NonlinearSystem::Vector &u)> accepted;
    std::function<bool()> interrupted = [] { return false; };
    /// Told the relative residual of each iteration towards the next accepted state.
    std::function<void(double)> observe = [](double) {};
    /// Asked after each accepted state: whether the run has got where it was to go.
    std::function<bool()> finished = [] { return false; };
  };

  /// Bring the load factor from 0 to 1. Load steps shrink where the iteration fails and grow where
  /// it is quick. Method "automatic" tries Newton's method and falls back to pseudo-transient
  /// continuation; "arc length" follows the path through limit points until the load factor first
  /// reaches 1; "linear" solves once with the tangent of the undeformed state. Ends before where
  /// the hooks say so or after the number of steps asked for.
  /// @param u the solution at load factor 0 on entry (zero), at load factor 1 on exit; the last
  /// accepted state if it throws
  /// @return total number of iterations
  /// @throws NumericsError naming the load factor at which it gave up; InputError for "linear" with
  /// contact
  unsigned int solve_static(NonlinearSystem &system, NonlinearSystem::Vector &u,
                            const StaticSolverParameters &parameters,
                            const StaticSolverHooks &hooks);

  /// The arc-length method alone: see solve_static().
  unsigned int follow_path(NonlinearSystem &system, NonlinearSystem::Vector &u,
                           const StaticSolverParameters &parameters,
                           const StaticSolverHooks &hooks);
} // namespace semilunar::shell

#endif
