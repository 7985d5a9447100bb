// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/valve/boundary_curves.h>
#include <semilunar/valve/deployment.h>
#include <semilunar/valve/leaflet_t_spline.h>
#include <semilunar/valve/leaflet_unstructured.h>
#include <semilunar/valve/leaflets.h>
#include <semilunar/valve/refine.h>
#include <semilunar/valve/turn.h>

#include <numeric>
#include <set>

namespace semilunar::valve
{
  using spline::ControlPoint;
  using spline::NamedSet;
  using spline::NurbsPatch;
  using spline::Point;
  using spline::SetKind;
  using spline::Surface;

  namespace
  {
    /// The belly's strength (V6) at a distance from the symmetry plane: 1 there, 0 from the given
    /// width on, smooth between.
    double bump(const double distance, const double width)
    {
      const double s = distance / width;
      return s < 1. ? 1. - s * s * (3. - 2. * s) : 0.;
    }

    /// The four control points of the profile from the scallop to the free edge: the parabola
    /// whose end tangents meet in the corner (V6), as a cubic.
    std::array<Point<3>, 4> profile(const Point<3> &bottom, const Point<3> &corner,
                                    const Point<3> &top)
    {
      return {{bottom, bottom + 2. / 3. * (corner - bottom), top + 2. / 3. * (corner - top), top}};
    }

    /// A straight line of constant speed; equal coordinates of its ends stay equal to the last bit.
    std::array<Point<3>, 4> straight(const Point<3> &bottom, const Point<3> &top)
    {
      return {{bottom, bottom + 1. / 3. * (top - bottom), bottom + 2. / 3. * (top - bottom), top}};
    }

    /// The members of several sets, each once, but those of others.
    NamedSet united(const std::string &name, const Surface &surface,
                    const std::vector<std::string> &parts, const NamedSet &without)
    {
      std::set<unsigned int> members;
      for (const std::string &part : parts)
      {
        const std::vector<unsigned int> &more = surface.find_set(SetKind::node, part)->members;
        members.insert(more.begin(), more.end());
      }
      for (const unsigned int i : without.members)
        members.erase(i);
      return {SetKind::node, name, {members.begin(), members.end()}};
    }

    /// The node sets of a leaflet from those of its four edges.
    std::vector<NamedSet> leaflet_sets(const Surface &surface)
    {
      const NamedSet attachment =
          united("attachment", surface, {"left", "right", "bottom"}, {SetKind::node, "", {}});
      NamedSet free_edge = *surface.find_set(SetKind::node, "top");
      free_edge.name = "freeEdge";
      return {
          attachment,
          united("nextAttachment", surface, {"nextLeft", "nextRight", "nextBottom"}, attachment),
          free_edge};
    }

    NamedSet all_members(const SetKind kind, const std::string &name, const unsigned int n)
    {
      NamedSet set{kind, name, std::vector<unsigned int>(n)};
      std::iota(set.members.begin(), set.members.end(), 0u);
      return set;
    }

    /// Add the sets that hold all of a leaflet, as the last two.
    void name_leaflet(Surface &surface, const unsigned int number)
    {
      const std::string name = "leaflet" + std::to_string(number);
      surface.sets.push_back(all_members(SetKind::node, name, surface.control_points.size()));
      surface.sets.push_back(all_members(SetKind::element, name, surface.elements.size()));
    }
  } // namespace

  NurbsPatch leaflet_patch(const Design &design)
  {
    design.check();
    const BoundaryCurves curves = boundary_curves(design);
    const unsigned int n = curves.scallop.size();
    std::vector<ControlPoint> net(4 * n);
    for (unsigned int i = 0; i < n; ++i)
    {
      const Point<3> bottom = curves.scallop[i].position, top = curves.free_edge[i].position;
      const Point<3> middle = bottom + 0.5 * (top - bottom);
      const Point<3> below_edge(top[0], top[1], design.belly_height);
      const double strength =
          design.belly * bump(distance_from_middle(curves.knots, i), design.belly_width);
      const bool at_post = i == 0 || i == n - 1;
      const auto column = at_post ? straight(bottom, top)
                                  : profile(bottom, middle + strength * (below_edge - middle), top);
      for (unsigned int j = 0; j < 4; ++j)
        net[j * n + i] = {column[j], curves.scallop[i].weight};
    }
    return NurbsPatch({{curves.knots, spline::KnotVector::uniform(3, 1)}}, net);
  }

  namespace
  {
    /// The first leaflet in the circular design with the sets of to_surface().
    Surface circular_leaflet(const Design &design)
    {
      if (design.layout == LeafletLayout::t_spline)
        return spline::to_surface(leaflet_t_spline(design), "Valve/T-spline");
      NurbsPatch patch = leaflet_patch(design);
      refine(patch, 0, design.n_elements_along);
      refine(patch, 1, design.n_elements_across);
      return spline::to_surface(patch);
    }

    /// The same with the sets of leaflets().
    Surface named_leaflet(const Design &design)
    {
      Surface surface;
      if (design.layout == LeafletLayout::unstructured)
        surface = leaflet_unstructured(design);
      else
      {
        surface = circular_leaflet(design);
        surface.sets = leaflet_sets(surface);
      }
      name_leaflet(surface, 1);
      return surface;
    }
  } // namespace

  Surface leaflet(const Design &design)
  {
    Surface surface = named_leaflet(design);
    deploy(surface.control_points, design);
    return surface;
  }

  Surface leaflets(const Design &design)
  {
    Surface all;
    const Surface first = named_leaflet(design);
    for (unsigned int k = 0; k < design.n_leaflets; ++k)
    {
      Surface surface = first;
      turn(surface.control_points, k, design.n_leaflets);
      surface.sets.resize(first.sets.size() - 2);
      name_leaflet(surface, k + 1);
      const double merge_nothing = -1.;
      spline::append(all, surface, merge_nothing);
    }
    deploy(all.control_points, design);
    return all;
  }
} // namespace semilunar::valve
