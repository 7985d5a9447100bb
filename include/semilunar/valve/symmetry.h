// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_valve_symmetry_h
#define semilunar_valve_symmetry_h

#include <semilunar/spline/evaluation.h>

namespace semilunar::valve
{
  /// How much the leaflets differ: the largest distance between a control point of a leaflet,
  /// turned about the z axis onto the first one, and its counterpart there, relative to the largest
  /// displacement.
  /// @param leaflets with node sets leaflet1, ... whose members correspond
  double rotational_asymmetry(const spline::Surface &leaflets,
                              const std::vector<spline::Tensor<1, 3>> &control_vectors);
} // namespace semilunar::valve

#endif
