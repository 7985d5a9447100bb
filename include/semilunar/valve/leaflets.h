// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_valve_leaflets_h
#define semilunar_valve_leaflets_h

#include <semilunar/spline/t_spline.h>
#include <semilunar/valve/design.h>

namespace semilunar::valve
{
  /// The midsurface of the first leaflet with as few elements as describe it, (V6): first direction
  /// from commissure to commissure (counter-clockwise seen from the aorta), second direction from
  /// the attachment up to the free edge. a_1 x a_2 points to the aortic side.
  /// @throws InputError from Design::check()
  spline::NurbsPatch leaflet_patch(const Design &design);

  /// The midsurface of the first leaflet, refined as the design says, with the sets of leaflets().
  /// @throws InputError from Design::check()
  spline::Surface leaflet(const Design &design);
  /// The same, refined as this T-spline of the first leaflet is.
  spline::Surface leaflet(const Design &design, const spline::TSpline &first);

  /// The midsurfaces of all leaflets, refined as the design says; the leaflets share no control
  /// points. Node sets: `attachment` (posts and scallop), `nextAttachment` (the second row: both
  /// fixed clamp the leaflets), `freeEdge`, and `leaflet1`, ... as node and as element sets.
  /// @throws InputError from Design::check()
  spline::Surface leaflets(const Design &design);
  /// The same, all refined as this T-spline of the first leaflet is.
  spline::Surface leaflets(const Design &design, const spline::TSpline &first);
} // namespace semilunar::valve

#endif
