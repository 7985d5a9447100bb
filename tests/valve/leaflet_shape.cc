// SPDX-License-Identifier: LGPL-2.1-or-later
// The default leaflets: named points, boundary curves, clearance, symmetry, area, orientation, and
// the distance from the published valve of the same family.
#include "../tests.h"

#include <semilunar/spline/closest_point.h>
#include <semilunar/valve/leaflets.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>

using namespace semilunar;
using dealii::Point;
using dealii::Tensor;
using tests::check;

const double pi = dealii::numbers::PI;

double angle(const Point<3> &x)
{
  return std::atan2(x[1], x[0]);
}

double radius(const Point<3> &x)
{
  return std::hypot(x[0], x[1]);
}

void named_points(const valve::Design &design, const spline::NurbsPatch &patch)
{
  const Point<3> tip = patch.evaluate({0.5, 1.}), nadir = patch.evaluate({0.5, 0.});
  const Point<3> commissure = patch.evaluate({1., 1.}), foot = patch.evaluate({1., 0.});
  tests::log() << "free edge middle, nadir, commissure, post foot: r, z, angle [deg]" << std::endl;
  for (const Point<3> &x : {tip, nadir, commissure, foot})
    tests::log() << radius(x) << "  " << x[2] << "  " << angle(x) * 180. / pi << std::endl;
  check("tip at gap and height", tip.distance(Point<3>(0.033, 0., 0.852)), 1e-14);
  check("nadir", nadir.distance(Point<3>(1.1175, 0., 0.096)), 1e-14);
  check("commissure height", commissure[2] - 0.94, 1e-14);
  check("post foot height", foot[2] - 0.33, 1e-14);
  Point<3> neighbor(commissure);
  const double turned = 2. * pi / 3. - angle(commissure);
  neighbor[0] = design.radius * std::cos(turned);
  neighbor[1] = design.radius * std::sin(turned);
  check("post width", commissure.distance(neighbor) - 0.031, 1e-14);

  // belly 1: the profile leaves the free edge downward and reaches the nadir along the line from
  // the corner at the belly height, apart from the rounding of the tip
  const double h = 1e-5;
  const Tensor<1, 3> down = patch.evaluate({0.5, 1. - h}) - tip;
  const Tensor<1, 3> out = patch.evaluate({0.5, h}) - nadir;
  tests::log() << "slope of the middle profile at the free edge, dr/dz: " << std::setprecision(3)
               << down[0] / down[2] << std::endl;
  tests::log() << "slope at the nadir, dz/dr: " << out[2] / out[0] << std::setprecision(8)
               << std::endl;
}

void boundary_curves(const valve::Design &design, const spline::NurbsPatch &patch)
{
  double off_cylinder = 0., off_plane = 0., off_post = 0., off_speed = 0.;
  const Point<3> foot = patch.evaluate({0., 0.}), nadir = patch.evaluate({0.5, 0.});
  const Point<3> commissure = patch.evaluate({0., 1.});
  for (unsigned int k = 0; k <= 200; ++k)
  {
    const double t = k / 200.;
    const Point<3> x = patch.evaluate({t, 0.}), y = patch.evaluate({0., t});
    const double share = (x[0] - nadir[0]) / (foot[0] - nadir[0]);
    const double plane = nadir[2] + share * (foot[2] - nadir[2]);
    off_cylinder = std::max(off_cylinder, std::abs(radius(x) / design.radius - 1.));
    off_plane = std::max(off_plane, std::abs(x[2] - plane));
    off_post = std::max(off_post, std::hypot(y[0] - foot[0], y[1] - foot[1]));
    off_speed = std::max(off_speed, std::abs(y[2] - foot[2] - t * (commissure[2] - foot[2])));
  }
  check("scallop on the cylinder", off_cylinder, 1e-14);
  check("scallop in a plane", off_plane, 1e-14);
  check("post vertical", off_post, 1e-14);
  check("post of constant speed", off_speed, 1e-14);
}

