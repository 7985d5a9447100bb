// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/output/oscillation.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace semilunar::output
{
  namespace
  {
    using Series = std::vector<double>;

    /// Extrema of the values with numbers first to last.
    struct Range
    {
      Range(const Series &times, const Series &values, const std::size_t first,
            const std::size_t last)
      {
        const auto begin = values.begin() + first, end = values.begin() + last + 1;
        const auto [low, high] = std::minmax_element(begin, end);
        min = extremum(times, values, low - values.begin()).second;
        max = extremum(times, values, high - values.begin()).second;
      }
      double mean() const { return 0.5 * (max + min); }
      double amplitude() const { return 0.5 * (max - min); }

      double min, max;
    };

    struct Crossing
    {
      std::size_t low;   ///< the first low value before
      std::size_t after; ///< the first value beyond
      double time;
    };

    std::vector<Crossing> upward_crossings(const Series &times, const Series &values,
                                           const std::size_t first, const Range &range)
    {
      constexpr double hysteresis = 0.2; // of the amplitude
      const double mean = range.mean(), low = mean - hysteresis * range.amplitude();
      std::vector<Crossing> result;
      constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
      std::size_t first_low = none;
      for (std::size_t k = first; k < values.size(); ++k)
      {
        if (first_low == none && values[k] < low)
          first_low = k;
        if (first_low == none || values[k] < mean)
          continue;
        const double share = (mean - values[k - 1]) / (values[k] - values[k - 1]);
        result.push_back({first_low, k, times[k - 1] + share * (times[k] - times[k - 1])});
        first_low = none;
      }
      return result;
    }
  } // namespace

  std::pair<double, double> extremum(const Series &times, const Series &values, const std::size_t k)
  {
    if (k == 0 || k + 1 >= values.size() ||
        (values[k] - values[k - 1]) * (values[k] - values[k + 1]) < 0.)
      return {times[k], values[k]};
    const double left = (values[k] - values[k - 1]) / (times[k] - times[k - 1]),
                 right = (values[k + 1] - values[k]) / (times[k + 1] - times[k]),
                 curvature = (right - left) / (times[k + 1] - times[k - 1]);
    if (!(std::abs(curvature) > 0.))
      return {times[k], values[k]};
    const double time = 0.5 * (times[k - 1] + times[k]) - 0.5 * left / curvature;
    return {time, values[k - 1] + left * (time - times[k - 1]) +
                      curvature * (time - times[k - 1]) * (time - times[k])};
  }

  Oscillation last_oscillation(const Series &times, const Series &values)
  {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    constexpr std::size_t max_periods = 4;
    std::size_t first =
        std::lower_bound(times.begin(), times.end(), 0.5 * (times.front() + times.back())) -
        times.begin();
    std::vector<Crossing> crossings;
    // Again with the mean of the last periods alone.
    for (unsigned int pass = 0; pass < 2; ++pass)
    {
      crossings =
          upward_crossings(times, values, first, Range(times, values, first, values.size() - 1));
      if (crossings.size() < 3)
        return {none, none, none, none};
      first = crossings[crossings.size() - std::min(crossings.size(), max_periods + 2)].low;
    }
    const std::size_t n = crossings.size(), n_periods = std::min(n - 1, max_periods);
    const std::size_t span = n > 4 ? 2 : 1;
    const auto range = [&](const std::size_t end)
    { return Range(times, values, crossings[end - span].after, crossings[end].after); };
    const Range last = range(n - 1), before = range(n - 1 - span);
    return {last.mean(), last.amplitude(),
            n_periods / (crossings[n - 1].time - crossings[n - 1 - n_periods].time),
            std::pow(last.amplitude() / before.amplitude(), 1. / span) - 1.};
  }
} // namespace semilunar::output
