// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/spline/t_junctions.h>
#include <semilunar/spline/t_spline.h>

#include <algorithm>

namespace semilunar::spline
{
  namespace
  {
    using Coordinate = TMesh::Coordinate;

    bool is_on_boundary(const TMesh &mesh, const Coordinate x, const unsigned int direction)
    {
      return x == 0 || x == mesh.end(direction);
    }

    /// The local knot vectors of a vertex in one direction, (T1): one, or several on the boundary,
    /// by shift.
    std::vector<std::vector<Coordinate>> local_knots(const TMesh &mesh, const TMesh::Point &vertex,
                                                     const unsigned int direction)
    {
      const unsigned int half = (mesh.degree() + 1) / 2;
      const Coordinate x = vertex[direction];
      const std::vector<Coordinate> before = next_lines(mesh, vertex, direction, -1, half),
                                    after = next_lines(mesh, vertex, direction, 1, half);
      const unsigned int n = is_on_boundary(mesh, x, direction) ? half : 1;
      std::vector<std::vector<Coordinate>> all;
      for (unsigned int shift = 0; shift < n; ++shift)
      {
        const unsigned int more_before = x == 0 ? shift : 0, more_after = x == 0 ? 0 : shift;
        std::vector<Coordinate> knots(before.rbegin() + more_after, before.rend());
        knots.insert(knots.end(), 1 + more_before + more_after, x);
        knots.insert(knots.end(), after.begin(), after.end() - more_before);
        all.push_back(std::move(knots));
      }
      return all;
    }

    /// Sorts functions of one vertex on the boundary from the edge inward, or inward out.
    std::int64_t sort_key(const TMesh &mesh, const BlendingFunction &function,
                          const unsigned int direction)
    {
      const std::int64_t most = mesh.degree() + 1, shift = function.shift[direction];
      const Coordinate x = function.vertex[direction];
      return 2 * most * x + (x == 0 ? -shift : shift);
    }
  } // namespace

  std::vector<BlendingFunction> blending_functions(const TMesh &mesh)
  {
    std::vector<BlendingFunction> functions;
    for (const TMesh::Point &vertex : vertices(mesh))
    {
      const auto first = local_knots(mesh, vertex, 0), second = local_knots(mesh, vertex, 1);
      for (unsigned int j = 0; j < second.size(); ++j)
        for (unsigned int i = 0; i < first.size(); ++i)
          functions.push_back({vertex, {{i, j}}, {{first[i], second[j]}}});
    }
    std::sort(functions.begin(), functions.end(),
              [&mesh](const BlendingFunction &a, const BlendingFunction &b)
              {
                return std::make_pair(sort_key(mesh, a, 1), sort_key(mesh, a, 0)) <
                       std::make_pair(sort_key(mesh, b, 1), sort_key(mesh, b, 0));
              });
    return functions;
  }
} // namespace semilunar::spline
