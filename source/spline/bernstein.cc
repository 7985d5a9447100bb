// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/spline/bernstein.h>

#include <deal.II/lac/full_matrix.h>

namespace semilunar::spline
{
  namespace
  {
    /// Overwrite the polynomials of degree p - 1 by those of degree p (the recursion in (S1)).
    inline void raise(const unsigned int p, const double x, double *values)
    {
      const double y = 1. - x;
      values[p] = x * values[p - 1];
      for (unsigned int i = p - 1; i > 0; --i)
        values[i] = y * values[i] + x * values[i - 1];
      values[0] *= y;
    }

    /// Differences of the polynomials of degree p - 1: the first derivatives in (S2).
    inline void differentiate(const unsigned int p, const double *lower, double *derivative)
    {
      derivative[0] = -static_cast<double>(p) * lower[0];
      for (unsigned int i = 1; i < p; ++i)
        derivative[i] = p * (lower[i - 1] - lower[i]);
      derivative[p] = p * lower[p - 1];
    }
  } // namespace

  void bernstein_values(const unsigned int degree, const double x, double *values)
  {
    values[0] = 1.;
    for (unsigned int p = 1; p <= degree; ++p)
      raise(p, x, values);
  }

  void bernstein_jet(const unsigned int degree, const double x, double *values, double *first,
                     double *second)
  {
    const unsigned int p = degree;
    if (p >= 2)
    {
      bernstein_values(p - 2, x, values);
      differentiate(p - 1, values, first); // degree p - 1, differenced once more into degree p
      differentiate(p, first, second);
      raise(p - 1, x, values);
    }
    else
    {
      values[0] = 1.;
      second[0] = second[1] = 0.;
    }
    differentiate(p, values, first);
    raise(p, x, values);
  }

  std::vector<double> bernstein_from_values(const std::vector<double> &points)
  {
    const unsigned int n = points.size();
    std::vector<double> row(n);
    dealii::FullMatrix<double> matrix(n, n);
    for (unsigned int k = 0; k < n; ++k)
    {
      bernstein_values(n - 1, points[k], row.data());
      for (unsigned int b = 0; b < n; ++b)
        matrix(k, b) = row[b];
    }
    matrix.gauss_jordan();

    std::vector<double> result(n * n);
    for (unsigned int b = 0; b < n; ++b)
      for (unsigned int k = 0; k < n; ++k)
        result[b * n + k] = matrix(b, k);
    return result;
  }

  double binomial(const unsigned int n, const unsigned int k)
  {
    double b = 1.;
    for (unsigned int i = 1; i <= k; ++i)
      b = b * (n + 1 - i) / i;
    return b;
  }
} // namespace semilunar::spline
