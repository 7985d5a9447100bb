// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_scene_flow_through_valve_h
#define semilunar_scene_flow_through_valve_h

#include <semilunar/core/run_context.h>

#include <vector>

namespace semilunar::scene
{
  /// Flow through a valve over time, and the volumes that a cardiologist reads off it.
  class FlowThroughValve
  {
  public:
    /// @param flow_rate towards the aorta, at the end of a step [cm^3/s]
    /// @param pressure  before the valve minus behind it [dyn/cm^2]
    void add(double time, double flow_rate, double pressure);

    /// Peak flow, stroke volume, regurgitant volume, split at the time when the valve is closed
    /// (NaN: not split) into closing volume and leakage, mean leak rate after that, mean flow rate
    /// of the last tenth of the run, largest and smallest pressure difference.
    void add_quantities(double closed, RunResults &results) const;

    template <class Archive>
    void serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &times &flow_rates &pressures;
    }

  private:
    std::vector<double> times, flow_rates, pressures;
  };
} // namespace semilunar::scene

#endif
