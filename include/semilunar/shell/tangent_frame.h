// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_shell_tangent_frame_h
#define semilunar_shell_tangent_frame_h

#include <semilunar/spline/evaluation.h>

namespace semilunar::shell
{
  /// Orthonormal frame of the undeformed tangent plane, and the linear map from derivatives with
  /// respect to xi to those with respect to the lengths s along it: equations (Q1) to (Q3) of
  /// doc/theory/contact.md.
  struct TangentFrame
  {
    std::array<spline::Tensor<1, 3>, 2> e; ///< e_1 along a_1
    double area;                           ///< |a_1 x a_2|
    double d1_ds1;                         ///< d xi_1 / d s_1
    double d1_ds2;                         ///< d xi_1 / d s_2
    double d2_ds2;                         ///< d xi_2 / d s_2

    TangentFrame(const spline::Tensor<1, 3> &a1, const spline::Tensor<1, 3> &a2);

    /// Derivatives with respect to s from those with respect to xi, of a function or of a vector.
    template <typename Jet>
    Jet transform(const Jet &jet) const
    {
      using namespace spline;
      const double t11 = d1_ds1, t21 = d1_ds2, t22 = d2_ds2;
      Jet result;
      result[value] = jet[value];
      result[d1] = t11 * jet[d1];
      result[d2] = t21 * jet[d1] + t22 * jet[d2];
      result[d11] = t11 * t11 * jet[d11];
      result[d22] = t21 * t21 * jet[d11] + 2. * t21 * t22 * jet[d12] + t22 * t22 * jet[d22];
      result[d12] = t11 * (t21 * jet[d11] + t22 * jet[d12]);
      return result;
    }
  };
} // namespace semilunar::shell

#endif
