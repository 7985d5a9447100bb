// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/valve/turn.h>

#include <deal.II/base/numbers.h>

#include <cmath>

namespace semilunar::valve
{
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
