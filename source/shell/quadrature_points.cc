// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/shell/quadrature_points.h>

#include <deal.II/base/quadrature_lib.h>

namespace semilunar::shell
{
  using namespace spline;

  namespace
  {
    /// Orthonormal frame of the tangent plane and the linear map from derivatives with respect to
    /// xi to those with respect to the lengths s along it.
    struct TangentFrame
    {
      std::array<Tensor<1, 3>, 2> e;
      double area;   ///< |a_1 x a_2|
      double d1_ds1; ///< d xi_1 / d s_1
      double d1_ds2; ///< d xi_1 / d s_2
      double d2_ds2; ///< d xi_2 / d s_2
    };

    /// Equations (Q1) and (Q2).
    TangentFrame tangent_frame(const Tensor<1, 3> &a1, const Tensor<1, 3> &a2)
    {
      TangentFrame frame;
      const double length = a1.norm();
      frame.e[0] = a1 / length;
      const double along = a2 * frame.e[0];
      const Tensor<1, 3> across = a2 - along * frame.e[0];
      const double height = across.norm();
      frame.e[1] = across / height;
      frame.area = length * height;
      frame.d1_ds1 = 1. / length;
      frame.d1_ds2 = -along / (length * height);
      frame.d2_ds2 = 1. / height;
      return frame;
    }

    /// Equation (Q3): replace derivatives with respect to xi by those with respect to s, for n
    /// functions, written to rows of the given stride.
    void transform(const BasisValues &basis, const TangentFrame &frame, const unsigned int n,
                   const unsigned int stride, double *row)
    {
      const double t11 = frame.d1_ds1, t21 = frame.d1_ds2, t22 = frame.d2_ds2;
      for (unsigned int a = 0; a < n; ++a)
      {
        const double r11 = basis.values[d11][a], r22 = basis.values[d22][a],
                     r12 = basis.values[d12][a];
        row[value * stride + a] = basis.values[value][a];
        row[d1 * stride + a] = t11 * basis.values[d1][a];
        row[d2 * stride + a] = t21 * basis.values[d1][a] + t22 * basis.values[d2][a];
        row[d11 * stride + a] = t11 * t11 * r11;
        row[d22 * stride + a] = t21 * t21 * r11 + 2. * t21 * t22 * r12 + t22 * t22 * r22;
        row[d12 * stride + a] = t11 * (t21 * r11 + t22 * r12);
      }
    }

    void check_tangent_plane(const TangentFrame &frame, const Tensor<1, 3> &a1,
                             const Tensor<1, 3> &a2, const unsigned int element)
    {
      // below this sine of the angle between the coordinate lines the normal is rounding noise
      constexpr double smallest_sine = 1e-10;
      if (!(frame.area > smallest_sine * a1.norm() * a2.norm()) || !(frame.area > 0.))
        throw InputError("surface element " + std::to_string(element), "",
                         "the element is degenerate: it has no tangent plane at a Gauss point",
                         "its control points must span an area");
    }
  } // namespace

  QuadraturePoints::QuadraturePoints(const Surface &surface, const unsigned int n_per_direction)
  {
    BasisValues basis;
    for (unsigned int element = 0; element < surface.elements.size(); ++element)
    {
      const BezierElement &bezier = surface.elements[element];
      first.push_back(elements.size());
      strides.push_back((bezier.n_functions() + simd_width - 1) / simd_width * simd_width);
      const dealii::QGauss<1> gauss_1(n_per_direction ? n_per_direction : bezier.degree[0] + 1);
      const dealii::QGauss<1> gauss_2(n_per_direction ? n_per_direction : bezier.degree[1] + 1);
      for (unsigned int j = 0; j < gauss_2.size(); ++j)
        for (unsigned int i = 0; i < gauss_1.size(); ++i)
          append_point(surface, element, Point<2>(gauss_1.point(i)[0], gauss_2.point(j)[0]),
                       gauss_1.weight(i) * gauss_2.weight(j), basis);
    }
    first.push_back(elements.size());
  }

  void QuadraturePoints::append_point(const Surface &surface, const unsigned int element,
                                      const Point<2> &xi, const double gauss_weight,
                                      BasisValues &basis)
  {
    const BezierElement &bezier = surface.elements[element];
    evaluate_basis(surface, element, xi, basis);
    Tensor<1, 3> a1, a2;
    for (unsigned int a = 0; a < bezier.n_functions(); ++a)
    {
      const Tensor<1, 3> position = surface.control_points[bezier.control_points[a]].position;
      a1 += basis.values[d1][a] * position;
      a2 += basis.values[d2][a] * position;
    }
    const TangentFrame frame = tangent_frame(a1, a2);
    check_tangent_plane(frame, a1, a2, element);

    elements.push_back(element);
    coordinates.push_back(xi);
    weights.push_back(gauss_weight * frame.area);
    frames.push_back(frame.e);
    offsets.push_back(table.size());
    table.resize(table.size() + std::size_t(n_derivatives) * strides[element], 0.);
    transform(basis, frame, bezier.n_functions(), strides[element], table.data() + offsets.back());
  }
} // namespace semilunar::shell
