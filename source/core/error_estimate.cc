// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/error_estimate.h>

#include <deal.II/base/exceptions.h>

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

namespace semilunar
{
  namespace
  {
    constexpr double unknown = ErrorEstimate::unknown;

    /// Below this order the extrapolation is longer than twice the last difference.
    constexpr double smallest_order = 0.5;

    /// (E1), from two errors and the mesh sizes they belong to.
    double observed_order(const double coarse, const double fine, const double ratio)
    {
      return coarse > 0. && fine > 0. ? std::log(coarse / fine) / std::log(ratio) : unknown;
    }

    /// (E2): the order that value k, the finest, and the two before it show; NaN if they do not
    /// approach a limit steadily.
    double order_of_three(const std::vector<double> &values, const std::vector<double> &sizes,
                          const unsigned int k)
    {
      const double first = values[k - 1] - values[k - 2], second = values[k] - values[k - 1];
      if (first * second <= 0.)
        return unknown;
      const double coarse = sizes[k - 2] / sizes[k - 1], fine = sizes[k - 1] / sizes[k];
      if (std::abs(coarse - fine) < 1e-12 * fine)
        return observed_order(std::abs(first), std::abs(second), fine);
      // Grows with the order, from log(coarse) / log(fine) at 0.
      const auto excess = [&](const double p) {
        return std::expm1(p * std::log(coarse)) / -std::expm1(-p * std::log(fine)) - first / second;
      };
      const double flattest = 1e-6, steepest = 20.;
      if (excess(flattest) > 0. || excess(steepest) < 0.)
        return unknown;
      std::uintmax_t n_iterations = 200;
      const auto bracket = boost::math::tools::toms748_solve(
          excess, flattest, steepest, boost::math::tools::eps_tolerance<double>(40), n_iterations);
      return 0.5 * (bracket.first + bracket.second);
    }

    ErrorEstimate against_reference(const std::vector<double> &values,
                                    const std::vector<double> &sizes, const double reference)
    {
      ErrorEstimate result{reference, {}, {unknown}, "reference"};
      for (const double value : values)
        result.errors.push_back(std::abs(value - reference));
      for (unsigned int k = 1; k < values.size(); ++k)
        result.orders.push_back(
            observed_order(result.errors[k - 1], result.errors[k], sizes[k - 1] / sizes[k]));
      return result;
    }
  } // namespace

  ErrorEstimate estimate_errors(const std::vector<double> &values, const std::vector<double> &sizes,
                                const double reference)
  {
    Assert(!values.empty() && sizes.size() == values.size(), dealii::ExcInternalError());
    Assert(std::adjacent_find(sizes.begin(), sizes.end(), std::less_equal<>()) == sizes.end(),
           dealii::ExcInternalError());
    if (!std::isnan(reference))
      return against_reference(values, sizes, reference);

    const unsigned int n = values.size();
    const double finest = values.back();
    ErrorEstimate result{finest, std::vector<double>(n, unknown), std::vector<double>(n, unknown),
                         "none"};
    for (unsigned int k = 2; k < n; ++k)
      result.orders[k] = order_of_three(values, sizes, k);
    if (n == 1)
      return result;

    const double order = result.orders.back();
    const double last = finest - values[n - 2];
    const bool extrapolate = order >= smallest_order; // false for NaN
    result.basis = extrapolate ? "Richardson" : "difference";
    if (extrapolate)
      result.limit = finest + last / (std::pow(sizes[n - 2] / sizes[n - 1], order) - 1.); // (E3)
    for (unsigned int k = 0; k < n; ++k)
      result.errors[k] = std::abs(values[k] - result.limit);
    if (!extrapolate)
      result.errors.back() =
          std::max(std::abs(last), n > 2 ? std::abs(values[n - 2] - values[n - 3]) : 0.);
    return result;
  }
} // namespace semilunar
