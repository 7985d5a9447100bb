// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_shell_newton_h
#define semilunar_shell_newton_h

#include <semilunar/shell/nonlinear_system.h>

#include <functional>
#include <string>

namespace semilunar::shell
{
  struct IterationParameters
  {
    double tolerance = 1e-8; ///< of the residual's norm relative to the forces
    unsigned int max_iterations = 30;
    std::function<bool()> interrupted = [] { return false; }; ///< polled once per iteration
    /// Told the relative residual once per iteration.
    std::function<void(double)> observe = [](double) {};
  };

  struct IterationResult
  {
    bool converged = false;
    unsigned int iterations = 0;
    double residual = 0.; ///< relative
    std::string failure;  ///< why it did not converge
  };

  /// Newton's method: whole steps with the tangent of the predicted stress (K12), and where they
  /// diverge once more with a line search on the work of the residual along the step. Keeps every
  /// change below largest_change(). Counts the iterations of both, each of which may take
  /// max_iterations. On failure u is where it was when called.
  IterationResult solve_newton(NonlinearSystem &system, double load, NonlinearSystem::Vector &u,
                               const IterationParameters &parameters);

  /// Pseudo-transient continuation: linearly implicit steps of the overdamped motion M du/dt =
  /// -r(u) whose length follows from how well the linearisation predicts the residual; ends as
  /// Newton's method. Finds a stable equilibrium where Newton's method wanders: contact, buckling.
  /// On failure u is where it was.
  IterationResult solve_pseudo_transient(NonlinearSystem &system, double load,
                                         NonlinearSystem::Vector &u,
                                         const IterationParameters &parameters);
} // namespace semilunar::shell

#endif
