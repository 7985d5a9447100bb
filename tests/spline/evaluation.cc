// SPDX-License-Identifier: LGPL-2.1-or-later
// Rational basis functions and their derivatives, on elements with different numbers of functions.
#include "../tests.h"
#include <semilunar/spline/closest_point.h>
#include <semilunar/spline/primitives.h>

#include <algorithm>
#include <random>

using namespace semilunar;
using spline::Point;
using spline::SurfaceJet;

namespace
{
  std::mt19937 generator(5);

  double random_number(const double low, const double high)
  {
    return low + (high - low) * std::uniform_real_distribution<double>()(generator);
  }

  /// Degrees 2 and 3, random weights; on the second element one function is split into three, with
  /// control points of their own, as happens near T-junctions.
  spline::Surface test_surface()
  {
    const std::array<spline::KnotVector, 2> knots{
        {spline::KnotVector(2, {0, 0, 0, 0.4, 1, 1, 1}), spline::KnotVector::uniform(3, 2)}};
    std::vector<spline::ControlPoint> net;
    for (unsigned int j = 0; j < 5; ++j)
      for (unsigned int i = 0; i < 4; ++i)
        net.push_back({Point<3>(i + random_number(-0.3, 0.3), j + random_number(-0.3, 0.3),
                                random_number(-1., 1.)),
                       random_number(0.5, 2.)});
    spline::Surface surface = to_surface(spline::NurbsPatch(knots, net));

    spline::BezierElement &element = surface.elements[1];
    const unsigned int m = element.n_bernstein();
    for (const double share : {0.25, 0.3})
    {
      element.control_points.push_back(surface.control_points.size());
      surface.control_points.push_back({Point<3>(1., share, 0.5), 1. + share});
      for (unsigned int b = 0; b < m; ++b)
        element.extraction.push_back(share * element.extraction[5 * m + b]);
    }
    for (unsigned int b = 0; b < m; ++b)
      element.extraction[5 * m + b] *= 0.45;
    check(surface, "test surface");
    return surface;
  }

  double distance(const SurfaceJet &a, const SurfaceJet &b)
  {
    double result = 0.;
    for (unsigned int k = 0; k < spline::n_derivatives; ++k)
      result = std::max(result, (a[k] - b[k]).norm());
    return result;
  }

  /// Values and central differences of values only, with step h.
  SurfaceJet differences(const spline::Surface &surface, const unsigned int e, const Point<2> &xi,
                         const double h)
  {
    const auto at = [&](const int i, const int j) {
      return spline::evaluate(surface, {e, xi + Point<2>(i * h, j * h)})[spline::value];
    };
    SurfaceJet jet;
    jet[spline::value] = at(0, 0);
    jet[spline::d1] = (at(1, 0) - at(-1, 0)) / (2. * h);
    jet[spline::d2] = (at(0, 1) - at(0, -1)) / (2. * h);
    jet[spline::d11] = (at(1, 0) - 2. * at(0, 0) + at(-1, 0)) / (h * h);
    jet[spline::d22] = (at(0, 1) - 2. * at(0, 0) + at(0, -1)) / (h * h);
    jet[spline::d12] = (at(1, 1) - at(1, -1) - at(-1, 1) + at(-1, -1)) / (4. * h * h);
    return jet;
  }

  void check_element(const spline::Surface &surface, const unsigned int e)
  {
    const Point<2> xi(0.37, 0.62);
    const spline::BezierElement &element = surface.elements[e];
    const auto x = positions(surface);
    spline::BasisValues basis;
    evaluate_basis(surface, e, xi, basis);
    const SurfaceJet jet = interpolate(element, basis, x);

    double unity = 0.;
    for (unsigned int k = 0; k < spline::n_derivatives; ++k)
    {
      double sum = k == spline::value ? -1. : 0.;
      for (unsigned int a = 0; a < element.n_functions(); ++a)
        sum += basis.values[k][a];
      unity = std::max(unity, std::abs(sum));
    }
    const std::string what = std::to_string(element.n_functions()) + " functions, ";
    tests::check(what + "partition of unity and its derivatives", unity, 1e-13);
    tests::check(what + "evaluate", distance(jet, spline::evaluate(surface, {e, xi})), 1e-13);
    tests::check(what + "Bezier patch",
                 distance(jet, spline::evaluate(bezier_patch(surface, e, x), xi)), 1e-12);

    const SurfaceJet coarse = differences(surface, e, xi, 2e-3);
    const SurfaceJet fine = differences(surface, e, xi, 1e-3);
    for (unsigned int k = spline::d1; k < spline::n_derivatives; ++k)
      tests::check(what + "derivative " + std::to_string(k) + ": order of the differences, less 2",
                   std::log2((coarse[k] - jet[k]).norm() / (fine[k] - jet[k]).norm()) - 2., 0.05);
  }

  /// On a sphere the second derivatives are known: x . x_,ij = - x_,i . x_,j.
  void check_sphere()
  {
    spline::NurbsPatch patch = spline::sphere(1., 0., 1.2, -0.4, 0.9);
    patch.elevate_degree(0, 1);
    patch.elevate_degree(1, 2);
    patch.refine_to(0, 3);
    const spline::Surface surface = to_surface(patch);
    double error = 0.;
    for (unsigned int e = 0; e < surface.elements.size(); ++e)
      for (const double u : {0., 0.4, 1.})
      {
        const SurfaceJet jet = spline::evaluate(surface, {e, Point<2>(u, 0.7 * u)});
        const auto defect = [&](const unsigned int ij, const unsigned int i, const unsigned int j)
        { return std::abs(jet[spline::value] * jet[ij] + jet[i] * jet[j]); };
        error = std::max({error, defect(spline::d11, spline::d1, spline::d1),
                          defect(spline::d22, spline::d2, spline::d2),
                          defect(spline::d12, spline::d1, spline::d2)});
      }
    tests::check("second derivatives on a sphere", error, 1e-12);
  }
} // namespace

int main()
{
  const spline::Surface surface = test_surface();
  check_element(surface, 0);
  check_element(surface, 1);
  check_sphere();

  spline::BasisValues basis;
  evaluate_basis(surface, 1, {0.5, 0.5}, basis); // the larger element first
  const double *const memory = basis.values[spline::d12].data();
  evaluate_basis(surface, 0, {0.1, 0.5}, basis);
  tests::log() << "functions: " << basis.values[spline::d12].size()
               << ", memory reused: " << (memory == basis.values[spline::d12].data()) << std::endl;
}
