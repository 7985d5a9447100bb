// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_valve_leaflet_t_spline_h
#define semilunar_valve_leaflet_t_spline_h

#include <semilunar/spline/t_spline.h>
#include <semilunar/valve/design.h>

namespace semilunar::valve
{
  /// The first leaflet as a T-spline, refined in the design's zones; the same surface as
  /// leaflet_patch(). Symmetric about y = 0.
  /// @throws InputError from Design::check()
  spline::TSpline leaflet_t_spline(const Design &design);
} // namespace semilunar::valve

#endif
