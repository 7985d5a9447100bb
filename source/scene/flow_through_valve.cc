// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/units.h>
#include <semilunar/scene/flow_through_valve.h>

#include <algorithm>
#include <cmath>

namespace semilunar::scene
{
  void FlowThroughValve::add(const double time, const double flow_rate, const double pressure)
  {
    times.push_back(time);
    flow_rates.push_back(flow_rate);
    pressures.push_back(pressure);
  }

  void FlowThroughValve::add_quantities(const double closed, RunResults &results) const
  {
    // The flow is split at the end of forward flow: what runs back before the first opening is none
    // of the valve's closing.
    double forward = 0., closing = 0., leakage = 0., closed_for = 0.;
    double begin = 0.;
    for (std::size_t i = 0; i < times.size(); ++i)
    {
      const double dt = times[i] - begin, volume = flow_rates[i] * dt;
      begin = times[i];
      const bool is_closed = times[i] > closed; // false for NaN
      if (is_closed)
      {
        leakage -= volume;
        closed_for += dt;
      }
      else
        (volume > 0. ? forward : closing) += std::abs(volume);
    }
    double last_volume = 0., last_duration = 0.; // of the last tenth
    for (std::size_t i = 1; i < times.size(); ++i)
      if (times[i] > 0.9 * times.back())
      {
        last_volume += flow_rates[i] * (times[i] - times[i - 1]);
        last_duration += times[i] - times[i - 1];
      }
    const auto peak = std::max_element(flow_rates.begin(), flow_rates.end());
    const auto [lowest, highest] = std::minmax_element(pressures.begin(), pressures.end());
    auto &q = results.quantities;
    q.insert(
        q.end(),
        {{"peak_flow_rate", *peak, "cm^3/s"},
         {"time_of_peak_flow", times[peak - flow_rates.begin()], "s"},
         {"smallest_flow_rate", *std::min_element(flow_rates.begin(), flow_rates.end()), "cm^3/s"},
         {"stroke_volume", forward, "cm^3"},
         {"closing_volume", closing, "cm^3"},
         {"leakage_volume", leakage, "cm^3"},
         {"regurgitant_volume", closing + leakage, "cm^3"},
         {"mean_leak_rate", closed_for > 0. ? leakage / closed_for : std::nan(""), "cm^3/s"},
         {"final_leak_rate", closed_for > 0. ? -flow_rates.back() : std::nan(""), "cm^3/s"},
         {"flow_rate_of_last_tenth", last_volume / last_duration, "cm^3/s"},
         {"largest_pressure_difference", *highest / mmHg, "mmHg"},
         {"smallest_pressure_difference", *lowest / mmHg, "mmHg"}});
  }
} // namespace semilunar::scene
