// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/valve/refine.h>

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
} // namespace semilunar::valve
