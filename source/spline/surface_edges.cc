// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/spline/closest_point.h>
#include <semilunar/spline/surface_edges.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace semilunar::spline
{
  namespace
  {
    Point<2> point_on(const unsigned int side, const double t)
    {
      Point<2> xi;
      xi[side / 2] = side % 2;
      xi[1 - side / 2] = t;
      return xi;
    }

    /// Evaluates elements of a surface in its own configuration.
    class Patches
    {
    public:
      explicit Patches(const Surface &surface)
      {
        const std::vector<Tensor<1, 3>> x = positions(surface);
        for (unsigned int e = 0; e < surface.elements.size(); ++e)
          all.push_back(bezier_patch(surface, e, x));
      }

      SurfaceJet at(const ElementSide &side, const double t) const
      {
        return evaluate(all[side.element], point_on(side.side, t));
      }

      const BezierPatch &operator[](const unsigned int e) const { return all[e]; }

    private:
      std::vector<BezierPatch> all;
    };

    /// The parameter of the side nearest to x, by Newton's method on a smooth curve.
    double nearest(const Patches &patches, const ElementSide &side, const Tensor<1, 3> &x)
    {
      constexpr unsigned int n_steps = 30;
      const unsigned int along = side.side < 2 ? d2 : d1, twice = side.side < 2 ? d22 : d11;
      double t = 0.;
      double best = std::numeric_limits<double>::max();
      for (unsigned int k = 0; k <= 8; ++k)
        if (const double r = (patches.at(side, k / 8.)[value] - x).norm(); r < best)
        {
          best = r;
          t = k / 8.;
        }
      for (unsigned int step = 0; step < n_steps; ++step)
      {
        const SurfaceJet jet = patches.at(side, t);
        const Tensor<1, 3> r = jet[value] - x;
        const double slope = r * jet[along];
        const double curvature = jet[along] * jet[along] + std::max(0., r * jet[twice]);
        const double next = curvature > 0. ? std::clamp(t - slope / curvature, 0., 1.) : t;
        const bool converged = std::abs(next - t) < 1e-15;
        t = next;
        if (converged)
          break;
      }
      return t;
    }

    double chord(const Patches &patches, const ElementSide &side)
    {
      return (patches.at(side, 1.)[value] - patches.at(side, 0.)[value]).norm();
    }

    /// Do the middles of the shorter side and of the longer one touch?
    bool touch(const Patches &patches, const ElementSide &shorter, const ElementSide &longer,
               const double tolerance)
    {
      const Tensor<1, 3> x = patches.at(shorter, 0.5)[value];
      return (patches.at(longer, nearest(patches, longer, x))[value] - x).norm() <= tolerance;
    }

    double extent(const Surface &surface)
    {
      Point<3> low = surface.control_points[0].position, high = low;
      for (const ControlPoint &point : surface.control_points)
        for (unsigned int d = 0; d < 3; ++d)
        {
          low[d] = std::min(low[d], point.position[d]);
          high[d] = std::max(high[d], point.position[d]);
        }
      return low.distance(high);
    }
  } // namespace

  SurfaceEdges edges(const Surface &surface)
  {
    std::map<std::vector<unsigned int>, std::vector<ElementSide>> by_row;
    for (unsigned int e = 0; e < surface.elements.size(); ++e)
      for (unsigned int side = 0; side < 4; ++side)
      {
        std::vector<unsigned int> row = control_row(surface.elements[e], side, 0);
        std::sort(row.begin(), row.end());
        by_row[row].push_back({e, side});
      }
    const Patches patches(surface);
    constexpr double touching = 1e-6; // of the extent
    const double tolerance = touching * extent(surface);
    SurfaceEdges result;
    for (const auto &[row, sides] : by_row)
      for (unsigned int a = 0; a < sides.size(); ++a)
      {
        bool is_shared = false;
        for (unsigned int b = 0; b < sides.size(); ++b)
        {
          if (a == b)
            continue;
          const double length_a = chord(patches, sides[a]), length_b = chord(patches, sides[b]);
          const bool a_shorter = length_a < length_b || (length_a == length_b && a < b);
          const bool meet = a_shorter ? touch(patches, sides[a], sides[b], tolerance)
                                      : touch(patches, sides[b], sides[a], tolerance);
          is_shared = is_shared || meet;
          if (meet && a_shorter)
            result.shared.push_back({sides[a], sides[b]});
        }
        if (!is_shared)
          result.boundary.push_back(sides[a]);
      }
    return result;
  }

  Jumps jumps(const Surface &surface, const SurfaceEdges &edges)
  {
    const Patches patches(surface);
    const double size = extent(surface);
    Jumps result;
    for (const SharedEdge &edge : edges.shared)
    {
      double angle = 0.;
      for (const double t : {0.03, 0.5, 0.9})
      {
        const SurfaceJet a = patches.at(edge.first, t);
        const SurfaceJet b = patches.at(edge.second, nearest(patches, edge.second, a[value]));
        result.position = std::max(result.position, (a[value] - b[value]).norm() / size);
        const Tensor<1, 3> n = cross_product_3d(a[d1], a[d2]), m = cross_product_3d(b[d1], b[d2]);
        const double sine = cross_product_3d(n, m).norm() / (n.norm() * m.norm());
        angle = std::max(angle, std::asin(std::min(1., sine)));
      }
      if (angle > kink_angle)
        ++result.n_kinks;
      else
        result.normal = std::max(result.normal, angle);
    }
    return result;
  }

  unsigned int n_extraordinary_points(const Surface &surface, const SurfaceEdges &edges)
  {
    // Corners of elements are united across shared edges, where they coincide.
    const Patches patches(surface);
    const double tolerance = 1e-9 * extent(surface);
    std::vector<unsigned int> group(4 * surface.elements.size());
    for (unsigned int c = 0; c < group.size(); ++c)
      group[c] = c;
    const auto root = [&group](unsigned int c)
    {
      while (group[c] != c)
        c = group[c];
      return c;
    };
    const auto corner = [](const ElementSide &side, const unsigned int end)
    {
      const Point<2> xi = point_on(side.side, end);
      return 4 * side.element + (xi[0] > 0.5 ? 1 : 0) + (xi[1] > 0.5 ? 2 : 0);
    };
    std::vector<bool> is_regular(group.size(), false); // on the boundary, or inside of a side
    for (const SharedEdge &edge : edges.shared)
      for (const unsigned int i : {0u, 1u})
      {
        const Tensor<1, 3> x = patches.at(edge.first, i)[value];
        bool is_end = false;
        for (const unsigned int j : {0u, 1u})
          if ((patches.at(edge.second, j)[value] - x).norm() < tolerance)
          {
            group[root(corner(edge.first, i))] = root(corner(edge.second, j));
            is_end = true;
          }
        if (!is_end)
          is_regular[corner(edge.first, i)] = true;
      }
    for (const ElementSide &side : edges.boundary)
      for (const unsigned int end : {0u, 1u})
        is_regular[corner(side, end)] = true;
    std::map<unsigned int, std::pair<unsigned int, bool>> counts;
    for (unsigned int c = 0; c < group.size(); ++c)
    {
      auto &[n, regular] = counts[root(c)];
      ++n;
      regular = regular || is_regular[c];
    }
    return std::count_if(counts.begin(), counts.end(),
                         [](const auto &entry)
                         { return entry.second.first != 4 && !entry.second.second; });
  }
} // namespace semilunar::spline
