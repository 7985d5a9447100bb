// SPDX-License-Identifier: LGPL-2.1-or-later
// Gauss points in orthonormal tangent frames: areas of exact spheres and cylinders, the frame, and
// the derivatives along it against finite differences.
#include <semilunar/core/exceptions.h>
#include <semilunar/shell/quadrature_points.h>
#include <semilunar/spline/primitives.h>

#include <cstdint>

#include "../tests.h"

using namespace semilunar;
using namespace semilunar::spline;
using semilunar::shell::QuadraturePoints;
using semilunar::tests::check;
using semilunar::tests::log;

namespace
{
  Surface refined(NurbsPatch patch, const unsigned int n)
  {
    for (unsigned int direction = 0; direction < 2; ++direction)
    {
      patch.elevate_degree(direction, 3 - patch.knots(direction).degree());
      patch.refine_to(direction, n);
    }
    return to_surface(patch);
  }

  double area(const QuadraturePoints &points)
  {
    double sum = 0.;
    for (unsigned int q = 0; q < points.n_points(); ++q)
      sum += points.weight(q);
    return sum;
  }

  Tensor<1, 3> combine(const Surface &surface, const QuadraturePoints &points, const unsigned int q,
                       const Derivative derivative)
  {
    const BezierElement &element = surface.elements[points.element(q)];
    Tensor<1, 3> sum;
    for (unsigned int a = 0; a < element.n_functions(); ++a)
      sum += points.basis(q, derivative)[a] *
             surface.control_points[element.control_points[a]].position;
    return sum;
  }

  /// The value of function a at the coordinates s along the frame of point q.
  struct AlongFrame
  {
    AlongFrame(const Surface &surface, const QuadraturePoints &points, const unsigned int q)
        : surface(surface), element(points.element(q)), xi(points.xi(q))
    {
      const SurfaceJet jet = evaluate(surface, {element, xi});
      dealii::Tensor<2, 2> ds_dxi;
      for (unsigned int i = 0; i < 2; ++i)
        for (unsigned int j = 0; j < 2; ++j)
          ds_dxi[i][j] = points.frame(q)[i] * jet[d1 + j];
      dxi_ds = invert(ds_dxi);
    }
    double operator()(const unsigned int a, const double s1, const double s2)
    {
      evaluate_basis(surface, element, Point<2>(xi + dxi_ds * Tensor<1, 2>({s1, s2})), basis);
      return basis.values[spline::value][a];
    }
    const Surface &surface;
    const unsigned int element;
    const Point<2> xi;
    dealii::Tensor<2, 2> dxi_ds;
    BasisValues basis;
  };

  using Derivatives = std::array<double, n_derivatives>;

  Derivatives central_differences(AlongFrame &R, const unsigned int a, const double h)
  {
    const double centre = R(a, 0, 0);
    return {{centre, (R(a, h, 0) - R(a, -h, 0)) / (2. * h), (R(a, 0, h) - R(a, 0, -h)) / (2. * h),
             (R(a, h, 0) - 2. * centre + R(a, -h, 0)) / (h * h),
             (R(a, 0, h) - 2. * centre + R(a, 0, -h)) / (h * h),
             (R(a, h, h) - R(a, h, -h) - R(a, -h, h) + R(a, -h, -h)) / (4. * h * h)}};
  }

  /// Difference from extrapolated central differences, in relation to the largest derivative.
  double largest_difference(const Surface &surface, const QuadraturePoints &points,
                            const unsigned int q)
  {
    const double h = 1e-3;
    AlongFrame R(surface, points, q);
    double largest = 0.;
    for (unsigned int d = 0; d < n_derivatives; ++d)
    {
      double difference = 0., size = 0.;
      for (unsigned int a = 0; a < surface.elements[points.element(q)].n_functions(); ++a)
      {
        const double expected =
            (4. * central_differences(R, a, h)[d] - central_differences(R, a, 2. * h)[d]) / 3.;
        difference = std::max(difference,
                              std::abs(points.basis(q, static_cast<Derivative>(d))[a] - expected));
        size = std::max(size, std::abs(expected));
      }
      largest = std::max(largest, difference / size);
    }
    return largest;
  }

