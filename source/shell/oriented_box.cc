// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/shell/oriented_box.h>

#include <algorithm>
#include <limits>

namespace semilunar::shell
{
  using namespace spline;

  namespace
  {
    Tensor<1, 3> position(const std::array<double, 4> &coefficient)
    {
      return Tensor<1, 3>({coefficient[0] / coefficient[3], coefficient[1] / coefficient[3],
                           coefficient[2] / coefficient[3]});
    }

    /// The coordinate axis that is farthest from the direction.
    Tensor<1, 3> far_axis(const Tensor<1, 3> &direction)
    {
      unsigned int smallest = 0;
      for (unsigned int d = 1; d < 3; ++d)
        if (std::abs(direction[d]) < std::abs(direction[smallest]))
          smallest = d;
      Tensor<1, 3> axis;
      axis[smallest] = 1.;
      return axis;
    }

    /// Unit vector along the part of v that is normal to the unit vector (or zero) e; any such
    /// vector if there is no such part, as on collapsed elements.
    Tensor<1, 3> normalized_rest(const Tensor<1, 3> &v, const Tensor<1, 3> &e)
    {
      Tensor<1, 3> rest = v - (v * e) * e;
      if (!(rest.norm() > 1e-10 * v.norm()))
      {
        const Tensor<1, 3> axis = far_axis(e);
        rest = axis - (axis * e) * e;
      }
      return rest / rest.norm();
    }
  } // namespace

  OrientedBox::OrientedBox(const BezierPatch &patch)
  {
    const unsigned int n = patch.degree[0] + 1, m = patch.degree[1] + 1;
    const auto corner = [&](const unsigned int i, const unsigned int j)
    { return position(patch.coefficients[j * (m - 1) * n + i * (n - 1)]); };
    const Tensor<1, 3> c00 = corner(0, 0), c10 = corner(1, 0), c01 = corner(0, 1),
                       c11 = corner(1, 1);
    axes[0] = normalized_rest(c10 + c11 - c00 - c01, Tensor<1, 3>());
    axes[1] = normalized_rest(c01 + c11 - c00 - c10, axes[0]);
    axes[2] = cross_product_3d(axes[0], axes[1]);

    begin.fill(std::numeric_limits<double>::max());
    end.fill(std::numeric_limits<double>::lowest());
    lower = upper = c00;
    for (const auto &coefficient : patch.coefficients)
    {
      const Tensor<1, 3> c = position(coefficient);
      for (unsigned int d = 0; d < 3; ++d)
      {
        const double along = c * axes[d];
        begin[d] = std::min(begin[d], along);
        end[d] = std::max(end[d], along);
        lower[d] = std::min(lower[d], c[d]);
        upper[d] = std::max(upper[d], c[d]);
      }
    }
  }

  double OrientedBox::distance(const Tensor<1, 3> &x) const
  {
    double square = 0.;
    for (unsigned int d = 0; d < 3; ++d)
    {
      const double along = x * axes[d];
      const double outside = std::max({begin[d] - along, along - end[d], 0.});
      square += outside * outside;
    }
    return std::sqrt(square);
  }

  Point<2> OrientedBox::guess(const Tensor<1, 3> &x) const
  {
    Point<2> xi;
    for (unsigned int d = 0; d < 2; ++d)
    {
      const double length = end[d] - begin[d];
      xi[d] = length > 0. ? std::clamp((x * axes[d] - begin[d]) / length, 0., 1.) : 0.5;
    }
    return xi;
  }

  bool OrientedBox::is_strongly_curved() const
  {
    // an arc of 45 degrees is this high in relation to its chord
    constexpr double height_of_arc = 0.1;
    return end[2] - begin[2] > height_of_arc * std::min(end[0] - begin[0], end[1] - begin[1]);
  }
} // namespace semilunar::shell
