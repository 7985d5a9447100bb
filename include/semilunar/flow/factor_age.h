// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_flow_factor_age_h
#define semilunar_flow_factor_age_h

#include <algorithm>
#include <cmath>

namespace semilunar::flow
{
  /// When factors of a preconditioner are to be made anew: when the equations
  /// have changed enough to cost more iterations than new factors do.
  class FactorAge
  {
  public:
    /// @param max_age solutions that factors may serve
    /// @param max_more iterations that a solution may take beyond those that it is compared with
    FactorAge(const unsigned int max_age, const unsigned int max_more)
        : max_age(max_age), max_more(max_more)
    {
    }

    /// New factors with a certain alpha_0.
    void start(const double inertia)
    {
      valid = true;
      age = fewest_iterations = last_iterations = 0;
      inertia_of_factors = inertia;
    }
    void invalidate() { valid = false; }

    /// A solution is compared with the first one.
    void add_solution(const unsigned int n_iterations)
    {
      if (age == 0)
        fewest_iterations = n_iterations;
      last_iterations = n_iterations;
      ++age;
    }
    /// A time step of several solutions is compared with the best one so far.
    void add_step(const unsigned int n_iterations)
    {
      const unsigned int before = age == 0 ? n_iterations : fewest_iterations;
      add_solution(n_iterations);
      fewest_iterations = std::min(before, n_iterations);
    }

    /// Whether solutions with this alpha_0 have nothing to do with the factors.
    bool unfit(const double inertia) const
    {
      constexpr double max_change = 0.2;
      return !valid || std::abs(inertia - inertia_of_factors) > max_change * inertia;
    }
    bool stale() const { return age >= max_age || last_iterations > fewest_iterations + max_more; }

  private:
    const unsigned int max_age, max_more;
    bool valid = false;
    double inertia_of_factors = 0.;
    unsigned int age = 0, fewest_iterations = 0, last_iterations = 0;
  };
} // namespace semilunar::flow

#endif
