// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/shell/contact_foot.h>

namespace semilunar::shell
{
  using namespace spline;

  namespace
  {
    using Matrix = std::array<std::array<double, 2>, 2>;

    /// Inverse of a symmetric 2 x 2 matrix restricted to the free rows and columns; zero elsewhere.
    Matrix inverse(const Matrix &a, const std::array<bool, 2> &is_free)
    {
      Matrix result{};
      if (is_free[0] && is_free[1])
      {
        const double determinant = a[0][0] * a[1][1] - a[0][1] * a[1][0];
        result = {{{{a[1][1] / determinant, -a[0][1] / determinant}},
                   {{-a[1][0] / determinant, a[0][0] / determinant}}}};
      }
      else
        for (unsigned int k = 0; k < 2; ++k)
          if (is_free[k])
            result[k][k] = 1. / a[k][k];
      return result;
    }

    Matrix product(const Matrix &a, const Matrix &b)
    {
      Matrix result{};
      for (unsigned int i = 0; i < 2; ++i)
        for (unsigned int j = 0; j < 2; ++j)
          for (unsigned int k = 0; k < 2; ++k)
            result[i][j] += a[i][k] * b[k][j];
      return result;
    }

    /// Whether the symmetric matrix, restricted to the free directions, is safely positive definite
    /// in comparison with the metric.
    bool is_positive(const Matrix &a, const Matrix &metric, const std::array<bool, 2> &is_free)
    {
      constexpr double threshold = 1e-6;
      for (unsigned int k = 0; k < 2; ++k)
        if (is_free[k] && !(a[k][k] > threshold * metric[k][k]))
          return false;
      const auto determinant = [](const Matrix &m)
      { return m[0][0] * m[1][1] - m[0][1] * m[1][0]; };
      return !(is_free[0] && is_free[1]) || determinant(a) > threshold * determinant(metric);
    }

    /// Projector on the directions that are normal both to m and to the free tangents.
    Tensor<2, 3> rigid_directions(const Tensor<1, 3> &m, const std::array<Tensor<1, 3>, 2> &a,
                                  const std::array<bool, 2> &is_free)
    {
      if (is_free[0] && is_free[1])
        return Tensor<2, 3>();
      if (is_free[0] || is_free[1])
      {
        const Tensor<1, 3> across = cross_product_3d(m, is_free[0] ? a[0] : a[1]);
        return outer_product(across, across) / across.norm_square();
      }
      Tensor<2, 3> identity;
      for (unsigned int d = 0; d < 3; ++d)
        identity[d][d] = 1.;
      return identity - outer_product(m, m);
    }
  } // namespace

  ContactFoot::ContactFoot(const Projection &projection, const Tensor<1, 3> &x)
      : jet(projection.foot), offset(x - projection.foot[spline::value]), distance(offset.norm())
  {
    // Below this cosine of the angle between offset and coordinate line the foot may as well be
    // interior: a C1 surface goes on beyond the element's edge.
    constexpr double smallest_cosine = 1e-7;
    const Tensor<1, 3> across = cross_product_3d(jet[d1], jet[d2]);
    const double area = across.norm();
    for (unsigned int a = 0; a < 2; ++a)
      is_held[a] = projection.at_boundary[a] &&
                   std::abs(offset * jet[d1 + a]) > smallest_cosine * distance * jet[d1 + a].norm();
    if (area > 1e-10 * jet[d1].norm() * jet[d2].norm() && area > 0.)
      normal = across / area;
    else // a pole of the parametrisation: a mere point
      is_held = {{true, true}};
    height = offset * normal;
  }

  bool ContactFoot::side_is_plain() const
  {
    return on_face() || 2. * height * height >= distance * distance;
  }

  DirectedDistance directed_distance(const ContactFoot &foot, const int side)
  {
    if (foot.on_face())
      return {side * foot.height, side * foot.normal};
    if (foot.distance > 0.)
      return {foot.distance, foot.offset / foot.distance};
    return {0., side * foot.normal};
  }

  SecondVariation second_variation(const ContactFoot &foot, const int side)
  {
    // on a face, work with the signed height along the surface's own normal
    const double sign = foot.on_face() ? side : 1;
    const DirectedDistance height = directed_distance(foot, foot.on_face() ? 1 : side);
    const Tensor<1, 3> &m = height.direction;
    const std::array<bool, 2> is_free{{!foot.is_held[0], !foot.is_held[1]}};
    const std::array<Tensor<1, 3>, 2> a{{foot.jet[d1], foot.jet[d2]}};
    const double b11 = m * foot.jet[d11], b22 = m * foot.jet[d22], b12 = m * foot.jet[d12];
    const Matrix curvature{{{{b11, b12}}, {{b12, b22}}}};
    Matrix metric, raised;
    for (unsigned int k = 0; k < 2; ++k)
      for (unsigned int l = 0; l < 2; ++l)
      {
        metric[k][l] = a[k] * a[l];
        raised[k][l] = metric[k][l] - height.value * curvature[k][l];
      }
    // At a centre of curvature the foot is not unique and its motion not defined: leave the
    // curvature out there.
    const bool is_unique = is_positive(raised, metric, is_free);
    const Matrix motion = inverse(is_unique ? raised : metric, is_free);
    const Matrix bending =
        is_unique ? product(product(inverse(metric, is_free), curvature), motion) : Matrix{};

    SecondVariation q{};
    const Tensor<2, 3> mm = outer_product(m, m);
    if (height.value > 0. && !foot.on_face())
      q[0][0] = sign / height.value * rigid_directions(m, a, is_free);
    for (unsigned int k = 0; k < 2; ++k)
      for (unsigned int l = 0; l < 2; ++l)
      {
        q[0][0] -= sign * bending[k][l] * outer_product(a[k], a[l]);
        q[0][1 + k] -= sign * motion[k][l] * outer_product(a[l], m);
        q[1 + k][0] -= sign * motion[k][l] * outer_product(m, a[l]);
        q[1 + k][1 + l] = -sign * height.value * motion[k][l] * mm;
      }
    return q;
  }
} // namespace semilunar::shell
