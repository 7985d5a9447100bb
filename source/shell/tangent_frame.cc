// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/shell/tangent_frame.h>

namespace semilunar::shell
{
  TangentFrame::TangentFrame(const spline::Tensor<1, 3> &a1, const spline::Tensor<1, 3> &a2)
  {
    const double length = a1.norm();
    e[0] = a1 / length;
    const double along = a2 * e[0];
    const spline::Tensor<1, 3> across = a2 - along * e[0];
    const double height = across.norm();
    e[1] = across / height;
    area = length * height;
    d1_ds1 = 1. / length;
    d1_ds2 = -along / (length * height);
    d2_ds2 = 1. / height;
  }
} // namespace semilunar::shell
