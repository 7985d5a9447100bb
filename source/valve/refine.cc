// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/valve/refine.h>

#include <deal.II/base/numbers.h>

#include <cmath>

namespace semilunar::valve
{
  namespace
  {
    /// Elements of unequal width get parts of nearly equal width up to this number; more come from
    /// halving.
    constexpr unsigned int n_equalised = 16;

    void halve_elements(spline::NurbsPatch &patch, const unsigned int direction)
    {
      const std::vector<double> points = patch.knots(direction).breakpoints();
      std::vector<double> middles;
      for (unsigned int e = 0; e + 1 < points.size(); ++e)
        middles.push_back((points[e] + points[e + 1]) / 2.);
      patch.insert_knots(direction, middles);
    }
  } // namespace

  void refine(spline::NurbsPatch &patch, const unsigned int direction,
              const unsigned int n_elements)
  {
    unsigned int n = n_elements, n_halvings = 0;
    // an odd number cannot be symmetric about the middle knot
    while (n % 4 == 0 && n / 2 >= n_equalised)
    {
      n /= 2;
      ++n_halvings;
    }
    patch.refine_to(direction, n);
    for (unsigned int k = 0; k < n_halvings; ++k)
      halve_elements(patch, direction);
  }

  void turn(std::vector<spline::ControlPoint> &points, const unsigned int k, const unsigned int n)
  {
    const double angle = 2. * dealii::numbers::PI * k / n;
    const double c = std::cos(angle), s = std::sin(angle);
    for (spline::ControlPoint &point : points)
    {
      const auto x = point.position;
      point.position[0] = c * x[0] - s * x[1];
      point.position[1] = s * x[0] + c * x[1];
    }
  }
} // namespace semilunar::valve
