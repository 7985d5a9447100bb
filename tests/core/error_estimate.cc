// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Error estimates of sequences whose limits are known.
#include <semilunar/core/error_estimate.h>

#include "../tests.h"

#include <cmath>

using semilunar::ErrorEstimate;
using semilunar::estimate_errors;

namespace
{
  constexpr double unknown = ErrorEstimate::unknown;

  /// limit + factor / ratio^(order k)
  std::vector<double> sequence(const double limit, const double factor, const double ratio,
                               const double order, const unsigned int n)
  {
    std::vector<double> values;
    for (unsigned int k = 0; k < n; ++k)
      values.push_back(limit + factor * std::pow(ratio, -order * k));
    return values;
  }

  /// 1, 1/ratio, 1/ratio^2, ...
  std::vector<double> sizes(const double ratio, const unsigned int n)
  {
    return sequence(0., 1., ratio, 1., n);
  }

  void show(const std::string &name, const ErrorEstimate &estimate)
  {
    auto &log = semilunar::tests::log();
    log << name << ": " << estimate.basis << ", limit " << estimate.limit << ", errors";
    for (const double error : estimate.errors)
      log << ' ' << error;
    log << ", orders";
    for (const double order : estimate.orders)
      if (std::isnan(order))
        log << " -";
      else
        log << ' ' << order;
    log << std::endl;
  }
} // namespace

int main()
{
  const auto second_order = sequence(3., 0.8, 2., 2., 4);
  show("second order", estimate_errors(second_order, sizes(2., 4), unknown));
  show("second order with reference", estimate_errors(second_order, sizes(2., 4), 3.));
  show("order 1.5, ratio 1.5",
       estimate_errors(sequence(-2., 1., 1.5, 1.5, 3), sizes(1.5, 3), unknown));
  show("order 0.3 is not extrapolated",
       estimate_errors(sequence(1., 1., 2., 0.3, 3), sizes(2., 3), unknown));
  show("oscillating", estimate_errors({1.3, 0.9, 1.1}, sizes(2., 3), unknown));
  show("diverging", estimate_errors({1., 1.1, 1.4}, sizes(2., 3), unknown));
  show("constant", estimate_errors({2., 2., 2.}, sizes(2., 3), unknown));
  show("two values", estimate_errors({1.5, 1.25}, sizes(2., 2), unknown));
  // 5 + 7 h^1.7 at h = 1/12, 1/18, 1/24
  std::vector<double> uneven = {1. / 12., 1. / 18., 1. / 24.}, values;
  for (const double h : uneven)
    values.push_back(5. + 7. * std::pow(h, 1.7));
  show("order 1.7, uneven ratios", estimate_errors(values, uneven, unknown));
  show("uneven ratios with reference", estimate_errors(values, uneven, 5.));
  show("one value", estimate_errors({1.5}, sizes(2., 1), unknown));
  show("one value with reference", estimate_errors({1.5}, sizes(2., 1), 1.75));
}
