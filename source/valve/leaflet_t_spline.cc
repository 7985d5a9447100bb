// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/valve/element_sizes.h>
#include <semilunar/valve/leaflet_t_spline.h>
#include <semilunar/valve/leaflets.h>
#include <semilunar/valve/refine.h>

#include <algorithm>
#include <limits>

namespace semilunar::valve
{
  using spline::Point;

  namespace
  {
    /// Points of the edge of the parameter space from one corner to another; with an odd number of
    /// them, symmetric edges have symmetric points.
    std::vector<Point<3>> edge_points(const spline::NurbsPatch &patch, const Point<2> &begin,
                                      const Point<2> &end)
    {
      constexpr unsigned int n = 129;
      std::vector<Point<3>> points;
      for (unsigned int k = 0; k < n; ++k)
        points.push_back(patch.evaluate(begin + k / (n - 1.) * (end - begin)));
      return points;
    }

    /// A zone and the points that it surrounds.
    struct Surroundings
    {
      RefinementZone zone;
      std::vector<Point<3>> points;

      /// Whether elements halved so often in each direction shall be halved again around x.
      bool hold(const Point<3> &x, const unsigned int n_halvings) const
      {
        if (n_halvings >= zone.levels)
          return false;
        constexpr double mirror_images = 1. + 1e-9; // are refined alike
        const double reach = mirror_images * zone.width / (1u << n_halvings);
        return std::any_of(points.begin(), points.end(),
                           [&](const Point<3> &p) { return x.distance_square(p) < reach * reach; });
      }
    };

    std::vector<Surroundings> surroundings(const spline::NurbsPatch &patch,
                                           const RefinementZones &zones)
    {
      std::vector<Point<3>> attachment = edge_points(patch, {0., 0.}, {1., 0.});
      for (const double u : {0., 1.})
      {
        const auto post = edge_points(patch, {u, 0.}, {u, 1.});
        attachment.insert(attachment.end(), post.begin(), post.end());
      }
      return {{zones.attachment, attachment},
              {zones.commissures, {patch.evaluate({0., 1.}), patch.evaluate({1., 1.})}},
              {zones.free_edge, edge_points(patch, {0., 1.}, {1., 1.})}};
    }
  } // namespace

  spline::TSpline leaflet_t_spline(const Design &design)
  {
    const spline::NurbsPatch coarsest = leaflet_patch(design);
    const std::vector<Surroundings> zones = surroundings(coarsest, design.zones);
    spline::NurbsPatch grid = coarsest;
    refine(grid, 0, design.zones.n_elements_along);
    refine(grid, 1, design.zones.n_elements_across);
    spline::TSpline leaflet(grid);
    leaflet.refine_where(
        [&](const Point<2> &low, const Point<2> &high, const unsigned int level)
        {
          const auto held = [&](const double s, const double t)
          {
            const Point<2> u(low[0] + s * (high[0] - low[0]), low[1] + t * (high[1] - low[1]));
            const Point<3> x = coarsest.evaluate(u);
            return std::any_of(zones.begin(), zones.end(),
                               [&](const Surroundings &zone) { return zone.hold(x, level / 2); });
          };
          return held(0.5, 0.5) || held(0., 0.) || held(1., 0.) || held(0., 1.) || held(1., 1.);
        });
    if (!design.zones.sizes_file.empty())
    {
      const ElementSizes sizes(design.zones.sizes_file);
      leaflet.refine_where([&](const Point<2> &low, const Point<2> &high, unsigned int)
                           { return sizes.is_too_large(low, high); });
    }
    return leaflet;
  }
} // namespace semilunar::valve
