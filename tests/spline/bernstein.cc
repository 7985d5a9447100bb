// SPDX-License-Identifier: LGPL-2.1-or-later
// Bernstein polynomials against their closed form, their derivatives against central differences.
#include "../tests.h"
#include <semilunar/spline/bernstein.h>

#include <algorithm>
#include <array>
#include <string>

using namespace semilunar;

namespace
{
  struct Jet
  {
    double value[spline::max_degree + 1], first[spline::max_degree + 1],
        second[spline::max_degree + 1];

    Jet(const unsigned int p, const double x) { spline::bernstein_jet(p, x, value, first, second); }
  };

  double binomial(const unsigned int n, const unsigned int k)
  {
    return k == 0 ? 1. : binomial(n - 1, k - 1) * n / k;
  }

  constexpr double sample[] = {0., 0.1, 0.37, 0.5, 0.83, 1.};

  void check_values(const unsigned int p)
  {
    double closed_form = 0., unity = 0., sums = 0., alone = 0.;
    for (const double x : sample)
    {
      const Jet jet(p, x);
      double values[spline::max_degree + 1], sum = 0., first = 0., second = 0.;
      spline::bernstein_values(p, x, values);
      for (unsigned int i = 0; i <= p; ++i)
      {
        const double exact = binomial(p, i) * std::pow(x, i) * std::pow(1. - x, p - i);
        closed_form = std::max(closed_form, std::abs(jet.value[i] - exact));
        alone = std::max(alone, std::abs(values[i] - jet.value[i]));
        sum += jet.value[i];
        first += jet.first[i];
        second += jet.second[i];
      }
      unity = std::max(unity, std::abs(sum - 1.));
      sums = std::max({sums, std::abs(first), std::abs(second)});
    }
    const std::string degree = "degree " + std::to_string(p);
    tests::check(degree + " closed form", closed_form, 1e-14);
    tests::check(degree + " values alone", alone, 1e-14);
    tests::check(degree + " partition of unity", unity, 1e-14);
    tests::check(degree + " sums of derivatives", sums, 1e-12);
  }

  /// The largest errors of the first and second derivatives against differences with step h.
  std::array<double, 2> difference_errors(const unsigned int p, const double h)
  {
    std::array<double, 2> error{};
    for (const double x : {0.2, 0.37, 0.83})
    {
      const Jet here(p, x), below(p, x - h), above(p, x + h);
      for (unsigned int i = 0; i <= p; ++i)
      {
        const double first = (above.value[i] - below.value[i]) / (2. * h);
        const double second = (above.value[i] - 2. * here.value[i] + below.value[i]) / (h * h);
        error[0] = std::max(error[0], std::abs(here.first[i] - first));
        error[1] = std::max(error[1], std::abs(here.second[i] - second));
      }
    }
    return error;
  }

  /// Interpolating x^k must give its known Bernstein coefficients binom(i,k) / binom(p,k).
  double interpolation_error(const unsigned int p)
  {
    std::vector<double> points;
    for (unsigned int i = 0; i <= p; ++i)
      points.push_back(0.5 - 0.5 * std::cos(M_PI * (i + 0.5) / (p + 1)));
    const std::vector<double> matrix = spline::bernstein_from_values(points);
    double error = 0.;
    for (unsigned int k = 0; k <= p; ++k)
      for (unsigned int i = 0; i <= p; ++i)
      {
        double coefficient = 0.;
        for (unsigned int j = 0; j <= p; ++j)
          coefficient += matrix[i * (p + 1) + j] * std::pow(points[j], k);
        const double exact = i < k ? 0. : binomial(i, k) / binomial(p, k);
        error = std::max(error, std::abs(coefficient - exact));
      }
    return error;
  }
} // namespace

int main()
{
  for (const unsigned int p : {1, 2, 3, 4, 7, 10})
    check_values(p);

  // central differences are exact for the first derivative up to degree 2, for the second up to 3
  tests::check("degree 2, first derivatives", difference_errors(2, 1e-2)[0], 1e-12);
  tests::check("degree 3, second derivatives", difference_errors(3, 1e-2)[1], 1e-10);
  for (const unsigned int p : {4, 6})
  {
    const auto coarse = difference_errors(p, 2e-3), fine = difference_errors(p, 1e-3);
    for (unsigned int k = 0; k < 2; ++k)
      tests::check("degree " + std::to_string(p) + ", derivative " + std::to_string(k + 1) +
                       ": the error's order, less 2",
                   std::log2(coarse[k] / fine[k]) - 2., 0.01);
  }

  double values[4], first[4], second[4], difference = 0.;
  for (const double x : sample)
  {
    const Jet general(3, x);
    spline::cubic_bernstein_jet(x, values, first, second);
    for (unsigned int i = 0; i < 4; ++i)
      difference = std::max({difference, std::abs(values[i] - general.value[i]),
                             std::abs(first[i] - general.first[i]),
                             std::abs(second[i] - general.second[i])});
  }
  tests::check("written-out cubics", difference, 1e-14);

  for (const unsigned int p : {1, 2, 3, 5})
    tests::check("degree " + std::to_string(p) + " interpolation of monomials",
                 interpolation_error(p), 1e-12);
}