  void check_areas()
  {
    const double pi = dealii::numbers::PI;
    const Surface round = refined(sphere(2., 0.3, 1.4, -0.5, 0.9), 4);
    check("area of a spherical patch",
          area(QuadraturePoints(round)) / (4. * 1.1 * (std::sin(0.9) + std::sin(0.5))) - 1., 1e-8);
    const Surface tube = refined(cylinder(1.5, 0., 0.75 * pi, -1., 2.), 4);
    check("area of a cylindrical patch", area(QuadraturePoints(tube)) / (1.5 * 0.75 * pi * 3.) - 1.,
          1e-8);
    log() << "points of 16 bicubic elements: " << QuadraturePoints(tube).n_points() << ", with 5 "
          << "per direction: " << QuadraturePoints(tube, 5).n_points() << std::endl;

    double largest = 0.;
    const QuadraturePoints points(tube);
    for (unsigned int q = 0; q < points.n_points(); ++q)
    {
      Tensor<1, 3> radial = combine(tube, points, q, spline::value);
      radial[2] = 0.;
      const auto &e = points.frame(q);
      largest = std::max({largest, (cross_product_3d(e[0], e[1]) - radial / 1.5).norm(),
                          std::abs(e[0] * e[1]), std::abs(e[0].norm() - 1.), std::abs(e[0][2])});
    }
    check("frame of the cylinder: circumferential, axial, radial", largest, 1e-13);
  }

  /// A bent patch with oblique and uneven coordinate lines, and one of another degree.
  Surface oblique()
  {
    NurbsPatch patch = quadrilateral(
        {{Point<3>(0, 0, 0), Point<3>(2, 0.7, 0.4), Point<3>(0.9, 1.5, 0.1), Point<3>(2.2, 3, 1)}});
    patch.elevate_degree(0, 2);
    patch.elevate_degree(1, 1);
    std::vector<ControlPoint> net = patch.control_net();
    for (unsigned int i = 0; i < net.size(); ++i)
    {
      net[i].position[2] += 0.3 * std::sin(3. * i);
      net[i].weight = 1. + 0.2 * std::cos(5. * i);
    }
    NurbsPatch bent({{patch.knots(0), patch.knots(1)}}, net);
    bent.refine_to(0, 3);
    bent.refine_to(1, 2);
    Surface surface = to_surface(bent);
    append(surface, refined(annulus(1., 2., 0., 1.), 1), -1.);
    return surface;
  }

  void check_derivatives()
  {
    const Surface surface = oblique();
    const QuadraturePoints points(surface);
    log() << "points of 6 elements of degrees 3, 2 and one of 3, 3: " << points.n_points()
          << ", first of the last element: " << points.first_point(6) << std::endl;
    double largest = 0., metric = 0., padding = 0., misalignment = 0.;
    for (unsigned int q = 0; q < points.n_points(); ++q)
    {
      largest = std::max(largest, largest_difference(surface, points, q));
      const Tensor<1, 3> a1 = combine(surface, points, q, d1), a2 = combine(surface, points, q, d2);
      metric =
          std::max({metric, std::abs(a1 * a1 - 1.), std::abs(a2 * a2 - 1.), std::abs(a1 * a2)});
      const unsigned int element = points.element(q);
      for (unsigned int d = 0; d < n_derivatives; ++d)
      {
        const double *row = points.basis(q, static_cast<Derivative>(d));
        misalignment += reinterpret_cast<std::uintptr_t>(row) % 64;
        for (unsigned int a = surface.elements[element].n_functions(); a < points.stride(element);
             ++a)
          padding += std::abs(row[a]);
      }
    }
    check("derivatives against finite differences", largest, 1e-8);
    check("undeformed first fundamental form minus identity", metric, 1e-13);
    check("numbers in the padding", padding, 0.);
    check("bytes off a cache line", misalignment, 0.);
  }

  void check_degenerate()
  {
    const Point<3> p(0, 0, 0), r(1, 0, 0);
    try
    {
      QuadraturePoints(to_surface(quadrilateral({{p, r, Point<3>(2, 0, 0), Point<3>(3, 0, 0)}})));
      log() << "accepted a line as a surface" << std::endl;
    }
    catch (const InputError &error)
    {
      log() << error.what() << std::endl;
    }
  }
} // namespace

int main()
{
  check_areas();
  check_derivatives();
  check_degenerate();
}