/// The smallest distance of all control points (hence of all points: their hull) from the two
/// planes between the leaflet and its neighbors.
double clearance(const spline::NurbsPatch &patch, const unsigned int n_leaflets)
{
  double smallest = 1e300;
  for (const spline::ControlPoint &point : patch.control_net())
    smallest = std::min(smallest, point.position[0] * std::sin(pi / n_leaflets) -
                                      std::abs(point.position[1]) * std::cos(pi / n_leaflets));
  return smallest;
}

void symmetry(const spline::Surface &leaflets)
{
  const auto &points = leaflets.control_points;
  const unsigned int n = points.size() / 3, n_along = 25;
  const double c = std::cos(2. * pi / 3.), s = std::sin(2. * pi / 3.);
  double mirrored = 0., turned = 0.;
  for (unsigned int i = 0; i < n; ++i)
  {
    const Point<3> x = points[i].position, y = points[n + i].position;
    const auto &image = points[i / n_along * n_along + n_along - 1 - i % n_along];
    mirrored = std::max(
        {mirrored, x.distance(Point<3>(image.position[0], -image.position[1], image.position[2])),
         std::abs(points[i].weight - image.weight)});
    turned = std::max(turned, y.distance(Point<3>(c * x[0] - s * x[1], s * x[0] + c * x[1], x[2])));
  }
  check("mirror symmetry", mirrored / 1.1175, 1e-14);
  check("turned by 120 degrees", turned / 1.1175, 1e-14);
}

struct Integrals
{
  double area = 0., projected = 0.; ///< of n and of n_z
  double smallest_jacobian = 1e300, largest_jacobian = 0.;
  double most_inward_normal = 1.; ///< smallest component of n along (1, 0, 1)/sqrt(2)
  double smallest_angle = pi;     ///< between a_1 and a_2
};

/// Over the first leaflet.
Integrals integrate(const spline::Surface &leaflets)
{
  Integrals sums;
  const dealii::QGauss<2> quadrature(5);
  for (const unsigned int e : leaflets.find_set(spline::SetKind::element, "leaflet1")->members)
    for (unsigned int q = 0; q < quadrature.size(); ++q)
    {
      const spline::SurfaceJet jet = spline::evaluate(leaflets, {e, quadrature.point(q)});
      const Tensor<1, 3> normal = dealii::cross_product_3d(jet[spline::d1], jet[spline::d2]);
      const double J = normal.norm();
      sums.area += J * quadrature.weight(q);
      sums.projected += normal[2] * quadrature.weight(q);
      sums.smallest_jacobian = std::min(sums.smallest_jacobian, J);
      sums.largest_jacobian = std::max(sums.largest_jacobian, J);
      sums.most_inward_normal =
          std::min(sums.most_inward_normal, (normal[0] + normal[2]) / (J * std::sqrt(2.)));
      sums.smallest_angle = std::min(
          sums.smallest_angle, std::asin(J / (jet[spline::d1].norm() * jet[spline::d2].norm())));
    }
  return sums;
}

/// Triangles between points of the surface, extrapolated.
double triangulated_area(const spline::NurbsPatch &patch)
{
  const auto area = [&patch](const unsigned int n)
  {
    double sum = 0.;
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
      {
        const auto at = [&](const unsigned int di, const unsigned int dj) {
          return patch.evaluate({double(i + di) / n, double(j + dj) / n});
        };
        const Point<3> a = at(0, 0), b = at(1, 0), c = at(0, 1), d = at(1, 1);
        sum += (dealii::cross_product_3d(b - a, c - a).norm() +
                dealii::cross_product_3d(b - d, c - d).norm()) /
               2.;
      }
    return sum;
  };
  return (4. * area(200) - area(100)) / 3.;
}

