// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/spline/closest_point.h>

#include <algorithm>
#include <cmath>

namespace semilunar::spline
{
  namespace
  {
    constexpr unsigned int max_iterations = 60; ///< a start near the foot needs 3 to 5
    constexpr double step_tolerance = 1e-13;    ///< in xi, whose range is 1
    constexpr double newton_range = 1e-4;       ///< shorter steps of Newton's need no line search
    constexpr double sufficient_decrease = 1e-4;
    constexpr double shortest_damping = 1e-9;
    constexpr double escape_step = 0.125; ///< out of a maximum or saddle point of the distance

    /// Half the squared distance f, with gradient g and Hessian H, (S13).
    struct SquaredDistance
    {
      SurfaceJet jet;
      double f;
      std::array<double, 2> g;
      double H11, H22, H12; ///< exact
      double G11, G22, G12; ///< Gauss and Newton's part, never indefinite

      SquaredDistance(const BezierPatch &patch, const Tensor<1, 3> &x, const Point<2> &xi)
          : jet(evaluate(patch, xi))
      {
        const Tensor<1, 3> d = jet[value] - x;
        f = 0.5 * (d * d);
        g = {{d * jet[d1], d * jet[d2]}};
        G11 = jet[d1] * jet[d1];
        G22 = jet[d2] * jet[d2];
        G12 = jet[d1] * jet[d2];
        H11 = G11 + d * jet[d11];
        H22 = G22 + d * jet[d22];
        H12 = G12 + d * jet[d12];
      }
    };

    /// Which coordinates a bound holds: the descent would leave [0,1] there.
    bool is_held(const double xi, const double descent)
    {
      return (xi <= 0. && descent < 0.) || (xi >= 1. && descent > 0.);
    }

    struct Step
    {
      std::array<double, 2> p{};
      bool exact_hessian = true; ///< and positive definite, on the free coordinates
    };

    /// Newton's step along one coordinate alone.
    Step line_step(const SquaredDistance &distance, const unsigned int k)
    {
      const double H = k == 0 ? distance.H11 : distance.H22;
      const double G = k == 0 ? distance.G11 : distance.G22;
      Step step;
      step.exact_hessian = H > 1e-8 * G;
      const double divisor = step.exact_hessian ? H : G;
      step.p[k] = divisor > 0. ? -distance.g[k] / divisor : 0.;
      return step;
    }

    /// Newton's step in both coordinates, or Gauss and Newton's where the Hessian is not (safely)
    /// positive definite. Always a descent direction.
    Step plane_step(const SquaredDistance &distance)
    {
      const std::array<double, 2> &g = distance.g;
      double A = distance.H11, B = distance.H22, C = distance.H12;
      Step step;
      step.exact_hessian = A > 0. && B > 0. && A * B - C * C > 1e-8 * distance.G11 * distance.G22;
      if (!step.exact_hessian)
      {
        // the shift keeps it solvable at points where the two tangents are parallel or vanish
        const double shift = 1e-8 * (distance.G11 + distance.G22);
        A = distance.G11 + shift;
        B = distance.G22 + shift;
        C = distance.G12;
      }
      const double determinant = A * B - C * C;
      if (determinant > 0.)
        step.p = {{(C * g[1] - B * g[0]) / determinant, (C * g[0] - A * g[1]) / determinant}};
      return step;
    }

    /// The step on the coordinates that no bound holds. A step that a bound would cut off entirely
    /// in one coordinate is replaced by one along the other.
    Step free_step(const SquaredDistance &distance, const Point<2> &xi,
                   const std::array<bool, 2> &held)
    {
      if (held[0] && held[1])
        return Step();
      if (held[0] || held[1])
        return line_step(distance, held[0] ? 1 : 0);
      const Step step = plane_step(distance);
      for (unsigned int k = 0; k < 2; ++k)
        if (is_held(xi[k], step.p[k]))
          return line_step(distance, 1 - k);
      return step;
    }

    /// At a stationary point that is no minimum: a step along the direction of negative curvature.
    Step escape(const SquaredDistance &distance, const Point<2> &xi,
                const std::array<bool, 2> &held)
    {
      double a = held[0] ? 0. : 1., b = held[1] ? 0. : 1.;
      if (!held[0] && !held[1])
      {
        const double angle =
            0.5 * std::atan2(2. * distance.H12, distance.H11 - distance.H22); // largest eigenvalue
        a = -std::sin(angle);
        b = std::cos(angle);
      }
      const double curvature =
          a * a * distance.H11 + 2. * a * b * distance.H12 + b * b * distance.H22;
      Step step;
      step.exact_hessian = false;
      if (curvature >= 0.)
        return step;
      const bool inward = a * (xi[0] - 0.5) + b * (xi[1] - 0.5) <= 0.;
      const double length = inward ? escape_step : -escape_step;
      step.p = {{length * a, length * b}};
      return step;
    }

    double length(const Step &step)
    {
      return std::max(std::abs(step.p[0]), std::abs(step.p[1]));
    }

    /// Go along the step, bent at the bounds, as far as the distance decreases sufficiently.
    /// @return whether the point has moved
    bool advance(const BezierPatch &patch, const Tensor<1, 3> &x, const Step &step, Point<2> &xi,
                 SquaredDistance &distance)
    {
      const bool is_trusted = step.exact_hessian && length(step) < newton_range;
      for (double damping = 1.; damping > shortest_damping; damping *= 0.5)
      {
        Point<2> next;
        double slope = 0.;
        for (unsigned int k = 0; k < 2; ++k)
        {
          next[k] = std::clamp(xi[k] + damping * step.p[k], 0., 1.);
          slope += distance.g[k] * (next[k] - xi[k]);
        }
        const SquaredDistance there(patch, x, next);
        if (is_trusted || there.f < distance.f + sufficient_decrease * slope)
        {
          xi = next;
          distance = there;
          return true;
        }
      }
      return false;
    }
  } // namespace

  Projection project(const BezierPatch &patch, const Tensor<1, 3> &x, const Point<2> &start)
  {
    Point<2> xi(std::clamp(start[0], 0., 1.), std::clamp(start[1], 0., 1.));
    SquaredDistance distance(patch, x, xi);
    std::array<bool, 2> held{};
    for (unsigned int iteration = 0; iteration < max_iterations; ++iteration)
    {
      for (unsigned int k = 0; k < 2; ++k)
        held[k] = is_held(xi[k], -distance.g[k]);
      Step step = free_step(distance, xi, held);
      if (length(step) <= step_tolerance && !step.exact_hessian)
        step = escape(distance, xi, held);
      if (length(step) <= step_tolerance || !advance(patch, x, step, xi, distance))
        break;
    }

    Projection result;
    result.xi = xi;
    result.distance = std::sqrt(2. * distance.f);
    result.at_boundary = held;
    result.foot = distance.jet;
    return result;
  }
} // namespace semilunar::spline
