// SPDX-License-Identifier: LGPL-2.1-or-later
// Projection on patches against dense sampling and the conditions of a constrained minimum.
#include "../tests.h"
#include <semilunar/spline/closest_point.h>
#include <semilunar/spline/primitives.h>

#include <algorithm>
#include <limits>
#include <random>

using namespace semilunar;
using spline::BezierPatch;
using spline::Point;
using spline::Projection;
using spline::Tensor;

namespace
{
  std::mt19937 generator(11);

  double random_number(const double low, const double high)
  {
    return low + (high - low) * std::uniform_real_distribution<double>()(generator);
  }

  Tensor<1, 3> vector(const double x, const double y, const double z)
  {
    return Point<3>(x, y, z);
  }

  /// A wavy rational patch over about [0,1]^2.
  BezierPatch random_patch(const std::array<unsigned int, 2> &degree)
  {
    BezierPatch patch{degree, {}};
    for (unsigned int j = 0; j <= degree[1]; ++j)
      for (unsigned int i = 0; i <= degree[0]; ++i)
      {
        const double w = random_number(0.5, 1.5);
        patch.coefficients.push_back({{w * (double(i) / degree[0] + random_number(-0.15, 0.15)),
                                       w * (double(j) / degree[1] + random_number(-0.15, 0.15)),
                                       w * random_number(-0.4, 0.4), w}});
      }
    return patch;
  }

  struct Nearest
  {
    Point<2> xi;
    double distance = std::numeric_limits<double>::infinity();
  };

  Nearest dense_sampling(const BezierPatch &patch, const Tensor<1, 3> &x, const unsigned int n)
  {
    Nearest result;
    for (unsigned int j = 0; j <= n; ++j)
      for (unsigned int i = 0; i <= n; ++i)
      {
        const Point<2> xi(double(i) / n, double(j) / n);
        const double distance = (spline::evaluate(patch, xi)[spline::value] - x).norm();
        if (distance < result.distance)
          result = {xi, distance};
      }
    return result;
  }

  /// How far, in xi, a coordinate is from where the distance cannot decrease any more; infinite if
  /// at_boundary says something that is not so.
  double misplacement(const Projection &p, const Tensor<1, 3> &x, const unsigned int k)
  {
    const Tensor<1, 3> &tangent = p.foot[spline::d1 + k];
    const double descent = (x - p.foot[spline::value]) * tangent / tangent.norm_square();
    const bool outward = (p.xi[k] == 0. && descent < 0.) || (p.xi[k] == 1. && descent > 0.);
    if (p.at_boundary[k])
      return outward ? 0. : std::numeric_limits<double>::infinity();
    return std::abs(descent);
  }

  void check_random(const std::array<unsigned int, 2> &degree, const unsigned int n_patches)
  {
    constexpr unsigned int n = 40;
    std::array<unsigned int, 3> n_held{};
    double excess = 0., misplaced = 0., lost = 0.;
    for (unsigned int i = 0; i < n_patches; ++i)
    {
      const BezierPatch patch = random_patch(degree);
      const Tensor<1, 3> x =
          vector(random_number(-0.3, 1.3), random_number(-0.3, 1.3), random_number(-0.6, 0.6));
      const Nearest sampled = dense_sampling(patch, x, n);
      const Projection p = project(patch, x, sampled.xi);
      excess = std::max(excess, p.distance - sampled.distance);
      lost = std::max(lost, (sampled.distance - p.distance) / (1. / n));
      for (unsigned int k = 0; k < 2; ++k)
        misplaced = std::max(misplaced, misplacement(p, x, k));
      ++n_held[p.at_boundary[0] + p.at_boundary[1]];
    }
    tests::check("not farther than the nearest sample", excess, 1e-14);
    tests::check("distance between samples and foot, per sample width", lost, 1.);
    tests::check("foot in xi", misplaced, 1e-11);
    tests::log() << "feet inside, on an edge, at a corner: " << n_held[0] << ' ' << n_held[1] << ' '
                 << n_held[2] << std::endl;
  }

