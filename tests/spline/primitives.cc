// SPDX-License-Identifier: LGPL-2.1-or-later
// Primitive shapes: every point on the shape, areas and normals in closed form.
#include "../tests.h"
#include <semilunar/core/exceptions.h>
#include <semilunar/spline/evaluation.h>
#include <semilunar/spline/primitives.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <functional>

using namespace semilunar;
using dealii::Tensor;
using spline::NurbsPatch;

namespace
{
  struct Errors
  {
    double distance = 0.; ///< of points from the shape
    double normal = 0.;
    double area = 0.;
  };

  /// @param distance  of a point from the shape
  /// @param normal    the shape's unit normal at a point
  Errors errors(const NurbsPatch &patch,
                const std::function<double(const Tensor<1, 3> &)> &distance,
                const std::function<Tensor<1, 3>(const Tensor<1, 3> &)> &normal,
                const double exact_area)
  {
    const spline::Surface surface = to_surface(patch);
    check(surface, "primitive");
    const dealii::QGauss<2> quadrature(20);
    Errors result;
    double area = 0.;
    for (unsigned int e = 0; e < surface.elements.size(); ++e)
      for (unsigned int q = 0; q < quadrature.size(); ++q)
      {
        const auto jet = spline::evaluate(surface, {e, quadrature.point(q)});
        const Tensor<1, 3> &x = jet[spline::value];
        const Tensor<1, 3> cross = cross_product_3d(jet[spline::d1], jet[spline::d2]);
        area += quadrature.weight(q) * cross.norm();
        result.distance = std::max(result.distance, std::abs(distance(x)));
        result.normal = std::max(result.normal, (cross / cross.norm() - normal(x)).norm());
      }
    result.area = area / exact_area - 1.;
    return result;
  }

  void check(const std::string &what, const Errors &errors)
  {
    tests::check(what + " points", errors.distance, 1e-14);
    tests::check(what + " normals", errors.normal, 1e-13);
    tests::check(what + " area", errors.area, 1e-12);
  }

  Tensor<1, 3> radial(Tensor<1, 3> x)
  {
    x[2] = 0.;
    return x / x.norm();
  }

  Errors cylinder_errors(const double begin, const double end)
  {
    return errors(
        spline::cylinder(2., begin, end, -1., 3.),
        [](const Tensor<1, 3> &x) {
          return std::hypot(x[0], x[1]) / 2. - 1. + std::max({-1. - x[2], 0., x[2] - 3.});
        },
        radial, 8. * (end - begin));
  }

  template <typename Action>
  void log_error(const Action &action)
  {
    try
    {
      action();
      tests::log() << "NO ERROR" << std::endl;
    }
    catch (const InputError &error)
    {
      tests::log() << error.what() << std::endl;
    }
  }
} // namespace

int main()
{
  check("cylinder, 40 degrees", cylinder_errors(0.3, 0.3 + M_PI / 4.5));
  check("cylinder, 120 degrees", cylinder_errors(-M_PI / 3., M_PI / 3.));
  check("cylinder, half", cylinder_errors(0., M_PI));
  check("cylinder, full", cylinder_errors(-1., 2. * M_PI - 1.));

  const double pole = M_PI / 2.;
  check("sphere, octant with an opening",
        errors(
            spline::sphere(10., 0., pole, 0., 0.4 * M_PI),
            [](const Tensor<1, 3> &x) { return x.norm() / 10. - 1.; },
            [](const Tensor<1, 3> &x) { return x / x.norm(); },
            100. * pole * std::sin(0.4 * M_PI)));
  check("sphere, whole", errors(
                             spline::sphere(0.5, 0., 2. * M_PI, -pole, pole),
                             [](const Tensor<1, 3> &x) { return x.norm() / 0.5 - 1.; },
                             [](const Tensor<1, 3> &x) { return x / x.norm(); }, M_PI));

  Tensor<1, 3> up;
  up[2] = 1.;
  const auto height = [](const Tensor<1, 3> &x) {
    return x[2] + std::max({1. - std::hypot(x[0], x[1]), 0., std::hypot(x[0], x[1]) - 1.4});
  };
  check("annulus", errors(
                       spline::annulus(1., 1.4, 0.2, 1.9), height,
                       [&](const Tensor<1, 3> &) { return up; }, 0.5 * 1.7 * (1.4 * 1.4 - 1.)));

  const spline::Point<3> a(0, 0, 1), b(2, 0, 1), c(0, 3, 1), d(2, 3, 1);
  check("rectangle",
        errors(
            spline::quadrilateral({{a, b, c, d}}), [](const Tensor<1, 3> &x) { return x[2] - 1.; },
            [&](const Tensor<1, 3> &) { return up; }, 6.));

  const NurbsPatch arc = spline::cylinder(1., 0.1, 0.6, 0., 2.);
  tests::log() << "one element of degree " << arc.knots(0).degree() << " from "
               << arc.evaluate({0., 0.}) << " to " << arc.evaluate({1., 1.}) << std::endl;

  log_error([] { spline::cylinder(-1., 0., 1., 0., 1.); });
  log_error([] { spline::cylinder(1., 0., 7., 0., 1.); });
  log_error([] { spline::sphere(1., 0., 1., 0., 2.); });
  log_error([] { spline::annulus(1., 2., 0.5, 0.5); });
}
