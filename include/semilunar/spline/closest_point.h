// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_spline_closest_point_h
#define semilunar_spline_closest_point_h

#include <semilunar/spline/evaluation.h>

namespace semilunar::spline
{
  /// One element of a surface in some configuration, as a rational Bezier patch: homogeneous
  /// Bernstein coefficients (w x, w y, w z, w), index j (p+1) + i. Cheap to evaluate, made once per
  /// configuration.
  struct BezierPatch
  {
    std::array<unsigned int, 2> degree;
    std::vector<std::array<double, 4>> coefficients;
  };

  /// @param control_vectors positions of all control points in the configuration asked for
  BezierPatch bezier_patch(const Surface &surface, unsigned int element,
                           const std::vector<Tensor<1, 3>> &control_vectors);

  SurfaceJet evaluate(const BezierPatch &patch, const Point<2> &xi);

  /// Result of projecting a point on one element.
  struct Projection
  {
    Point<2> xi;          ///< inside or on the boundary of [0,1]^2
    double distance = 0.; ///< from the point to the foot
    std::array<bool, 2>
        at_boundary{}; ///< held by a bound of xi_1, of xi_2 (the gradient points outward)
    SurfaceJet foot;   ///< position and derivatives there
  };

  /// The point of the patch nearest to x: a damped Newton iteration on the squared distance, (S13),
  /// with bounds 0 <= xi <= 1, started at xi. Local minimum only: start near. Allocates nothing.
  Projection project(const BezierPatch &patch, const Tensor<1, 3> &x, const Point<2> &xi);

  /// The point of the whole surface nearest to x (all elements, pruned by bounding boxes): for
  /// probes and point loads, not for inner loops.
  struct ClosestPoint
  {
    SurfacePoint point;
    double distance;
  };
  ClosestPoint closest_point(const Surface &surface,
                             const std::vector<Tensor<1, 3>> &control_vectors,
                             const Tensor<1, 3> &x);
} // namespace semilunar::spline

#endif
