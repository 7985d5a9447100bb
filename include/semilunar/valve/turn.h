// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_valve_turn_h
#define semilunar_valve_turn_h

#include <semilunar/spline/surface.h>

namespace semilunar::valve
{
  /// Turn all control points about the z axis by k / n of a full turn.
  void turn(std::vector<spline::ControlPoint> &points, unsigned int k, unsigned int n);
} // namespace semilunar::valve

#endif