  /// Points above and below a sphere: the foot is known, even from starts at the far corner.
  void check_sphere()
  {
    spline::NurbsPatch sphere = spline::sphere(1., 0., 1.2, -0.5, 0.5);
    sphere.elevate_degree(0);
    sphere.elevate_degree(1);
    const spline::Surface surface = to_surface(sphere);
    const BezierPatch patch = bezier_patch(surface, 0, positions(surface));
    double distance = 0., foot = 0., closest = 0.;
    for (unsigned int i = 0; i < 100; ++i)
    {
      const double longitude = random_number(0.05, 1.15), latitude = random_number(-0.45, 0.45);
      const double radius = i % 2 == 0 ? random_number(1.0001, 3.) : random_number(0.6, 0.9999);
      const Tensor<1, 3> normal =
          vector(std::cos(longitude) * std::cos(latitude), std::sin(longitude) * std::cos(latitude),
                 std::sin(latitude));
      const Projection p = project(patch, radius * normal, {0., 1.});
      distance = std::max(distance, std::abs(p.distance - std::abs(radius - 1.)));
      foot = std::max(foot, (p.foot[spline::value] - normal).norm());
      closest = std::max(
          closest, std::abs(closest_point(surface, positions(surface), radius * normal).distance -
                            std::abs(radius - 1.)));
    }
    tests::check("sphere: distance", distance, 1e-13);
    tests::check("sphere: foot", foot, 1e-12);
    tests::check("sphere: closest point", closest, 1e-13);
  }

  /// Above the valley of a symmetric gutter, farther than its centre of curvature: the middle is a
  /// stationary point, but the nearest points are at the rims.
  void check_escape()
  {
    const spline::Surface gutter = to_surface(spline::cylinder(1., -0.5, 0.5, 0., 1.));
    const BezierPatch patch = bezier_patch(gutter, 0, positions(gutter));
    const Projection p = project(patch, vector(-0.5, 0., 0.5), {0.5, 0.5});
    const double exact = std::hypot(std::cos(0.5) + 0.5, std::sin(0.5));
    tests::check("escape from a maximum of the distance", p.distance - exact, 1e-13);
    tests::log() << "held: " << p.at_boundary[0] << ' ' << p.at_boundary[1] << std::endl;
  }

  /// Where the two edges of a patch meet in a pole, one tangent vanishes.
  void check_pole()
  {
    const spline::Surface cap = to_surface(spline::sphere(1., 0., M_PI / 2., 0., M_PI / 2.));
    const BezierPatch patch = bezier_patch(cap, 0, positions(cap));
    const Projection p = project(patch, vector(0., 0., 1.5), {0.4, 0.6});
    tests::check("pole of a sphere", p.distance - 0.5, 1e-13);
  }

  void check_whole_surface()
  {
    std::vector<spline::ControlPoint> net;
    for (unsigned int j = 0; j < 7; ++j)
      for (unsigned int i = 0; i < 8; ++i)
        net.push_back({Point<3>(i, j, random_number(-1.5, 1.5)), random_number(0.5, 2.)});
    const spline::Surface surface = to_surface(spline::NurbsPatch(
        {{spline::KnotVector::uniform(3, 5), spline::KnotVector::uniform(2, 5)}}, net));
    const auto x = positions(surface);

    double excess = 0., lost = 0., point = 0.;
    for (unsigned int i = 0; i < 50; ++i)
    {
      const Tensor<1, 3> target =
          vector(random_number(-2., 9.), random_number(-2., 8.), random_number(-3., 3.));
      Nearest nearest;
      for (unsigned int e = 0; e < surface.elements.size(); ++e)
      {
        const Nearest sampled = dense_sampling(bezier_patch(surface, e, x), target, 20);
        if (sampled.distance < nearest.distance)
          nearest = sampled;
      }
      const auto closest = closest_point(surface, x, target);
      const auto jet = spline::evaluate(surface, closest.point);
      point = std::max(point, std::abs((jet[spline::value] - target).norm() - closest.distance));
      excess = std::max(excess, closest.distance - nearest.distance);
      lost = std::max(lost, nearest.distance - closest.distance);
    }
    tests::check("whole surface: not farther than the nearest sample", excess, 1e-13);
    tests::check("whole surface: near the nearest sample", lost, 0.05);
    tests::check("whole surface: point and distance agree", point, 1e-13);
  }
} // namespace

int main()
{
  check_random({{3, 3}}, 300);
  check_random({{2, 4}}, 100);
  check_sphere();
  check_escape();
  check_pole();
  check_whole_surface();
}
