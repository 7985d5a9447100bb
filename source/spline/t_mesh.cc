// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/spline/t_mesh.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>

namespace semilunar::spline
{
  namespace
  {
    /// Half widths of the neighbourhood of an element, (T4), in twice the coordinates.
    TMesh::Point doubled_reach(const TMesh::Element &element, const unsigned int p)
    {
      const TMesh::Coordinate down = p / 2, up = (p + 1) / 2;
      if (element.level % 2 == 0)
      {
        const TMesh::Coordinate size = TMesh::unit >> (element.level / 2);
        return {{size * (2 * down + 1), size * (2 * up + 1)}};
      }
      const TMesh::Coordinate size = TMesh::unit >> ((element.level + 1) / 2);
      return {{size * (2 * up + 1), size * (4 * down + 2)}};
    }

    TMesh::Point doubled_middle(const TMesh::Element &element)
    {
      return {{element.low[0] + element.high[0], element.low[1] + element.high[1]}};
    }
  } // namespace

  TMesh::TMesh(const std::array<unsigned int, 2> &n, const unsigned int degree)
      : p(degree), n(n), n_leaves(n[0] * n[1])
  {
    if (p % 2 == 0)
      throw InputError("T-mesh", std::to_string(p), "the degree is even",
                       "T-splines are made for odd degrees: choose 3");
    constexpr unsigned int largest = std::numeric_limits<Coordinate>::max() / 4 / unit;
    for (const unsigned int k : n)
      if (k < 1 || k > largest)
        throw InputError("T-mesh", std::to_string(k), "the number of base elements is not possible",
                         "choose 1 to " + std::to_string(largest));
    for (unsigned int j = 0; j < n[1]; ++j)
      for (unsigned int i = 0; i < n[0]; ++i)
      {
        const Point low{{Coordinate(i) * unit, Coordinate(j) * unit}};
        nodes.push_back({{low, {{low[0] + unit, low[1] + unit}}, 0}, none});
      }
  }

  std::vector<unsigned int> TMesh::active_elements() const
  {
    std::vector<unsigned int> active;
    active.reserve(n_leaves);
    for (unsigned int e = 0; e < nodes.size(); ++e)
      if (is_active(e))
        active.push_back(e);
    return active;
  }

  void TMesh::halve(const unsigned int e)
  {
    AssertIndexRange(e, nodes.size());
    Assert(is_active(e), dealii::ExcMessage("the element is halved already"));
    Element first = nodes[e].element, second = first;
    const unsigned int d = split_direction(first);
    if (first.high[d] - first.low[d] < 2)
      throw InputError("T-mesh", std::to_string(first.level), "refined too often",
                       "at most " + std::to_string(max_halvings) + " times in each direction");
    first.high[d] = second.low[d] = (first.low[d] + first.high[d]) / 2;
    ++first.level;
    ++second.level;
    nodes[e].first_child = nodes.size();
    nodes.push_back({first, none});
    nodes.push_back({second, none});
    ++n_leaves;
  }

  unsigned int TMesh::refine(const std::vector<unsigned int> &marked)
  {
    std::vector<bool> chosen(nodes.size(), false);
    std::vector<unsigned int> front;
    for (const unsigned int e : marked)
      if (is_active(e) && !chosen[e])
      {
        chosen[e] = true;
        front.push_back(e);
      }
    // finer elements make coarser neighbours join: the front only ever descends in level
    for (unsigned int k = 0; k < front.size(); ++k)
      add_coarser_neighbours(front[k], chosen, front);
    for (const unsigned int e : front)
      halve(e);
    return front.size();
  }

  void TMesh::add_coarser_neighbours(const unsigned int e, std::vector<bool> &chosen,
                                     std::vector<unsigned int> &front) const
  {
    const Element &element = nodes[e].element;
    const Point reach = doubled_reach(element, p), middle = doubled_middle(element);
    Point low, high;
    for (unsigned int d = 0; d < 2; ++d)
    {
      low[d] = (middle[d] - reach[d]) / 2 - 1;
      high[d] = (middle[d] + reach[d]) / 2 + 1;
    }
    for_each_in(low, high,
                [&](const unsigned int other)
                {
                  const Point there = doubled_middle(nodes[other].element);
                  const bool near = std::abs(there[0] - middle[0]) <= reach[0] &&
                                    std::abs(there[1] - middle[1]) <= reach[1];
                  if (near && nodes[other].element.level < element.level && !chosen[other])
                  {
                    chosen[other] = true;
                    front.push_back(other);
                  }
                });
  }

  unsigned int TMesh::find(const Point &point, const int sign_x, const int sign_y) const
  {
    // in doubled coordinates the moved point is odd: it lies on no line
    const Point x{{2 * point[0] + sign_x, 2 * point[1] + sign_y}};
    for (unsigned int d = 0; d < 2; ++d)
      if (x[d] < 0 || x[d] > 2 * end(d))
        return none;
    unsigned int e = (x[1] / (2 * unit)) * n[0] + x[0] / (2 * unit);
    while (!is_active(e))
    {
      const unsigned int child = nodes[e].first_child, d = split_direction(nodes[e].element);
      e = x[d] < 2 * nodes[child].element.high[d] ? child : child + 1;
    }
    return e;
  }

  void TMesh::for_each_in(const Point &low, const Point &high,
                          const std::function<void(unsigned int)> &function) const
  {
    Point first, last; // base elements, the last one not included
    for (unsigned int d = 0; d < 2; ++d)
    {
      first[d] = std::max(low[d], 0) / unit;
      last[d] = (std::min(high[d], end(d)) + unit - 1) / unit;
    }
    for (Coordinate j = first[1]; j < last[1]; ++j)
      for (Coordinate i = first[0]; i < last[0]; ++i)
        visit(j * n[0] + i, low, high, function);
  }

  void TMesh::visit(const unsigned int node, const Point &low, const Point &high,
                    const std::function<void(unsigned int)> &function) const
  {
    const Element &element = nodes[node].element;
    for (unsigned int d = 0; d < 2; ++d)
      if (element.high[d] <= low[d] || element.low[d] >= high[d])
        return;
    if (is_active(node))
      return function(node);
    visit(nodes[node].first_child, low, high, function);
    visit(nodes[node].first_child + 1, low, high, function);
  }
} // namespace semilunar::spline
