// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_output_oscillation_h
#define semilunar_output_oscillation_h

#include <utility>
#include <vector>

namespace semilunar::output
{
  /// A quantity that swings, over its last two periods (of fewer than four, the last one): mean =
  /// (max + min) / 2, amplitude = (max - min) / 2. Two, because what swings twice while something
  /// else swings once, as the shortening of a flag, has unlike periods. NaN where there are fewer
  /// than two.
  struct Oscillation
  {
    double mean, amplitude;
    double frequency;        ///< of the last periods, four at most [1 / time]
    double amplitude_change; ///< relative, in a period; 0 if it is periodic
  };

  /// Periods begin where the values pass their mean upwards, having been below it by a fifth of the
  /// amplitude since the last one. The first half of the series is a start that does not count.
  Oscillation last_oscillation(const std::vector<double> &times, const std::vector<double> &values);

  /// Time and value of the extremum next to the k-th value, which is larger or smaller than its
  /// neighbours: that of the parabola through the three.
  std::pair<double, double> extremum(const std::vector<double> &times,
                                     const std::vector<double> &values, std::size_t k);
} // namespace semilunar::output

#endif
