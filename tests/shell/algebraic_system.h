// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_tests_algebraic_system_h
#define semilunar_tests_algebraic_system_h

#include <semilunar/core/exceptions.h>
#include <semilunar/shell/nonlinear_system.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

namespace semilunar::tests
{
  /// Two equations r(u, load) = 0 given as formulas; keeps a record of what a solver asks.
  class AlgebraicSystem : public shell::NonlinearSystem
  {
  public:
    using Two = std::array<double, 2>;

    std::function<Two(const Two &u, double load)> force;
    std::function<std::array<Two, 2>(const Two &u, double load)> stiffness;
    std::function<Two(const Two &u, double load)> force_by_load;
    double scale = 1.; ///< what the residual is compared with
    double limit = std::numeric_limits<double>::infinity();
    double noise = 0.; ///< changes up to this size are rounding
    Vector area = vector({{1., 1.}});

    std::vector<double> norms;    ///< of the residuals asked for
    std::vector<Two> linearized;  ///< states
    std::vector<double> accepted; ///< load factors

    static Two components(const Vector &v) { return {{v[0], v[1]}}; }
    static Vector vector(const Two &v) { return Vector(v.begin(), v.end()); }

    unsigned int n_unknowns() const override { return 2; }

    double residual(const Vector &u, const double load, Vector &r) override
    {
      r = vector(force(components(u), load));
      norms.push_back(r.l2_norm() / scale);
      return scale;
    }

    void linearize(const Vector &u, const double load, const double shift) override
    {
      linearized.push_back(components(u));
      matrix = stiffness(components(u), load);
      for (unsigned int i = 0; i < 2; ++i)
        matrix[i][i] += shift * area[i];
      determinant = matrix[0][0] * matrix[1][1] - matrix[0][1] * matrix[1][0];
      if (!(std::abs(determinant) > 0.))
        throw NumericsError("the matrix is singular", "its factorisation", "");
    }

    void solve(Vector &v) const override
    {
      v = vector({{(matrix[1][1] * v[0] - matrix[0][1] * v[1]) / determinant,
                   (matrix[0][0] * v[1] - matrix[1][0] * v[0]) / determinant}});
    }

    const Vector &lumped_area() const override { return area; }

    void load_derivative(const Vector &u, const double load, Vector &derivative) override
    {
      derivative = vector(force_by_load(components(u), load));
    }

    double largest_change() const override { return limit; }
    double smallest_change() const override { return noise; }
    void accept(const Vector &, const double load) override { accepted.push_back(load); }

    /// The largest change of an unknown between two states linearised at.
    double largest_step() const
    {
      double largest = 0.;
      for (unsigned int k = 1; k < linearized.size(); ++k)
        for (unsigned int i = 0; i < 2; ++i)
          largest = std::max(largest, std::abs(linearized[k][i] - linearized[k - 1][i]));
      return largest;
    }

  private:
    std::array<Two, 2> matrix{};
    double determinant = 0.;
  };

  /// Two equations of one unknown each: stiffness f'(u_i) of a spring f(u_i) = load p_i.
  inline AlgebraicSystem springs(const std::function<double(double)> &f,
                                 const std::function<double(double)> &slope,
                                 const AlgebraicSystem::Two &p)
  {
    using Two = AlgebraicSystem::Two;
    AlgebraicSystem system;
    system.force = [=](const Two &u, const double load) {
      return Two{{f(u[0]) - load * p[0], f(u[1]) - load * p[1]}};
    };
    system.stiffness = [=](const Two &u, double) {
      return std::array<Two, 2>{{{{slope(u[0]), 0.}}, {{0., slope(u[1])}}}};
    };
    system.force_by_load = [=](const Two &, double) { return Two{{-p[0], -p[1]}}; };
    return system;
  }
} // namespace semilunar::tests

#endif