/// Green's theorem over the outline in plan view: positive if n points to +z.
double projected_area(const valve::Design &design, const spline::NurbsPatch &patch)
{
  double twice = 2. * design.radius * design.radius * design.half_angle();
  const unsigned int n = 4000;
  for (unsigned int k = 0; k < n; ++k)
  {
    const Point<3> a = patch.evaluate({1. - double(k) / n, 1.});
    const Point<3> b = patch.evaluate({1. - (k + 1.) / n, 1.});
    twice += a[0] * b[1] - a[1] * b[0];
  }
  return twice / 2.;
}

void areas(const valve::Design &design, const spline::NurbsPatch &patch,
           const spline::Surface &leaflets)
{
  const Integrals sums = integrate(leaflets);
  tests::log() << "leaflet area [cm^2]: " << sums.area << std::endl;
  tests::log() << "projected area [cm^2]: " << sums.projected << std::endl;
  check("area against triangles", sums.area - triangulated_area(patch), 1e-6);
  check("projected area against the outline", sums.projected - projected_area(design, patch), 1e-6);
  tests::log() << "Jacobian, largest by smallest: " << std::setprecision(3)
               << sums.largest_jacobian / sums.smallest_jacobian << std::endl;
  tests::log() << "smallest angle of parameter lines [deg]: " << sums.smallest_angle * 180. / pi
               << std::endl;
  tests::log() << "normal towards the aorta, smallest component: " << sums.most_inward_normal
               << std::setprecision(8) << std::endl;
}

/// Points of a published valve with nearly the same lengths (leaflet 1 of the "coarse" control net
/// of github.com/david-kamensky/CouDALFISh, evaluated where two knots meet).
void published_valve(const spline::Surface &leaflets)
{
  const std::vector<Point<3>> published{
      {0.4769, -0.7291, 0.8306}, {0.5625, -0.7450, 0.6541}, {0.6541, -0.7608, 0.4830},
      {0.7472, -0.7765, 0.3187}, {0.3688, -0.5389, 0.7817}, {0.4865, -0.5578, 0.5518},
      {0.6572, -0.5768, 0.3663}, {0.8452, -0.5955, 0.2321}, {0.2605, -0.3685, 0.7326},
      {0.3885, -0.3840, 0.4461}, {0.6252, -0.3993, 0.2501}, {0.8981, -0.4146, 0.1579},
      {0.1527, -0.1970, 0.6892}, {0.2868, -0.2046, 0.3561}, {0.5783, -0.2123, 0.1538},
      {0.9224, -0.2199, 0.1010}, {0.0806, 0.0000, 0.6657},  {0.2220, 0.0000, 0.3122},
      {0.5439, 0.0000, 0.1084},  {0.9261, 0.0000, 0.0757}};
  double sum = 0., largest = 0.;
  const auto positions = spline::positions(leaflets);
  for (const Point<3> &x : published)
  {
    const double distance = spline::closest_point(leaflets, positions, x).distance;
    sum += distance * distance;
    largest = std::max(largest, distance);
  }
  tests::log() << "distance from the published surface [cm], rms: " << std::setprecision(3)
               << std::sqrt(sum / published.size()) << ", largest: " << largest
               << std::setprecision(8) << std::endl;
}

int main()
{
  const valve::Design design;
  const spline::NurbsPatch patch = valve::leaflet_patch(design);
  const spline::Surface leaflets = valve::leaflets(design);
  spline::check(leaflets, "leaflets");
  tests::log() << "elements of a leaflet: " << leaflets.elements.size() / 3 << std::endl;

  named_points(design, patch);
  boundary_curves(design, patch);
  check("half a post width to the neighbors' planes", clearance(patch, 3) / 0.0155 - 1., 1e-12);
  symmetry(leaflets);
  areas(design, patch, leaflets);
  published_valve(leaflets);

  // the net's numbers are control points: its surface passes further out than the default
  valve::Design wider = design;
  wider.free_edge_gap = 0.0685;
  wider.free_edge_height = 0.858;
  published_valve(valve::leaflets(wider));
}
