// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_spline_fit_h
#define semilunar_spline_fit_h

#include <semilunar/spline/surface.h>

#include <functional>

namespace semilunar::spline
{
  /// Where a point of the surface shall lie.
  using TargetShape = std::function<Point<3>(const SurfacePoint &)>;

  /// Move the control points so that the surface is as close as possible to a shape, in the mean
  /// square over points of all elements; edges of the surface count more. Weights stay.
  /// @param edges sides of elements on the boundary
  void fit(Surface &surface, const TargetShape &target,
           const std::vector<std::array<unsigned int, 2>> &edges);
} // namespace semilunar::spline

#endif
