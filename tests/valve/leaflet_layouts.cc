// SPDX-License-Identifier: LGPL-2.1-or-later
// Leaflets as T-splines refined in zones: the same surface, symmetric, elements where they were
// asked for; posts that lean, and stents that are oval or not fully expanded.
#include "../tests.h"
#include "mirror_images.h"

#include <semilunar/core/exceptions.h>
#include <semilunar/spline/boundary_rows.h>
#include <semilunar/spline/closest_point.h>
#include <semilunar/spline/t_junctions.h>
#include <semilunar/valve/deployment.h>
#include <semilunar/valve/leaflet_t_spline.h>
#include <semilunar/valve/leaflets.h>
#include <semilunar/valve/stent.h>

#include <algorithm>
#include <functional>

using namespace semilunar;
using namespace semilunar::spline;
using tests::check;
using tests::log;
using valve::Design;

namespace
{
  const double pi = dealii::numbers::PI;

  void t_spline_leaflet()
  {
    Design design;
    design.layout = valve::LeafletLayout::t_spline;
    design.zones.free_edge.levels = 1;
    const NurbsPatch patch = valve::leaflet_patch(design);
    const TSpline leaflet = valve::leaflet_t_spline(design);
    const Surface surface = to_surface(leaflet);
    const auto boxes = bezier_boxes(leaflet.mesh());
    double error = 0.;
    for (unsigned int b = 0; b < boxes.size(); ++b)
    {
      const Point<2> xi(0.3, 0.8);
      Point<2> u;
      for (unsigned int d = 0; d < 2; ++d)
        u[d] = (1. - xi[d]) * leaflet.parameter(d, boxes[b].low[d]) +
               xi[d] * leaflet.parameter(d, boxes[b].high[d]);
      error = std::max(error, patch.evaluate(u).distance(Point<3>(evaluate(surface, {b, xi})[0])));
    }
    check("same surface", error / design.radius, 1e-13);

    check("mirrored control points", tests::asymmetry(surface), 1e-13);
    log() << "T-spline: " << leaflet.mesh().n_active() << " elements, " << surface.elements.size()
          << " Bezier elements, " << surface.control_points.size() << " control points, "
          << crossings(leaflet.mesh()).size() << " crossings" << std::endl;
  }

  /// Largest and smallest extent of elements that touch a point.
  void sizes()
  {
    for (const unsigned int levels : {0u, 1u, 3u})
    {
      Design design;
      design.zones.attachment.levels = 0;
      design.zones.commissures.levels = levels;
      const TSpline leaflet = valve::leaflet_t_spline(design);
      const TMesh &mesh = leaflet.mesh();
      const auto &corner = mesh.element(mesh.find({{0, mesh.end(1)}}, 1, -1));
      const auto &middle = mesh.element(mesh.find({{mesh.end(0) / 2, mesh.end(1) / 2}}, 1, 1));
      log() << levels << " levels: element at the commissure halved " << corner.level
            << " times, in the middle " << middle.level << std::endl;
    }
  }

  void node_sets()
  {
    Design design;
    design.layout = valve::LeafletLayout::t_spline;
    const Surface surface = valve::leaflets(design);
    spline::check(surface, "leaflets");
    const auto &attachment = surface.find_set(SetKind::node, "attachment")->members;
    const auto sides = boundary_sides(surface, attachment);
    const auto same = [](std::vector<unsigned int> a, std::vector<unsigned int> b)
    {
      std::sort(a.begin(), a.end());
      std::sort(b.begin(), b.end());
      return a == b;
    };
    log() << "attachment is row 0 of its sides: "
          << same(control_row(surface, sides, 0), attachment) << ", nextAttachment row 1: "
          << same(control_row(surface, sides, 1),
                  surface.find_set(SetKind::node, "nextAttachment")->members)
          << std::endl;
  }

  double bound_of(const Surface &surface, const std::function<double(const Point<3> &)> &f)
  {
    double largest = -1e300;
    for (unsigned int e = 0; e < surface.elements.size(); ++e)
      for (unsigned int k = 0; k < 25; ++k)
        largest =
            std::max(largest, f(Point<3>(evaluate(surface, {e, {k % 5 / 4., k / 5 / 4.}})[value])));
    return largest;
  }

