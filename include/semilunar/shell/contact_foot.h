// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_shell_contact_foot_h
#define semilunar_shell_contact_foot_h

#include <semilunar/spline/closest_point.h>

#include <deal.II/base/tensor.h>

namespace semilunar::shell
{
  /// The nearest point y of a surface to a point x, and how the surface lies there.
  struct ContactFoot
  {
    ContactFoot() = default;
    /// @param projection of x on the element that holds the foot
    ContactFoot(const spline::Projection &projection, const spline::Tensor<1, 3> &x);

    spline::SurfaceJet jet;        ///< y and its derivatives with respect to xi
    spline::Tensor<1, 3> offset;   ///< x - y
    spline::Tensor<1, 3> normal;   ///< unit normal of the surface, along y,1 x y,2
    double distance = 0.;          ///< |x - y|
    double height = 0.;            ///< (x - y) . normal
    std::array<bool, 2> is_held{}; ///< xi_1, xi_2 held by an edge of the surface

    /// Inside the surface: x - y is along the normal.
    bool on_face() const { return !is_held[0] && !is_held[1]; }
    /// x stands on the face or, at an edge, more above than beside it (at more than 45 degrees): it
    /// is plain on which side of the surface x lies.
    bool side_is_plain() const;
    int side() const { return height < 0. ? -1 : 1; }
  };

  /// Distance of a point from a surface along a unit vector; its derivative is direction . (dx -
  /// dy).
  struct DirectedDistance
  {
    double value;
    spline::Tensor<1, 3> direction;
  };

  /// Equations (C1) on a face, where the distance is negative behind the given side (+-1), and (C2)
  /// at an edge, where it is positive.
  DirectedDistance directed_distance(const ContactFoot &foot, int side);

  /// Second variation of the directed distance as a quadratic form of the three vectors (dx - dy,
  /// dy,1, dy,2): blocks[k][l] belongs to the k-th and l-th of them, (C6).
  using SecondVariation = std::array<std::array<dealii::Tensor<2, 3>, 3>, 3>;
  SecondVariation second_variation(const ContactFoot &foot, int side);
} // namespace semilunar::shell

#endif
