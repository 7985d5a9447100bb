// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/spline/surface.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <unordered_map>

namespace semilunar::spline
{
  const NamedSet *Surface::find_set(const SetKind kind, const std::string &name) const
  {
    for (const NamedSet &set : sets)
      if (set.kind == kind && set.name == name)
        return &set;
    return nullptr;
  }

  std::vector<unsigned int> connected_parts(const Surface &surface)
  {
    constexpr unsigned int unknown = dealii::numbers::invalid_unsigned_int;
    std::vector<std::vector<unsigned int>> elements_at(surface.control_points.size());
    for (unsigned int e = 0; e < surface.elements.size(); ++e)
      for (const unsigned int i : surface.elements[e].control_points)
        elements_at[i].push_back(e);

    std::vector<unsigned int> part(surface.elements.size(), unknown), front;
    unsigned int n_parts = 0;
    for (unsigned int start = 0; start < part.size(); ++start)
    {
      if (part[start] != unknown)
        continue;
      part[start] = n_parts;
      front.push_back(start);
      while (!front.empty())
      {
        const unsigned int e = front.back();
        front.pop_back();
        for (const unsigned int i : surface.elements[e].control_points)
        {
          for (const unsigned int neighbour : elements_at[i])
            if (part[neighbour] == unknown)
            {
              part[neighbour] = n_parts;
              front.push_back(neighbour);
            }
          elements_at[i].clear(); // all marked: keeps the cost linear
        }
      }
      ++n_parts;
    }
    return part;
  }

  namespace
  {
    /// Finds the control points of a surface near a given one, in constant time each.
    class ControlPointHash
    {
    public:
      ControlPointHash(const std::vector<ControlPoint> &points, const double tolerance)
          : points(points), tolerance(tolerance)
      {
        double extent = 0.;
        for (const ControlPoint &point : points)
          for (unsigned int d = 0; d < 3; ++d)
            extent = std::max(extent, std::abs(point.position[d]));
        // cells so small that their numbers would overflow are useless
        size = std::max({tolerance, 1e-9 * extent, 1e-100});
        for (unsigned int i = 0; i < points.size(); ++i)
          cells.emplace(key(cell(points[i].position)), i);
      }

      /// The nearest point of equal weight within the tolerance, or invalid_unsigned_int.
      unsigned int find(const ControlPoint &wanted) const
      {
        unsigned int nearest = dealii::numbers::invalid_unsigned_int;
        double best = tolerance;
        const Cell centre = cell(wanted.position);
        for (int dx = -1; dx <= 1; ++dx)
          for (int dy = -1; dy <= 1; ++dy)
            for (int dz = -1; dz <= 1; ++dz)
            {
              const auto range =
                  cells.equal_range(key({{centre[0] + dx, centre[1] + dy, centre[2] + dz}}));
              for (auto candidate = range.first; candidate != range.second; ++candidate)
              {
                const ControlPoint &point = points[candidate->second];
                const double distance = point.position.distance(wanted.position);
                const bool closer =
                    distance < best || (distance == best && candidate->second < nearest);
                if (closer && equal_weights(point.weight, wanted.weight))
                {
                  best = distance;
                  nearest = candidate->second;
                }
              }
            }
        return nearest;
      }

    private:
      using Cell = std::array<double, 3>;

      const std::vector<ControlPoint> &points;
      double tolerance, size;
      std::unordered_multimap<std::uint64_t, unsigned int> cells;

      static bool equal_weights(const double a, const double b)
      {
        constexpr double written = 1e-8; // files round weights
        return std::abs(a - b) <= written * std::max(a, b);
      }

      Cell cell(const Point<3> &x) const
      {
        return {{std::floor(x[0] / size), std::floor(x[1] / size), std::floor(x[2] / size)}};
      }

      /// Cells may collide: the distance decides in the end.
      static std::uint64_t key(const Cell &cell)
      {
        std::uint64_t hash = 0;
        for (const double c : cell)
        {
          hash ^= std::hash<double>()(c + 0.); // + 0. makes the two zeros one
          hash *= 0x9e3779b97f4a7c15u;         // odd multiplier, 2^64 / golden ratio
          hash ^= hash >> 32;
        }
        return hash;
      }
    };

    /// For each control point of b its number in a; those that a does not have yet are added.
    std::vector<unsigned int> add_control_points(std::vector<ControlPoint> &a,
                                                 const std::vector<ControlPoint> &b,
                                                 const double tolerance)
    {
      const std::vector<ControlPoint> present = tolerance < 0. ? std::vector<ControlPoint>() : a;
      const ControlPointHash hash(present, tolerance);
      std::vector<unsigned int> number(b.size());
      for (unsigned int i = 0; i < b.size(); ++i)
      {
        number[i] = hash.find(b[i]);
        if (number[i] == dealii::numbers::invalid_unsigned_int)
        {
          number[i] = a.size();
          a.push_back(b[i]);
        }
      }
      return number;
    }

    /// Number the members of a set as in the united surface.
    void renumber(NamedSet &set, const std::vector<unsigned int> &control_point,
                  const unsigned int first_element)
    {
      for (unsigned int k = 0; k < set.members.size(); ++k)
        if (set.kind == SetKind::node)
          set.members[k] = control_point[set.members[k]];
        else if (set.kind == SetKind::element || k % 2 == 0)
          set.members[k] += first_element;
    }

    /// Elements and sides of the two surfaces differ, but nodes may have been merged.
    void unite(NamedSet &a, const NamedSet &b)
    {
      std::set<unsigned int> present;
      if (a.kind == SetKind::node)
        present.insert(a.members.begin(), a.members.end());
      for (const unsigned int member : b.members)
        if (a.kind != SetKind::node || present.insert(member).second)
          a.members.push_back(member);
    }
  } // namespace

  void append(Surface &a, const Surface &b, const double tolerance)
  {
    const unsigned int first_element = a.elements.size();
    const std::vector<unsigned int> number =
        add_control_points(a.control_points, b.control_points, tolerance);
    for (BezierElement element : b.elements)
    {
      for (unsigned int &i : element.control_points)
        i = number[i];
      a.elements.push_back(std::move(element));
    }
    for (NamedSet set : b.sets)
    {
      renumber(set, number, first_element);
      const auto same = std::find_if(a.sets.begin(), a.sets.end(),
                                     [&set](const NamedSet &other)
                                     { return other.kind == set.kind && other.name == set.name; });
      if (same == a.sets.end())
        a.sets.push_back(std::move(set));
      else
        unite(*same, set);
    }
  }
} // namespace semilunar::spline
