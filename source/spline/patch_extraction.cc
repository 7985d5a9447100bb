// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/spline/nurbs_patch.h>

namespace semilunar::spline
{
  namespace
  {
    /// The extraction operators of a knot vector, and the first function of each element.
    struct LineOfElements
    {
      std::vector<std::vector<double>> operators;
      std::vector<unsigned int> first_function;

      LineOfElements(const KnotVector &knots) : operators(knots.extraction_operators())
      {
        const std::vector<double> points = knots.breakpoints();
        for (unsigned int e = 0; e + 1 < points.size(); ++e)
          first_function.push_back(knots.span(points[e]) - knots.degree());
      }
    };

    /// The tensor product of two univariate extraction operators, (S11).
    std::vector<double> product(const std::vector<double> &first, const unsigned int n_first,
                                const std::vector<double> &second, const unsigned int n_second)
    {
      std::vector<double> C;
      C.reserve(first.size() * second.size());
      for (unsigned int aj = 0; aj < n_second; ++aj)
        for (unsigned int ai = 0; ai < n_first; ++ai)
          for (unsigned int bj = 0; bj < n_second; ++bj)
            for (unsigned int bi = 0; bi < n_first; ++bi)
              C.push_back(first[ai * n_first + bi] * second[aj * n_second + bj]);
      return C;
    }

    /// The row of control points with a fixed index in one direction.
    NamedSet row(const NurbsPatch &patch, const std::string &name,
                 const unsigned int fixed_direction, const unsigned int index)
    {
      NamedSet set{SetKind::node, name, {}};
      const unsigned int n = patch.n_control_points(0);
      for (unsigned int k = 0; k < patch.n_control_points(1 - fixed_direction); ++k)
        set.members.push_back(fixed_direction == 0 ? k * n + index : index * n + k);
      return set;
    }

    std::vector<NamedSet> boundary_sets(const NurbsPatch &patch)
    {
      const unsigned int right = patch.n_control_points(0) - 1;
      const unsigned int top = patch.n_control_points(1) - 1;
      return {row(patch, "left", 0, 0),       row(patch, "right", 0, right),
              row(patch, "bottom", 1, 0),     row(patch, "top", 1, top),
              row(patch, "nextLeft", 0, 1),   row(patch, "nextRight", 0, right - 1),
              row(patch, "nextBottom", 1, 1), row(patch, "nextTop", 1, top - 1)};
    }
  } // namespace

  Surface to_surface(const NurbsPatch &patch)
  {
    Surface surface;
    surface.control_points = patch.control_net();
    surface.sets = boundary_sets(patch);

    const std::array<unsigned int, 2> degree{{patch.knots(0).degree(), patch.knots(1).degree()}};
    const LineOfElements first(patch.knots(0)), second(patch.knots(1));
    for (unsigned int ej = 0; ej < second.operators.size(); ++ej)
      for (unsigned int ei = 0; ei < first.operators.size(); ++ei)
      {
        BezierElement element;
        element.degree = degree;
        for (unsigned int aj = 0; aj <= degree[1]; ++aj)
          for (unsigned int ai = 0; ai <= degree[0]; ++ai)
            element.control_points.push_back((second.first_function[ej] + aj) *
                                                 patch.n_control_points(0) +
                                             first.first_function[ei] + ai);
        element.extraction =
            product(first.operators[ei], degree[0] + 1, second.operators[ej], degree[1] + 1);
        surface.elements.push_back(std::move(element));
      }
    return surface;
  }
} // namespace semilunar::spline