  /// Posts lean about their feet and stay as far apart as they were.
  void lean()
  {
    Design design;
    design.post_lean = 12.;
    const NurbsPatch patch = valve::leaflet_patch(design);
    const Point<3> top = patch.evaluate({1., 1.}), foot = patch.evaluate({1., 0.});
    const double radius = std::hypot(top[0], top[1]);
    check("lean",
          (std::hypot(foot[0], foot[1]) - radius) / (top[2] - foot[2]) - std::tan(12. * pi / 180.),
          1e-13);
    const double turned = 2. * pi / 3. - std::atan2(top[1], top[0]);
    const Point<3> neighbor(radius * std::cos(turned), radius * std::sin(turned), top[2]);
    check("posts as wide as before", neighbor.distance(top) - design.post_width, 1e-13);
    const Surface stent = valve::stent(design);
    const std::vector<unsigned int> parts = connected_parts(stent);
    log() << "leaning stent: " << 1 + *std::max_element(parts.begin(), parts.end()) << " part"
          << std::endl;
    double off = 0.; // commissure line of the leaflet from the stent's edge
    for (unsigned int k = 0; k <= 10; ++k)
    {
      const Point<3> x = patch.evaluate({1., k / 10.});
      off = std::max(off, closest_point(stent, positions(stent), x).distance);
    }
    check("leaflets meet leaning posts", off, 1e-10);
  }

  /// The oval stent has the circumference of the round one, all parts move alike.
  void oval()
  {
    Design design;
    design.ellipticity = 0.7;
    design.ellipse_direction = 30.;
    design.expansion = 0.9;
    const valve::CrossSection section = valve::cross_section(design);
    double circumference = 0.;
    const unsigned int n = 100; // the midpoint rule is exact for smooth periodic functions
    for (unsigned int k = 0; k < n; ++k)
    {
      const double t = 2. * pi * (k + 0.5) / n;
      circumference += std::hypot(section.longer * std::sin(t), section.shorter * std::cos(t)) / n;
    }
    check("circumference", circumference - 0.9, 1e-12);
    check("ellipticity", section.shorter / section.longer - 0.7, 1e-14);
    const double c = std::cos(pi / 6.), s = std::sin(pi / 6.), R = design.radius;
    const auto off_ellipse = [&](const Point<3> &x)
    {
      return std::hypot((c * x[0] + s * x[1]) / (R * section.longer),
                        (c * x[1] - s * x[0]) / (R * section.shorter)) -
             1.;
    };
    check("leaflets inside", std::max(0., bound_of(valve::leaflets(design), off_ellipse)), 1e-12);
    std::vector<ControlPoint> points{{Point<3>(0.3, -0.2, 0.1), 1.}};
    valve::deploy(points, design);
    const auto back = valve::undeployed({points[0].position}, design)[0];
    check("there and back", (back - Point<3>(0.3, -0.2, 0.1)).norm(), 1e-15);
  }

  /// Control points of the stent that say the same with fewer.
  void straight_stent()
  {
    Design design;
    const Surface cubic = valve::stent(design);
    design.stent.degree_across = 1;
    const Surface linear = valve::stent(design);
    double error = 0.;
    for (unsigned int e = 0; e < cubic.elements.size(); e += 7)
      error = std::max(
          error,
          (evaluate(cubic, {e, {0.2, 0.6}})[0] - evaluate(linear, {e, {0.2, 0.6}})[0]).norm());
    check("linear across is the same stent", error, 1e-14);
    log() << "stent: " << linear.elements.size() << " elements, " << cubic.control_points.size()
          << " or " << linear.control_points.size() << " control points" << std::endl;
  }

  void impossible(const std::function<void(Design &)> &change)
  {
    Design design;
    change(design);
    try
    {
      design.check("Valve");
      log() << "ACCEPTED" << std::endl;
    }
    catch (const InputError &error)
    {
      log() << error.what() << std::endl;
    }
  }
} // namespace

int main()
{
  t_spline_leaflet();
  sizes();
  node_sets();
  lean();
  oval();
  straight_stent();
  impossible([](Design &d) { d.post_lean = 40.; });
  impossible([](Design &d) { d.post_lean = 30., d.commissure_height = 2.4; });
  impossible([](Design &d) { d.free_edge_gap = 0.8, d.post_lean = 20.; });
  impossible([](Design &d) { d.expansion = 0.4; });
  impossible([](Design &d) { d.ellipticity = 1.2; });
  impossible([](Design &d) { d.ellipse_direction = std::nan(""); });
  impossible([](Design &d) { d.zones.n_elements_along = 9; });
  impossible([](Design &d) { d.zones.attachment.width = 0.; });
  impossible([](Design &d) { d.zones.commissures.levels = 11; });
}
