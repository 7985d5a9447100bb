// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/spline/primitives.h>
#include <semilunar/valve/boundary_curves.h>
#include <semilunar/valve/deployment.h>
#include <semilunar/valve/refine.h>
#include <semilunar/valve/stent.h>
#include <semilunar/valve/turn.h>

#include <deal.II/base/numbers.h>

#include <cmath>
#include <numeric>

namespace semilunar::valve
{
  using spline::ControlPoint;
  using spline::KnotVector;
  using spline::NamedSet;
  using spline::NurbsPatch;
  using spline::SetKind;
  using spline::Surface;

  namespace
  {
    /// Common control points of two patches differ by round-off only, relative to R.
    constexpr double merge_tolerance = 1e-10;

    /// A spline curve.
    struct Curve
    {
      KnotVector knots;
      std::vector<ControlPoint> points;
    };

    Curve at_height(Curve curve, const double z)
    {
      for (ControlPoint &point : curve.points)
        point.position[2] = z;
      return curve;
    }

    /// Stretched from the axis, in its plane.
    Curve stretched(Curve curve, const double factor)
    {
      for (ControlPoint &point : curve.points)
        for (unsigned int d = 0; d < 2; ++d)
          point.position[d] *= factor;
      return curve;
    }

    /// The arc across the post behind the first leaflet's end at positive y, z = 0.
    Curve post_arc(const Design &design, const double radius, const double begin)
    {
      const double end = 2. * dealii::numbers::PI / design.n_leaflets - begin;
      NurbsPatch strip = spline::cylinder(radius, begin, end, 0., 1.);
      strip.elevate_degree(0, 3 - strip.knots(0).degree());
      Curve arc{strip.knots(0), {}};
      for (unsigned int i = 0; i < strip.n_control_points(0); ++i)
        arc.points.push_back(strip.control_point(i, 0));
      return arc;
    }

    /// The share of the way from one control point to the other in homogeneous coordinates.
    ControlPoint between(const ControlPoint &first, const ControlPoint &second, const double share)
    {
      if (share == 1.)
        return second;
      const auto way = second.position - first.position;
      if (first.weight == second.weight)
        return {first.position + share * way, first.weight};
      const double weight = first.weight + share * (second.weight - first.weight);
      return {first.position + share * second.weight / weight * way, weight};
    }

    /// The ruled patch between two curves with the same knots, (V7), cubic along the curves.
    NurbsPatch ruled(const Curve &first, const Curve &second, const unsigned int degree_across)
    {
      std::vector<ControlPoint> net;
      for (unsigned int j = 0; j <= degree_across; ++j)
        for (unsigned int i = 0; i < first.points.size(); ++i)
          net.push_back(between(first.points[i], second.points[i], double(j) / degree_across));
      return NurbsPatch({{first.knots, KnotVector::uniform(degree_across, 1)}}, net);
    }

    /// How the edges and elements of a patch are called.
    struct PatchNames
    {
      std::string elements;
      std::string bottom, top, sides; ///< empty: not in a set
    };

    void add_edge(Surface &to, const Surface &from, const std::string &side,
                  const std::string &name)
    {
      if (!name.empty())
        to.sets.push_back({SetKind::node, name, from.find_set(SetKind::node, side)->members});
    }

    /// A part of the stent behind one leaflet, unrefined.
    struct Part
    {
      NurbsPatch patch;
      std::array<unsigned int, 2> n_elements;
      PatchNames names;
    };

    std::vector<Part> parts(const Design &design)
    {
      const auto &n = design.stent;
      const BoundaryCurves curves = boundary_curves(design);
      const Curve scallop{curves.knots, curves.scallop};
      const Curve wall_foot = at_height(scallop, 0.);
      const Curve post_foot = post_arc(design, design.radius, design.half_angle());
      const Curve post_top =
          post_arc(design, design.commissure_radius(), design.half_commissure_angle());
      const double ring = n.ring_outer_radius / design.radius;
      const std::string edge = "leafletEdge", outer = "outerEdge";

      std::vector<Part> all;
      const auto add = [&](const Curve &first, const Curve &second, const unsigned int n_first,
                           const unsigned int n_second, const PatchNames &names) {
        all.push_back({ruled(first, second, n.degree_across), {{n_first, n_second}}, names});
      };
      add(wall_foot, scallop, n.n_elements_along, n.n_wall_elements, {"wall", "", edge, ""});
      add(post_foot, at_height(post_foot, design.post_foot_height), n.n_elements_across_post,
          n.n_wall_elements, {"posts", "", "", ""});
      add(at_height(post_foot, design.post_foot_height),
          at_height(post_top, design.commissure_height), n.n_elements_across_post,
          n.n_elements_up_post, {"posts", "", "", edge});
      // from outside inward, so that neighbors across the wall's foot have the same orientation
      add(stretched(wall_foot, ring), wall_foot, n.n_elements_along, n.n_ring_elements,
          {"ring", outer, "", ""});
      add(stretched(post_foot, ring), post_foot, n.n_elements_across_post, n.n_ring_elements,
          {"ring", outer, "", ""});
      return all;
    }

    /// Refine the part, name its edges and append a copy for each leaflet.
    void add_copies(Surface &stent, const Part &part, const Design &design)
    {
      NurbsPatch patch = part.patch;
      for (unsigned int d = 0; d < 2; ++d)
        refine(patch, d, part.n_elements[d]);
      const PatchNames &names = part.names;
      const Surface unnamed = spline::to_surface(patch);
      Surface named{unnamed.control_points, unnamed.elements, {}};
      NamedSet elements{SetKind::element, names.elements,
                        std::vector<unsigned int>(unnamed.elements.size())};
      std::iota(elements.members.begin(), elements.members.end(), 0u);
      named.sets.push_back(elements);
      add_edge(named, unnamed, "bottom", names.bottom);
      add_edge(named, unnamed, "top", names.top);
      add_edge(named, unnamed, "left", names.sides);
      add_edge(named, unnamed, "right", names.sides);

      for (unsigned int k = 0; k < design.n_leaflets; ++k)
      {
        Surface copy = named;
        turn(copy.control_points, k, design.n_leaflets);
        spline::append(stent, copy, merge_tolerance * design.radius);
      }
    }
  } // namespace

  Surface stent(const Design &design)
  {
    design.check();
    Surface stent;
    for (const Part &part : parts(design))
      add_copies(stent, part, design);
    deploy(stent.control_points, design);
    return stent;
  }

  std::vector<NurbsPatch> stent_patches(const Design &design)
  {
    design.check();
    std::vector<NurbsPatch> patches;
    for (const Part &part : parts(design))
      for (unsigned int k = 0; k < design.n_leaflets; ++k)
        patches.push_back(in_place(part.patch, k, design));
    return patches;
  }
} // namespace semilunar::valve
