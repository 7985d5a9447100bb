// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_spline_bernstein_h
#define semilunar_spline_bernstein_h

#include <vector>

namespace semilunar::spline
{
  /// The highest degree of a Bezier element in either direction (sizes the tables on the stack).
  constexpr unsigned int max_degree = 10;

  /// The Bernstein polynomials of a degree >= 1 on [0,1] at x, (S1): degree + 1 numbers.
  void bernstein_values(unsigned int degree, double x, double *values);

  /// The Bernstein polynomials and their first and second derivatives (S2): degree + 1 numbers in
  /// each of the three arrays.
  void bernstein_jet(unsigned int degree, double x, double *values, double *first, double *second);

  /// The same at degree 3, written out for inner loops: nearly all elements are cubic.
  inline void cubic_bernstein_jet(const double x, double *values, double *first, double *second)
  {
    const double y = 1. - x, xx = x * x, yy = y * y, xy = x * y;
    values[0] = y * yy;
    values[1] = 3. * x * yy;
    values[2] = 3. * xx * y;
    values[3] = x * xx;
    first[0] = -3. * yy;
    first[1] = 3. * yy - 6. * xy;
    first[2] = 6. * xy - 3. * xx;
    first[3] = 3. * xx;
    second[0] = 6. * y;
    second[1] = 6. * x - 12. * y;
    second[2] = 6. * y - 12. * x;
    second[3] = 6. * x;
  }

  /// The matrix M, (p+1) x (p+1) row by row, that turns values f_k at the points into Bernstein
  /// coefficients: sum_b (sum_k M_bk f_k) B_b interpolates f. p + 1 distinct points are needed.
  std::vector<double> bernstein_from_values(const std::vector<double> &points);

  /// n choose k.
  double binomial(unsigned int n, unsigned int k);
} // namespace semilunar::spline

#endif
