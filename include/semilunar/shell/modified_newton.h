// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_shell_modified_newton_h
#define semilunar_shell_modified_newton_h

#include <semilunar/shell/newton.h>

namespace semilunar::shell
{
  /// Newton's method that keeps a factorised tangent, from one system to the next similar one, for
  /// as long as the residual falls quickly with it; where it does not fall even with a new tangent,
  /// solve_newton() takes over with its line search. For time steps, whose tangents resemble each
  /// other.
  class ModifiedNewton
  {
  public:
    /// @param start solutions may lie as far from this as largest_change() says
    /// @param w     guess on entry, solution on exit; where it was if it failed
    IterationResult solve(NonlinearSystem &system, const NonlinearSystem::Vector &start,
                          NonlinearSystem::Vector &w, const IterationParameters &parameters);

    /// The next solve() begins with a new tangent.
    void forget_tangent() { has_tangent = false; }
    /// Factorisations so far.
    unsigned int n_factorizations() const { return factorizations; }

  private:
    bool has_tangent = false;
    unsigned int factorizations = 0;

    struct Iterate;
  };
} // namespace semilunar::shell

#endif
