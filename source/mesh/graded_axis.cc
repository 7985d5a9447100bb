// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/mesh/graded_axis.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace semilunar::mesh
{
  namespace
  {
    /// ln cosh x without overflow.
    double log_cosh(const double x)
    {
      const double a = std::abs(x);
      return a + std::log1p(std::exp(-2. * a)) - std::log(2.);
    }
  } // namespace

  GradedAxis::GradedAxis(const double begin, const double end, const double zone_begin,
                         const double zone_end, const double transition, const double ratio)
      : begin(begin), end(end), zone_begin(zone_begin), zone_end(zone_end), transition(transition),
        ratio(ratio), n_begin(count(begin)), n_total(count(end) - count(begin))
  {
  }

  double GradedAxis::count(const double z) const
  {
    if (ratio == 1.)
      return z;
    return z +
           (ratio - 1.) * 0.5 * transition *
               (log_cosh((z - zone_begin) / transition) - log_cosh((z - zone_end) / transition));
  }

  double GradedAxis::density(const double z) const
  {
    if (ratio == 1.)
      return 1.;
    return 1. +
           (ratio - 1.) * 0.5 *
               (std::tanh((z - zone_begin) / transition) - std::tanh((z - zone_end) / transition));
  }

  double GradedAxis::coordinate(const double z) const
  {
    return (count(z) - n_begin) / n_total;
  }

  double GradedAxis::stretch(const double z) const
  {
    return n_total / density(z);
  }

  double GradedAxis::position(const double coordinate) const
  {
    if (coordinate == 0.)
      return begin;
    if (coordinate == 1.)
      return end;
    const double target = n_begin + coordinate * n_total;
    // The density is at least 1: so far outside of the interval may the position lie.
    const double margin = n_total * std::max({0., -coordinate, coordinate - 1.});
    double low = begin - margin, high = end + margin;
    double z = low + coordinate * (high - low);
    const double tolerance = 4. * std::numeric_limits<double>::epsilon() * (end - begin);
    for (unsigned int i = 0; i < 100; ++i)
    {
      const double residual = count(z) - target;
      (residual > 0. ? high : low) = z;
      const double newton = z - residual / density(z);
      const double next = newton > low && newton < high ? newton : 0.5 * (low + high);
      if (std::abs(next - z) < tolerance)
        return next;
      z = next;
    }
    return z;
  }
} // namespace semilunar::mesh
