// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_shell_oriented_box_h
#define semilunar_shell_oriented_box_h

#include <semilunar/spline/closest_point.h>

namespace semilunar::shell
{
  /// A box along the two mean directions of a Bezier patch that holds its control points, and
  /// therefore the patch (positive weights).
  class OrientedBox
  {
  public:
    OrientedBox() = default;
    explicit OrientedBox(const spline::BezierPatch &patch);

    /// Distance from x to the box: no point of the patch is nearer.
    double distance(const spline::Tensor<1, 3> &x) const;

    /// Where in [0,1]^2 the foot of x would be if the patch filled the box evenly.
    spline::Point<2> guess(const spline::Tensor<1, 3> &x) const;

    /// The patch turns so much that guess() may lie in the basin of another foot.
    bool is_strongly_curved() const;

    /// Corners of the box along the coordinate axes that holds the control points.
    const spline::Tensor<1, 3> &lower_corner() const { return lower; }
    const spline::Tensor<1, 3> &upper_corner() const { return upper; }

  private:
    std::array<spline::Tensor<1, 3>, 3> axes; // orthonormal, the last one across the patch
    std::array<double, 3> begin, end;         // bounds along the axes
    spline::Tensor<1, 3> lower, upper;
  };
} // namespace semilunar::shell

#endif
