// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/shell/quadrature_points.h>
#include <semilunar/shell/tangent_frame.h>

#include <deal.II/base/quadrature_lib.h>

namespace semilunar::shell
{
  using namespace spline;

  namespace
  {
    /// Write the functions and their derivatives with respect to s to rows of the given stride.
    void transform(const BasisValues &basis, const TangentFrame &frame, const unsigned int n,
                   const unsigned int stride, double *row)
    {
      for (unsigned int a = 0; a < n; ++a)
      {
        std::array<double, n_derivatives> jet;
        for (unsigned int d = 0; d < n_derivatives; ++d)
          jet[d] = basis.values[d][a];
        jet = frame.transform(jet);
        for (unsigned int d = 0; d < n_derivatives; ++d)
          row[d * stride + a] = jet[d];
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
      const auto &degree = surface.elements[element].degree;
      std::array<unsigned int, 2> numbers;
      for (unsigned int d = 0; d < 2; ++d)
        numbers[d] = n_per_direction ? n_per_direction : degree[d] + 1;
      append_element(surface, element, numbers, basis);
    }
    first.push_back(elements.size());
  }

  QuadraturePoints::QuadraturePoints(const Surface &surface,
                                     const std::vector<std::array<unsigned int, 2>> &numbers)
  {
    AssertDimension(numbers.size(), surface.elements.size());
    BasisValues basis;
    for (unsigned int element = 0; element < surface.elements.size(); ++element)
      append_element(surface, element, numbers[element], basis);
    first.push_back(elements.size());
  }

  void QuadraturePoints::append_element(const Surface &surface, const unsigned int element,
                                        const std::array<unsigned int, 2> &numbers,
                                        BasisValues &basis)
  {
    first.push_back(elements.size());
    strides.push_back((surface.elements[element].n_functions() + simd_width - 1) / simd_width *
                      simd_width);
    const dealii::QGauss<1> gauss_1(numbers[0]), gauss_2(numbers[1]);
    for (unsigned int j = 0; j < gauss_2.size(); ++j)
      for (unsigned int i = 0; i < gauss_1.size(); ++i)
        append_point(surface, element, Point<2>(gauss_1.point(i)[0], gauss_2.point(j)[0]),
                     gauss_1.weight(i) * gauss_2.weight(j), basis);
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
    const TangentFrame frame(a1, a2);
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
