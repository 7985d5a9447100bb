// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_valve_deployment_h
#define semilunar_valve_deployment_h

#include <semilunar/spline/nurbs_patch.h>
#include <semilunar/valve/design.h>

namespace semilunar::valve
{
  /// The stent's cross-section when it is in place: semi-axes relative to the design's radius,
  /// (V9).
  struct CrossSection
  {
    double longer, shorter;
    double direction; ///< of the longer axis [rad]
  };
  CrossSection cross_section(const Design &design);

  /// Move points of the circular design to where they are when the stent is in place: an affine map
  /// of x and y, (V10). Exact for rational splines.
  void deploy(std::vector<spline::ControlPoint> &points, const Design &design);

  /// A patch of the first leaflet's sector of the circular design where it is for leaflet k + 1
  /// when the stent is in place.
  spline::NurbsPatch in_place(const spline::NurbsPatch &patch, unsigned int k,
                              const Design &design);

  /// The inverse map of positions.
  std::vector<spline::Tensor<1, 3>> undeployed(std::vector<spline::Tensor<1, 3>> positions,
                                               const Design &design);
} // namespace semilunar::valve

#endif
