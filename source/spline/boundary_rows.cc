// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/spline/boundary_rows.h>
#include <semilunar/spline/evaluation.h>

#include <algorithm>
#include <map>
#include <set>

namespace semilunar::spline
{
  namespace
  {
    /// Coefficients below this do not make a function live on a side: extraction operators of
    /// imported files carry about ten digits.
    constexpr double extraction_tolerance = 1e-8;

    /// Does the function have a Bernstein coefficient in the row'th line of the net parallel to the
    /// side?
    bool reaches(const BezierElement &element, const unsigned int function, const unsigned int side,
                 const unsigned int row)
    {
      const unsigned int n_across = element.degree[side / 2],
                         n_along = element.degree[1 - side / 2];
      const unsigned int line = side % 2 == 0 ? row : n_across - row;
      const double *coefficients = &element.extraction[function * element.n_bernstein()];
      for (unsigned int k = 0; k <= n_along; ++k)
      {
        const unsigned int i = side < 2 ? line : k, j = side < 2 ? k : line;
        if (std::abs(coefficients[j * (element.degree[0] + 1) + i]) > extraction_tolerance)
          return true;
      }
      return false;
    }

    std::array<Tensor<1, 3>, 2> end_points(const Surface &surface, const ElementSide &s)
    {
      std::array<Tensor<1, 3>, 2> ends;
      for (unsigned int end = 0; end < 2; ++end)
      {
        Point<2> xi;
        xi[s.side / 2] = s.side % 2;
        xi[1 - s.side / 2] = end;
        ends[end] = evaluate(surface, {s.element, xi})[value];
      }
      return ends;
    }

    /// Do two sides that see the same functions share more than a point? They are parts of one
    /// curve: compare along its chord.
    bool overlap(const Surface &surface, const ElementSide &s, const ElementSide &t)
    {
      constexpr double smallest_share = 1e-3; // of the chord; files round coordinates
      const auto ends = end_points(surface, s), others = end_points(surface, t);
      const Tensor<1, 3> chord = ends[1] - ends[0];
      if (chord.norm_square() == 0.)
        return true;
      const double a = (others[0] - ends[0]) * chord / chord.norm_square();
      const double b = (others[1] - ends[0]) * chord / chord.norm_square();
      return std::min(1., std::max(a, b)) - std::max(0., std::min(a, b)) > smallest_share;
    }
  } // namespace

  std::vector<unsigned int> control_row(const BezierElement &element, const unsigned int side,
                                        const unsigned int row)
  {
    std::vector<unsigned int> points;
    for (unsigned int a = 0; a < element.n_functions(); ++a)
    {
      const bool on_edge = reaches(element, a, side, 0);
      if (row == 0 ? on_edge : !on_edge && reaches(element, a, side, 1))
        points.push_back(element.control_points[a]);
    }
    return points;
  }

  std::vector<ElementSide> boundary_sides(const Surface &surface)
  {
    // Elements on both sides of an inner edge see the same functions there; and so do neighbours
    // along the boundary if the line between them is the extension of a T-junction.
    std::map<std::vector<unsigned int>, std::vector<ElementSide>> sides_by_row;
    for (unsigned int e = 0; e < surface.elements.size(); ++e)
      for (unsigned int side = 0; side < 4; ++side)
      {
        std::vector<unsigned int> row = control_row(surface.elements[e], side, 0);
        std::sort(row.begin(), row.end());
        sides_by_row[row].push_back({e, side});
      }
    std::vector<ElementSide> boundary;
    for (const auto &[row, sides] : sides_by_row)
      for (const ElementSide &s : sides)
        if (std::none_of(sides.begin(), sides.end(),
                         [&](const ElementSide &t) { return &t != &s && overlap(surface, s, t); }))
          boundary.push_back(s);
    std::sort(boundary.begin(), boundary.end(),
              [](const ElementSide &a, const ElementSide &b)
              { return std::make_pair(a.element, a.side) < std::make_pair(b.element, b.side); });
    return boundary;
  }

  std::vector<ElementSide> boundary_sides(const Surface &surface,
                                          const std::vector<unsigned int> &control_points)
  {
    std::vector<bool> wanted(surface.control_points.size(), false);
    for (const unsigned int c : control_points)
      wanted[c] = true;
    std::vector<ElementSide> chosen;
    for (const ElementSide &s : boundary_sides(surface))
    {
      const std::vector<unsigned int> row = control_row(surface.elements[s.element], s.side, 0);
      if (std::all_of(row.begin(), row.end(), [&](const unsigned int c) { return wanted[c]; }))
        chosen.push_back(s);
    }
    return chosen;
  }

  std::vector<unsigned int>
  control_row(const Surface &surface, const std::vector<ElementSide> &sides, const unsigned int row)
  {
    std::set<unsigned int> points;
    for (const ElementSide &s : sides)
      for (const unsigned int c : control_row(surface.elements[s.element], s.side, row))
        points.insert(c);
    if (row == 1)
      for (const ElementSide &s : sides)
        for (const unsigned int c : control_row(surface.elements[s.element], s.side, 0))
          points.erase(c);
    return {points.begin(), points.end()};
  }
} // namespace semilunar::spline
