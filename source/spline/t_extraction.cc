// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/spline/bernstein.h>
#include <semilunar/spline/t_junctions.h>
#include <semilunar/spline/t_spline.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>

namespace semilunar::spline
{
  namespace
  {
    using Coordinate = TMesh::Coordinate;

    /// Where extensions of T-junctions divide each element of a T-mesh, by direction of the lines'
    /// normals, sorted.
    std::vector<std::array<std::vector<Coordinate>, 2>> dividing_lines(const TMesh &mesh)
    {
      const std::vector<unsigned int> active = mesh.active_elements();
      std::vector<std::array<std::vector<Coordinate>, 2>> lines(active.back() + 1);
      for (const TJunction &junction : t_junctions(mesh))
      {
        const unsigned int d = junction.direction, normal = 1 - d;
        TMesh::Point low = junction.vertex, high = junction.vertex;
        (junction.sign > 0 ? high : low)[d] = junction.ahead;
        mesh.for_each_in(low, high,
                         [&](const unsigned int e)
                         { lines[e][normal].push_back(junction.vertex[normal]); });
      }
      for (auto &element : lines)
        for (std::vector<Coordinate> &x : element)
        {
          std::sort(x.begin(), x.end());
          x.erase(std::unique(x.begin(), x.end()), x.end());
        }
      return lines;
    }

    /// The functions that do not vanish on each element of the T-mesh.
    std::vector<std::vector<unsigned int>>
    functions_on(const TMesh &mesh, const std::vector<BlendingFunction> &functions)
    {
      std::vector<std::vector<unsigned int>> on(mesh.active_elements().back() + 1);
      for (unsigned int a = 0; a < functions.size(); ++a)
      {
        const auto &x = functions[a].knots[0], &y = functions[a].knots[1];
        mesh.for_each_in({{x.front(), y.front()}}, {{x.back(), y.back()}},
                         [&](const unsigned int e) { on[e].push_back(a); });
      }
      return on;
    }

    /// A function's Bernstein coefficients on one element, (T8).
    class FunctionExtraction
    {
    public:
      explicit FunctionExtraction(const TSpline &spline) : p(spline.mesh().degree())
      {
        for (const BlendingFunction &function : spline.functions())
          for (unsigned int d = 0; d < 2; ++d)
            knots[d].push_back(spline.knots(function, d));
      }

      void append(const unsigned int function, const std::array<double, 2> &low,
                  const std::array<double, 2> &high, std::vector<double> &extraction) const
      {
        double c[2][max_degree + 1];
        for (unsigned int d = 0; d < 2; ++d)
          extract_function(knots[d][function], low[d], high[d], c[d]);
        for (unsigned int j = 0; j <= p; ++j)
          for (unsigned int i = 0; i <= p; ++i)
            extraction.push_back(c[0][i] * c[1][j]);
      }

    private:
      const unsigned int p;
      std::array<std::vector<std::vector<double>>, 2> knots;
    };

    bool vanishes_on(const BlendingFunction &function, const BezierBox &box)
    {
      for (unsigned int d = 0; d < 2; ++d)
        if (function.knots[d].front() >= box.high[d] || function.knots[d].back() <= box.low[d])
          return true;
      return false;
    }

    /// The functions in a row along an edge: 0 those that do not vanish there, 1 the next ones.
    NamedSet row(const TSpline &spline, const std::string &name, const unsigned int direction,
                 const bool at_end, const unsigned int row)
    {
      NamedSet set{SetKind::node, name, {}};
      const Coordinate edge = at_end ? spline.mesh().end(direction) : 0;
      const unsigned int shift = (spline.mesh().degree() - 1) / 2 - row;
      for (unsigned int a = 0; a < spline.functions().size(); ++a)
      {
        const BlendingFunction &function = spline.functions()[a];
        if (function.vertex[direction] == edge && function.shift[direction] == shift)
          set.members.push_back(a);
      }
      return set;
    }

    std::vector<NamedSet> boundary_sets(const TSpline &spline)
    {
      return {row(spline, "left", 0, false, 0),       row(spline, "right", 0, true, 0),
              row(spline, "bottom", 1, false, 0),     row(spline, "top", 1, true, 0),
              row(spline, "nextLeft", 0, false, 1),   row(spline, "nextRight", 0, true, 1),
              row(spline, "nextBottom", 1, false, 1), row(spline, "nextTop", 1, true, 1)};
    }
  } // namespace

  std::vector<BezierBox> bezier_boxes(const TMesh &mesh)
  {
    const auto lines = dividing_lines(mesh);
    std::vector<BezierBox> boxes;
    for (const unsigned int e : mesh.active_elements())
    {
      std::array<std::vector<Coordinate>, 2> x = lines[e];
      for (unsigned int d = 0; d < 2; ++d)
      {
        x[d].insert(x[d].begin(), mesh.element(e).low[d]);
        x[d].push_back(mesh.element(e).high[d]);
      }
      for (unsigned int j = 0; j + 1 < x[1].size(); ++j)
        for (unsigned int i = 0; i + 1 < x[0].size(); ++i)
          boxes.push_back({{{x[0][i], x[1][j]}}, {{x[0][i + 1], x[1][j + 1]}}, e});
    }
    return boxes;
  }

  void extract_function(const std::vector<double> &knots, const double a, const double b,
                        double *coefficients)
  {
    // Any spline space that holds the function will do: the one with ends repeated degree times.
    const unsigned int p = knots.size() - 2;
    double t[3 * max_degree + 2], d[max_degree + 1];
    AssertIndexRange(p, max_degree + 1);
    std::fill_n(t, p, knots.front());
    std::copy(knots.begin(), knots.end(), t + p);
    std::fill_n(t + 2 * p + 2, p, knots.back());
    unsigned int s = p; // the span that holds [a,b]
    while (!(t[s] <= a && t[s + 1] >= b && t[s + 1] > t[s]))
    {
      ++s;
      AssertIndexRange(s, 2 * p + 1);
    }
    for (unsigned int k = 0; k <= p; ++k)
    {
      for (unsigned int j = 0; j <= p; ++j)
        d[j] = s - p + j == p ? 1. : 0.;
      for (unsigned int r = 1; r <= p; ++r)
        for (unsigned int j = p; j >= r; --j)
        {
          const double low = t[s - p + j], high = t[s + 1 + j - r], x = r <= p - k ? a : b;
          d[j] = ((high - x) / (high - low)) * d[j - 1] + ((x - low) / (high - low)) * d[j];
        }
      coefficients[k] = d[p];
    }
  }

  Surface to_surface(const TSpline &spline, const std::string &source)
  {
    const TMesh &mesh = spline.mesh();
    check_suitable(mesh, source);
    const auto on = functions_on(mesh, spline.functions());
    const FunctionExtraction function_extraction(spline);

    Surface surface;
    surface.control_points = spline.control_points();
    surface.sets = boundary_sets(spline);
    for (const BezierBox &box : bezier_boxes(mesh))
    {
      std::array<double, 2> low, high;
      for (unsigned int d = 0; d < 2; ++d)
      {
        low[d] = spline.parameter(d, box.low[d]);
        high[d] = spline.parameter(d, box.high[d]);
      }
      BezierElement element;
      element.degree = {{mesh.degree(), mesh.degree()}};
      for (const unsigned int a : on[box.t_element])
        if (!vanishes_on(spline.functions()[a], box))
        {
          element.control_points.push_back(a);
          function_extraction.append(a, low, high, element.extraction);
        }
      surface.elements.push_back(std::move(element));
    }
    return surface;
  }
} // namespace semilunar::spline
