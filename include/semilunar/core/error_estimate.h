// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_core_error_estimate_h
#define semilunar_core_error_estimate_h

#include <limits>
#include <string>
#include <vector>

namespace semilunar
{
  /// How far the values of a quantity at several resolutions are from its limit.
  struct ErrorEstimate
  {
    static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

    double limit = unknown;     ///< what the errors refer to
    std::vector<double> errors; ///< one for each value, absolute; NaN if unknown
    std::vector<double> orders; ///< observed with this value as the finest; NaN if there is none
    std::string basis;          ///< "reference", "Richardson", "difference", "none"
  };

  /// Errors of values at ever finer resolutions, equations (E1)-(E3) of doc/theory/error-estimates.md.
  ///
  /// With a reference they are the distances to it. Otherwise they are the distances to
  /// Richardson's limit of the finest three values if these approach one steadily at an order of at
  /// least one half, and else distances to the finest value, which itself gets the larger of the
  /// last two differences ("difference": a cautious guess).
  ///
  /// @param sizes     mesh size or time step of each value, decreasing; only their ratios matter
  /// @param reference NaN if there is none
  ErrorEstimate estimate_errors(const std::vector<double> &values,
                                const std::vector<double> &sizes, double reference);
} // namespace semilunar

#endif
