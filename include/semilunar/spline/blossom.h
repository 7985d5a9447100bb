// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_spline_blossom_h
#define semilunar_spline_blossom_h

#include <semilunar/spline/nurbs_patch.h>

namespace semilunar::spline
{
  /// The blossom (polar form) of the polynomial piece of a spline on one span, (S7): the symmetric
  /// function, affine in each of its p arguments, that equals the polynomial when all are equal.
  /// Its values are the coefficients of the spline in every other B-spline or Bernstein basis.
  /// @param span  non-empty, as from KnotVector::span()
  /// @param arguments  p numbers, in any order
  /// @param coefficients  of the functions span - p ... span; overwritten
  template <typename T>
  T blossom(const KnotVector &knots, const unsigned int span, const std::vector<double> &arguments,
            std::vector<T> &coefficients)
  {
    const unsigned int p = knots.degree();
    const std::vector<double> &t = knots.knots();
    for (unsigned int r = 1; r <= p; ++r)
      for (unsigned int j = p; j >= r; --j)
      {
        const double low = t[span - p + j], high = t[span + 1 + j - r], x = arguments[r - 1];
        coefficients[j] = ((high - x) / (high - low)) * coefficients[j - 1] +
                          ((x - low) / (high - low)) * coefficients[j];
      }
    return coefficients[p];
  }
} // namespace semilunar::spline

#endif
