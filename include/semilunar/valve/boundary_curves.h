// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_valve_boundary_curves_h
#define semilunar_valve_boundary_curves_h

#include <semilunar/spline/nurbs_patch.h>
#include <semilunar/valve/design.h>

namespace semilunar::valve
{
  /// The curves from commissure to commissure that bound the first leaflet, as rational cubic
  /// splines with the same knots and weights: sums of their control points are control points of
  /// the sum of the curves. Exactly mirrored in y.
  struct BoundaryCurves
  {
    spline::KnotVector knots;                    ///< on [0,1], the commissure at negative y first
    std::vector<spline::ControlPoint> scallop;   ///< from post foot to post foot, (V2)
    std::vector<spline::ControlPoint> free_edge; ///< from commissure to commissure, (V4)
  };

  BoundaryCurves boundary_curves(const Design &design);

  /// Position in [0,1] of a function of the curves between the symmetry plane (0) and the
  /// commissure (1): its Greville abscissa.
  double distance_from_middle(const spline::KnotVector &knots, unsigned int function);

  /// The number of elements of the curves.
  constexpr unsigned int n_base_elements = 8;
} // namespace semilunar::valve

#endif
