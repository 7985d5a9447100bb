// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_tests_mirror_images_h
#define semilunar_tests_mirror_images_h

#include <semilunar/spline/surface.h>

#include <algorithm>

namespace semilunar::tests
{
  /// The largest distance of the mirror image of a control point in y = 0 from the nearest one.
  inline double asymmetry(const spline::Surface &surface)
  {
    double largest = 0.;
    for (const spline::ControlPoint &point : surface.control_points)
    {
      spline::Point<3> image = point.position;
      image[1] *= -1.;
      double nearest = 1e300;
      for (const spline::ControlPoint &other : surface.control_points)
        nearest = std::min(nearest, image.distance(other.position));
      largest = std::max(largest, nearest);
    }
    return largest;
  }
} // namespace semilunar::tests

#endif
