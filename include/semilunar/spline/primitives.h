// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_spline_primitives_h
#define semilunar_spline_primitives_h

#include <semilunar/spline/nurbs_patch.h>

namespace semilunar::spline
{
  // Exact patches of simple shapes, (S12), with a single element in each direction; elevate and
  // refine them afterwards. Straight directions have degree 1, arcs degree 2 up to 120 degrees and
  // degree 3 above. An arc of more than a half circle consists of two elements, between which the
  // basis is only C0: for a shell, make it of separate pieces instead. Angles in radians, between
  // the ends at most 2 pi; lengths in the scene's unit. All throw InputError for a radius that is
  // not positive, an empty angle, or one out of range.

  /// Bilinear: corners in the order (0,0), (1,0), (0,1), (1,1).
  NurbsPatch quadrilateral(const std::array<Point<3>, 4> &corners);

  /// Part of a cylinder with axis z: first direction along the angle from angle_begin to angle_end
  /// (from the x axis), second direction along z.
  NurbsPatch cylinder(double radius, double angle_begin, double angle_end, double z_begin,
                      double z_end);

  /// Part of a sphere around the origin: first direction along the longitude (from the x axis),
  /// second along the latitude (from the equator).
  NurbsPatch sphere(double radius, double longitude_begin, double longitude_end,
                    double latitude_begin, double latitude_end);

  /// Part of a flat annulus in z = 0: first direction along the radius, second along the angle.
  NurbsPatch annulus(double inner_radius, double outer_radius, double angle_begin,
                     double angle_end);
} // namespace semilunar::spline

#endif
