// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_flow_factor_age_h
#define semilunar_flow_factor_age_h

#include <algorithm>
#include <cmath>

namespace semilunar::flow
{
  /// When factors of a preconditioner are to be made anew: when the equations have changed enough
  /// to cost more iterations than new factors do.
  class FactorAge
  {
  public:
    static constexpr unsigned int any = 1u << 30;

    /// @param max_age solutions that factors may serve
    /// @param max_more iterations that a solution may take beyond those of the first one
    /// @param max_lost iterations that all of them may take beyond those of the best one: what new
    ///   factors cost
    FactorAge(const unsigned int max_age, const unsigned int max_more, const unsigned int max_lost)
        : max_age(max_age), max_more(max_more), max_lost(max_lost)
    {
    }

    /// New factors with a certain alpha_0.
    void start(const double inertia)
    {
      valid = true;
      age = first = last = fewest = sum = 0;
      inertia_of_factors = inertia;
    }
    void invalidate() { valid = false; }

    void add_solution(const unsigned int n_iterations)
    {
      if (age == 0)
        first = fewest = n_iterations;
      last = n_iterations;
      fewest = std::min(fewest, n_iterations);
      sum += n_iterations;
      ++age;
    }

    /// Whether the factors are of no use for solutions with this alpha_0.
    bool unfit(const double inertia) const
    {
      constexpr double max_change = 0.2;
      return !valid || std::abs(inertia - inertia_of_factors) > max_change * inertia;
    }
    bool stale() const
    {
      // Iterations differ between solutions for other reasons as well.
      constexpr unsigned int min_age = 5;
      return age >= max_age || last > first + max_more ||
             (age >= min_age && sum > age * fewest + max_lost);
    }

  private:
    const unsigned int max_age, max_more, max_lost;
    bool valid = false;
    double inertia_of_factors = 0.;
    unsigned int age = 0, first = 0, last = 0, fewest = 0, sum = 0; ///< of iterations
  };
} // namespace semilunar::flow

#endif
