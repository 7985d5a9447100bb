// SPDX-License-Identifier: LGPL-2.1-or-later
// The search against the nearest point by brute force, its cost under refinement, contact of a
// folded strip with itself, and configurations of a diverging iteration.
#include <semilunar/shell/free_sides.h>
#include <semilunar/spline/closest_point.h>

#include <limits>

#include "../tests.h"
#include "contact_cases.h"

using namespace semilunar;
using namespace semilunar::tests;

namespace
{
  ContactParameters parameters(const double distance)
  {
    ContactParameters p;
    p.distance = distance;
    p.stiffness = 1e7;
    p.smoothing = 0.;
    return p;
  }

  Surface bowl(const unsigned int n)
  {
    Surface surface = plate({-1, -1, 0}, 2., 2., n, n);
    for (spline::ControlPoint &point : surface.control_points)
    {
      auto &x = point.position;
      x[2] = 0.5 * (x[0] * x[0] + x[1] * x[1]) + 0.05 * std::sin(5. * x[0]);
    }
    return surface;
  }

  Surface ball(const unsigned int n)
  {
    Surface surface =
        refined(spline::sphere(0.9, 0., 2. * dealii::numbers::PI / 3., -1.4, 0.5), n, n);
    for (spline::ControlPoint &point : surface.control_points)
      point.position[2] += 1.;
    return surface;
  }

  void against_brute_force()
  {
    // the ball hangs in the bowl: feet inside, at edges and at corners, on coarse elements
    const Surface first = bowl(3), second = ball(3);
    const Surface all = together(first, second);
    const QuadraturePoints points(all);
    const double reach = 0.3;
    shell::ContactSearch search(all, points, reach, 0.);
    search.update(positions(all));

    const std::array<Surface, 2> parts{{first, second}};
    const std::array<Vectors, 2> x{{positions(first), positions(second)}};
    std::vector<shell::ContactSearch::Neighbor> neighbors;
    double difference = 0., missed = 0., found = 0.;
    for (unsigned int q = 0; q < points.n_points(); ++q)
    {
      const unsigned int other = 1 - search.part(points.element(q));
      const double nearest = closest_point(parts[other], x[other], search.position(q)).distance;
      search.find(q, neighbors);
      if ((nearest < reach) != !neighbors.empty())
        ++missed;
      else if (!neighbors.empty())
      {
        difference = std::max(difference, std::abs(neighbors[0].foot.distance - nearest));
        ++found;
      }
    }
    log() << "ball in a bowl: " << (found > 100 ? "many" : "FEW") << " points within reach"
          << std::endl;
    check("  neighbors missed or invented", missed, 0.);
    check("  distance to the nearest point", difference, 1e-12);
  }

  void cost()
  {
    for (const unsigned int n : {8, 16, 32})
    {
      Surface upper = bowl(n + 1);
      for (spline::ControlPoint &point : upper.control_points)
        point.position[2] += 0.05;
      Pair pair(bowl(n), upper, parameters(0.06));
      pair.contact.update(pair.x);
      const double per_point =
          double(pair.contact.n_projections()) / pair.contact.contact_points().size();
      log() << "two bowls of " << n << "^2 elements: projections per point within reach "
            << (per_point >= 1. && per_point < 1.8 ? "between 1 and 1.8" : "OUT OF BOUNDS")
            << std::endl;
    }
  }

  void sides()
  {
    const auto count = [](const Surface &surface)
    {
      unsigned int n = 0;
      for (const auto &element : shell::free_sides(surface))
        for (const bool is_free : element)
          n += is_free;
      return n;
    };
    log() << "free sides of 3 x 4 elements: " << count(plate({0, 0, 0}, 1., 2., 3, 4))
          << ", of a closed tube of 8 x 2: "
          << count(refined(spline::cylinder(1., 0., 2. * dealii::numbers::PI, 0., 1.), 8, 2))
          << std::endl;
    // one element on the left, two on the right, with a T-junction between
    Surface surface = plate({0, 0, 0}, 1., 1., 1, 1);
    append(surface, plate({1, 0, 0}, 1., 1., 1, 2), -1.);
    log() << "free sides of one element beside two: " << count(surface) << std::endl;
  }

  /// The strip [-1, 1] folded at x = 0 into layers at z = 0 and z = height.
  Vectors folded(const Surface &strip, const double height)
  {
    Vectors x = positions(strip);
    const double radius = 0.5 * height, half_length = 0.5 * dealii::numbers::PI * radius;
    for (auto &p : x)
    {
      const double s = p[0];
      if (std::abs(s) > half_length)
      {
        p[0] = std::abs(s) - half_length;
        p[2] = s < 0. ? 0. : height;
      }
      else
      {
        p[0] = -radius * std::cos(s / radius);
        p[2] = radius * (1. + std::sin(s / radius));
      }
    }
    return x;
  }

  void fold()
  {
    const double height = 0.04, contact_distance = 0.05, self_distance = 0.2;
    const Surface strip = plate({-1, 0, 0}, 2., 0.3, 160, 2);
    const QuadraturePoints points(strip);
    ContactParameters p = parameters(contact_distance);
    Contact blind(strip, points, p);
    blind.update(folded(strip, height));
    log() << "folded strip: " << blind.contact_points().size() << " contacts without self contact"
          << std::endl;

    p.self_distance = self_distance;
    Contact contact(strip, points, p);
    contact.update(positions(strip));
    check("flat strip: energy", contact.energy(), 0.);
    const Vectors x = folded(strip, height);
    contact.update(x);
    // layers closer than the self distance along the strip are left out
    const double area = 0.3 * (2. - self_distance);
    check("folded strip: contact area", contact.contact_areas()[0] / area - 1., 0.02);
    check("folded strip: penetration in the layers",
          contact.pressures()[0] / (p.stiffness * (contact_distance - height)) - 1., 1e-9);
    Vectors g(x.size());
    contact.add_gradient(g);
    Tensor<1, 3> sum, moment, lift;
    for (unsigned int i = 0; i < x.size(); ++i)
    {
      sum += g[i];
      moment += cross_product_3d(x[i], g[i]);
      if (x[i][2] > 0.5 * height)
        lift -= g[i];
    }
    check("folded strip: sum of forces", sum.norm() / lift.norm(), 1e-12);
    check("folded strip: sum of moments", moment.norm() / lift.norm(), 1e-12);
    check("folded strip: lift of the upper layer over pressure times area",
          lift[2] / (p.stiffness * (contact_distance - height) * 0.5 * area) - 1., 0.02);
  }

  void diverged()
  {
    Pair pair(plate({0, 0, 0}, 1., 1., 8, 8), plate({0, 0, 0.05}, 1., 1., 8, 8), parameters(0.02));
    pair.x[5][0] = 1e12;
    pair.contact.update(pair.x);
    log() << "a control point far away: energy "
          << (std::isfinite(pair.contact.energy()) ? "finite" : "not finite") << std::endl;
    pair.x[5][0] = std::numeric_limits<double>::quiet_NaN();
    pair.contact.update(pair.x);
    log() << "a control point at no number: energy "
          << (std::isfinite(pair.contact.energy()) ? "finite" : "not finite") << ", "
          << pair.contact.contact_points().size() << " contact points" << std::endl;
  }
} // namespace

int main()
{
  against_brute_force();
  cost();
  sides();
  fold();
  diverged();
}
