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
  using spline::TSpline;

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
    /// The first leaflet in the circular design from a surface with the sets of to_surface().
    Surface named(Surface surface)
    {
      surface.sets = leaflet_sets(surface);
      name_leaflet(surface, 1);
      return surface;
    }

    Surface named_leaflet(const TSpline &first)
    {
      return named(spline::to_surface(first, "Valve/T-spline"));
    }

    /// The first leaflet in the circular design, with the sets of leaflets().
    Surface named_leaflet(const Design &design)
    {
      if (design.layout == LeafletLayout::t_spline)
        return named_leaflet(leaflet_t_spline(design));
      if (design.layout == LeafletLayout::unstructured)
      {
        Surface surface = leaflet_unstructured(design);
        name_leaflet(surface, 1);
        return surface;
      }
      NurbsPatch patch = leaflet_patch(design);
      refine(patch, 0, design.n_elements_along);
      refine(patch, 1, design.n_elements_across);
      return named(spline::to_surface(patch));
    }

    Surface deployed(Surface surface, const Design &design)
    {
      deploy(surface.control_points, design);
      return surface;
    }

    /// Copies of the first leaflet of the circular design, in place.
    Surface all_leaflets(const Surface &first, const Design &design)
    {
      Surface all;
      for (unsigned int k = 0; k < design.n_leaflets; ++k)
      {
        Surface surface = first;
        turn(surface.control_points, k, design.n_leaflets);
        surface.sets.resize(first.sets.size() - 2);
        name_leaflet(surface, k + 1);
        const double merge_nothing = -1.;
        spline::append(all, surface, merge_nothing);
      }
      return deployed(std::move(all), design);
    }
  } // namespace

  Surface leaflet(const Design &design)
  {
    return deployed(named_leaflet(design), design);
  }

  Surface leaflet(const Design &design, const TSpline &first)
  {
    return deployed(named_leaflet(first), design);
  }

  Surface leaflets(const Design &design)
  {
    return all_leaflets(named_leaflet(design), design);
  }

  Surface leaflets(const Design &design, const TSpline &first)
  {
    return all_leaflets(named_leaflet(first), design);
  }
} // namespace semilunar::valve
