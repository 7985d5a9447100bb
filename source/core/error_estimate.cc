// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/error_estimate.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>

namespace semilunar
{
  namespace
  {
    constexpr double unknown = ErrorEstimate::unknown;

    /// Below this order the extrapolation is longer than twice the last difference.
    constexpr double smallest_order = 0.5;

    /// (E1), from two quantities that fall like the error.
    double observed_order(const double coarse, const double fine, const double ratio)
    {
      return coarse > 0. && fine > 0. ? std::log(coarse / fine) / std::log(ratio) : unknown;
    }

    /// (E2): the order that value k, the finest, and the two before it show; NaN if they do not
    /// approach a limit steadily.
    double order_of_three(const std::vector<double> &values, const unsigned int k,
                          const double ratio)
    {
      const double first = values[k - 1] - values[k - 2], second = values[k] - values[k - 1];
      if (first * second <= 0.)
        return unknown;
      return observed_order(std::abs(first), std::abs(second), ratio);
    }

    ErrorEstimate against_reference(const std::vector<double> &values, const double ratio,
                                    const double reference)
    {
      ErrorEstimate result{reference, {}, {unknown}, "reference"};
      for (const double value : values)
        result.errors.push_back(std::abs(value - reference));
      for (unsigned int k = 1; k < values.size(); ++k)
        result.orders.push_back(observed_order(result.errors[k - 1], result.errors[k], ratio));
      return result;
    }
  } // namespace

  ErrorEstimate estimate_errors(const std::vector<double> &values, const double ratio,
                                const double reference)
  {
    Assert(!values.empty() && ratio > 1., dealii::ExcInternalError());
    if (!std::isnan(reference))
      return against_reference(values, ratio, reference);

    const unsigned int n = values.size();
    const double finest = values.back();
    ErrorEstimate result{finest, std::vector<double>(n, unknown), std::vector<double>(n, unknown),
                         "none"};
    for (unsigned int k = 2; k < n; ++k)
      result.orders[k] = order_of_three(values, k, ratio);
    if (n == 1)
      return result;

    const double order = result.orders.back();
    const double last = finest - values[n - 2];
    const bool extrapolate = order >= smallest_order; // false for NaN
    result.basis = extrapolate ? "Richardson" : "difference";
    if (extrapolate)
      result.limit = finest + last / (std::pow(ratio, order) - 1.); // (E3)
    for (unsigned int k = 0; k < n; ++k)
      result.errors[k] = std::abs(values[k] - result.limit);
    if (!extrapolate)
      result.errors.back() =
          std::max(std::abs(last), n > 2 ? std::abs(values[n - 2] - values[n - 3]) : 0.);
    return result;
  }
} // namespace semilunar
