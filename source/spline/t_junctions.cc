// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/spline/t_junctions.h>

#include <algorithm>
#include <sstream>

namespace semilunar::spline
{
  using Coordinate = TMesh::Coordinate;
  using Index = TMesh::Point;

  std::vector<Index> vertices(const TMesh &mesh)
  {
    std::vector<Index> points;
    points.reserve(4 * mesh.n_active());
    for (const unsigned int e : mesh.active_elements())
    {
      const Index &low = mesh.element(e).low, &high = mesh.element(e).high;
      for (const Index &corner : {low, high, Index{{low[0], high[1]}}, Index{{high[0], low[1]}}})
        points.push_back(corner);
    }
    std::sort(points.begin(), points.end(),
              [](const Index &a, const Index &b)
              { return a[1] != b[1] ? a[1] < b[1] : a[0] < b[0]; });
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return points;
  }

  namespace
  {
    /// The next line across the ray, from the elements on both of its sides: a line that only
    /// touches the ray from one side counts.
    Coordinate next_line(const TMesh &mesh, const Index &point, const unsigned int direction,
                         const int sign)
    {
      Coordinate next = sign > 0 ? mesh.end(direction) : 0;
      for (const int side : {-1, 1})
      {
        const unsigned int e =
            direction == 0 ? mesh.find(point, sign, side) : mesh.find(point, side, sign);
        if (e == TMesh::none)
          continue;
        next = sign > 0 ? std::min(next, mesh.element(e).high[direction])
                        : std::max(next, mesh.element(e).low[direction]);
      }
      return next;
    }

    TJunction t_junction(const TMesh &mesh, const Index &vertex, const unsigned int direction,
                         const int sign)
    {
      const unsigned int p = mesh.degree();
      TJunction junction{vertex, direction, sign, 0, vertex[direction]};
      junction.ahead = next_lines(mesh, vertex, direction, sign, (p + 1) / 2).back();
      if (p > 1)
        junction.behind = next_lines(mesh, vertex, direction, -sign, (p - 1) / 2).back();
      return junction;
    }

    struct Range
    {
      Coordinate low, high;
      bool contains(const Coordinate x) const { return low <= x && x <= high; }
    };

    Range extension(const TJunction &junction)
    {
      return {std::min(junction.ahead, junction.behind), std::max(junction.ahead, junction.behind)};
    }

    bool meet(const TJunction &first, const TJunction &second)
    {
      return extension(first).contains(second.vertex[0]) &&
             extension(second).contains(first.vertex[1]);
    }

    /// For each element the extensions of one direction that touch it, boundary included.
    std::vector<std::vector<unsigned int>> extensions_at(const TMesh &mesh,
                                                         const std::vector<TJunction> &junctions,
                                                         const unsigned int direction)
    {
      const std::vector<unsigned int> active = mesh.active_elements();
      std::vector<std::vector<unsigned int>> at(active.empty() ? 0 : active.back() + 1);
      for (unsigned int k = 0; k < junctions.size(); ++k)
      {
        if (junctions[k].direction != direction)
          continue;
        const Range range = extension(junctions[k]);
        Index low, high;
        low[direction] = range.low - 1;
        high[direction] = range.high + 1;
        low[1 - direction] = junctions[k].vertex[1 - direction] - 1;
        high[1 - direction] = junctions[k].vertex[1 - direction] + 1;
        mesh.for_each_in(low, high, [&](const unsigned int e) { at[e].push_back(k); });
      }
      return at;
    }

    std::string place(const TJunction &junction)
    {
      std::ostringstream text;
      text << '(' << double(junction.vertex[0]) / TMesh::unit << ", "
           << double(junction.vertex[1]) / TMesh::unit << ')';
      return text.str();
    }
  } // namespace

  std::vector<Coordinate> next_lines(const TMesh &mesh, const Index &point,
                                     const unsigned int direction, const int sign,
                                     const unsigned int count)
  {
    std::vector<Coordinate> lines;
    lines.reserve(count);
    Index at = point;
    for (unsigned int k = 0; k < count; ++k)
    {
      at[direction] = next_line(mesh, at, direction, sign);
      lines.push_back(at[direction]);
    }
    return lines;
  }

  std::vector<TJunction> t_junctions(const TMesh &mesh)
  {
    std::vector<TJunction> junctions;
    for (const Index &v : vertices(mesh))
      for (const int sign : {-1, 1})
      {
        // one element on both sides of the line: the edge along it is missing
        const unsigned int ahead = mesh.find(v, sign, 1), above = mesh.find(v, 1, sign);
        if (ahead != TMesh::none && ahead == mesh.find(v, sign, -1))
          junctions.push_back(t_junction(mesh, v, 0, sign));
        if (above != TMesh::none && above == mesh.find(v, -1, sign))
          junctions.push_back(t_junction(mesh, v, 1, sign));
      }
    return junctions;
  }

  std::vector<Crossing> crossings(const TMesh &mesh, const unsigned int max_count)
  {
    const std::vector<TJunction> junctions = t_junctions(mesh);
    const auto first = extensions_at(mesh, junctions, 0),
               second = extensions_at(mesh, junctions, 1);
    std::vector<std::array<unsigned int, 2>> pairs;
    for (unsigned int e = 0; e < first.size() && pairs.size() < max_count; ++e)
      for (const unsigned int i : first[e])
        for (const unsigned int j : second[e])
          if (meet(junctions[i], junctions[j]))
            pairs.push_back({{i, j}});
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    std::vector<Crossing> result;
    for (const auto &pair : pairs)
      if (result.size() < max_count)
        result.push_back({junctions[pair[0]], junctions[pair[1]]});
    return result;
  }

  void check_suitable(const TMesh &mesh, const std::string &source)
  {
    const std::vector<Crossing> found = crossings(mesh);
    if (!found.empty())
      throw InputError(source, place(found[0].first) + " and " + place(found[0].second),
                       "the extensions of these T-junctions cross: the functions may be linearly "
                       "dependent",
                       "refine the elements between them");
  }
} // namespace semilunar::spline
