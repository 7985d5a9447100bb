// SPDX-License-Identifier: LGPL-2.1-or-later
// The stent: watertight, of the areas that closed forms give, oriented; its edges are those of the
// leaflets.
#include "../tests.h"

#include <semilunar/spline/boundary_rows.h>
#include <semilunar/spline/closest_point.h>
#include <semilunar/valve/leaflets.h>
#include <semilunar/valve/stent.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <set>

using namespace semilunar;
using dealii::Point;
using dealii::Tensor;
using spline::SetKind;
using tests::check;

const double pi = dealii::numbers::PI;

std::set<unsigned int> members(const spline::Surface &surface, const SetKind kind,
                               const std::string &name)
{
  const auto &list = surface.find_set(kind, name)->members;
  return {list.begin(), list.end()};
}

struct Part
{
  double area = 0., off_shape = 0., outward = 1.;
};

/// Area, the largest distance from the cylinder or from the plane z = 0, and the smallest component
/// of the normal in the outward direction or along z.
Part integrate(const spline::Surface &stent, const std::string &name, const double radius)
{
  Part part;
  const dealii::QGauss<2> quadrature(6);
  for (const unsigned int e : members(stent, SetKind::element, name))
    for (unsigned int q = 0; q < quadrature.size(); ++q)
    {
      const auto jet = spline::evaluate(stent, {e, quadrature.point(q)});
      const Tensor<1, 3> x = jet[spline::value];
      const Tensor<1, 3> normal = dealii::cross_product_3d(jet[spline::d1], jet[spline::d2]);
      const double r = std::hypot(x[0], x[1]), J = normal.norm();
      const bool ring = name == "ring";
      const double outward = ring ? normal[2] / J : (normal[0] * x[0] + normal[1] * x[1]) / (r * J);
      part.area += J * quadrature.weight(q);
      part.off_shape = std::max(part.off_shape, ring ? std::abs(x[2]) : std::abs(r - radius));
      part.outward = std::min(part.outward, outward);
    }
  return part;
}

void shape(const valve::Design &design, const spline::Surface &stent)
{
  const double R = design.radius, a = design.half_angle(), n = design.n_leaflets;
  const double zn = design.nadir_height, zp = design.post_foot_height;
  // z = zn + (zp - zn) (1 - cos phi) / (1 - cos a), integrated over the arc
  const double wall =
      n * R * (2. * a * zn + (zp - zn) * 2. * (a - std::sin(a)) / (1. - std::cos(a)));
  const double posts = (2. * pi - 2. * n * a) * R * design.commissure_height;
  const double ring = pi * (std::pow(design.stent.ring_outer_radius, 2) - R * R);
  for (const auto &[name, exact] :
       {std::make_pair("wall", wall), std::make_pair("posts", posts), std::make_pair("ring", ring)})
  {
    const Part part = integrate(stent, name, R);
    tests::log() << name << " area [cm^2]: " << part.area << std::endl;
    check("  against the closed form", part.area / exact - 1., 1e-8);
    check("  on cylinder or plane", part.off_shape / R, 1e-13);
    check("  orientation", part.outward - 1., 1e-10);
  }
}

/// All edges that belong to one element only are those that should be open: towards the leaflets,
/// at the ring's outside and on top of the posts.
void watertight(const valve::Design &design, const spline::Surface &stent)
{
  std::set<unsigned int> open = members(stent, SetKind::node, "leafletEdge");
  open.merge(members(stent, SetKind::node, "outerEdge"));
  for (unsigned int i = 0; i < stent.control_points.size(); ++i)
    if (stent.control_points[i].position[2] > design.commissure_height - 1e-12)
      open.insert(i);
  unsigned int n_open = 0, n_leaks = 0;
  for (const spline::ElementSide &side : spline::boundary_sides(stent))
  {
    ++n_open;
    for (const unsigned int i : spline::control_row(stent.elements[side.element], side.side, 0))
      if (open.count(i) == 0)
      {
        ++n_leaks;
        break;
      }
  }
  const auto parts = spline::connected_parts(stent);
  tests::log() << "parts: " << *std::max_element(parts.begin(), parts.end()) + 1
               << ", open sides of elements: " << n_open << ", of which leaks: " << n_leaks
               << std::endl;
}

/// For each control point of the leaflets' attachment the nearest of the stent's leaflet edge.
double largest_difference(const spline::Surface &leaflets, const spline::Surface &stent)
{
  double largest = 0.;
  for (const unsigned int i : members(leaflets, SetKind::node, "attachment"))
  {
    double nearest = 1e300;
    for (const unsigned int k : members(stent, SetKind::node, "leafletEdge"))
      nearest = std::min(
          nearest,
          leaflets.control_points[i].position.distance(stent.control_points[k].position) +
              std::abs(leaflets.control_points[i].weight - stent.control_points[k].weight));
    largest = std::max(largest, nearest);
  }
  return largest;
}

/// Points of the leaflets' attachment edge projected on the stent.
double distance_between_edges(const spline::Surface &leaflets, const spline::Surface &stent)
{
  const auto positions = spline::positions(stent);
  const auto &edge = leaflets.find_set(SetKind::node, "attachment")->members;
  double largest = 0.;
  for (const spline::ElementSide &side : spline::boundary_sides(leaflets, edge))
    for (const double t : {0.1, 0.6})
    {
      const double across = side.side % 2;
      const Point<2> xi = side.side < 2 ? Point<2>(across, t) : Point<2>(t, across);
      const auto x = spline::evaluate(leaflets, {side.element, xi})[spline::value];
      largest = std::max(largest, spline::closest_point(stent, positions, x).distance);
    }
  return largest;
}

int main()
{
  valve::Design design;
  const spline::Surface stent = valve::stent(design);
  spline::check(stent, "stent");
  tests::log() << "elements: " << stent.elements.size() << std::endl;
  shape(design, stent);
  watertight(design, stent);

  check("edges apart, different elements",
        distance_between_edges(valve::leaflets(design), stent) / design.radius, 1e-12);
  for (const unsigned int n : {8, 22, 44})
  {
    design.n_elements_along = design.stent.n_elements_along = n;
    design.n_elements_across = design.stent.n_elements_up_post = 7;
    check("control points of edges with equal elements",
          largest_difference(valve::leaflets(design), valve::stent(design)), 1e-15);
  }
  valve::Design two_leaflets;
  two_leaflets.n_leaflets = 2;
  tests::log() << "two leaflets" << std::endl;
  shape(two_leaflets, valve::stent(two_leaflets));
  watertight(two_leaflets, valve::stent(two_leaflets));
}
