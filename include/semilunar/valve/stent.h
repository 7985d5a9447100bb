// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_valve_stent_h
#define semilunar_valve_stent_h

#include <semilunar/spline/nurbs_patch.h>
#include <semilunar/valve/design.h>

namespace semilunar::valve
{
  /// The stent as one watertight surface: the wall r = R between z = 0 and the scallops, the posts
  /// between neighboring leaflets up to the commissures, and the suture ring, the annulus z = 0
  /// outside of the wall. Patches share control points along common edges; the wall's upper edge is
  /// the leaflets' scallop, the posts' sides are the leaflets' commissure lines. a_1 x a_2 points
  /// outward on wall and posts and to +z on the ring. Element sets: `wall`, `posts`, `ring`.
  /// Node sets: `leafletEdge` (where leaflets are attached), `outerEdge` (of the ring).
  /// @throws InputError from Design::check()
  spline::Surface stent(const Design &design);

  /// The parts of the stent as patches, unrefined.
  /// @throws InputError from Design::check()
  std::vector<spline::NurbsPatch> stent_patches(const Design &design);
} // namespace semilunar::valve

#endif
