// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/spline/closest_point.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <limits>
#include <numeric>

namespace semilunar::spline
{
  namespace
  {
    /// A lower bound of the distance from x to the patch: that to the box around its control points
    /// (a patch lies in their convex hull if its Bernstein weights are positive; otherwise 0).
    double distance_to_box(const BezierPatch &patch, const Tensor<1, 3> &x)
    {
      constexpr double infinity = std::numeric_limits<double>::infinity();
      Point<3> low(infinity, infinity, infinity), high(-infinity, -infinity, -infinity);
      for (const std::array<double, 4> &c : patch.coefficients)
      {
        if (c[3] <= 0.)
          return 0.;
        for (unsigned int d = 0; d < 3; ++d)
        {
          low[d] = std::min(low[d], c[d] / c[3]);
          high[d] = std::max(high[d], c[d] / c[3]);
        }
      }
      Tensor<1, 3> outside;
      for (unsigned int d = 0; d < 3; ++d)
        outside[d] = std::max({low[d] - x[d], 0., x[d] - high[d]});
      return outside.norm();
    }

    /// The best of the local minima found from a grid of starting points fine enough for the
    /// patch's degree.
    Projection project_from_grid(const BezierPatch &patch, const Tensor<1, 3> &x)
    {
      const unsigned int n = std::max(patch.degree[0], patch.degree[1]) + 2;
      std::vector<double> distance((n + 1) * (n + 1));
      const auto at = [n](const unsigned int i, const unsigned int j) { return j * (n + 1) + i; };
      const auto start = [n](const unsigned int i, const unsigned int j)
      { return Point<2>(double(i) / n, double(j) / n); };
      for (unsigned int j = 0; j <= n; ++j)
        for (unsigned int i = 0; i <= n; ++i)
          distance[at(i, j)] = (evaluate(patch, start(i, j))[value] - x).norm();

      Projection best;
      best.distance = std::numeric_limits<double>::infinity();
      for (unsigned int j = 0; j <= n; ++j)
        for (unsigned int i = 0; i <= n; ++i)
        {
          const double here = distance[at(i, j)];
          if ((i > 0 && distance[at(i - 1, j)] < here) ||
              (i < n && distance[at(i + 1, j)] < here) ||
              (j > 0 && distance[at(i, j - 1)] < here) || (j < n && distance[at(i, j + 1)] < here))
            continue;
          const Projection candidate = project(patch, x, start(i, j));
          if (candidate.distance < best.distance)
            best = candidate;
        }
      return best;
    }
  } // namespace

  ClosestPoint closest_point(const Surface &surface,
                             const std::vector<Tensor<1, 3>> &control_vectors,
                             const Tensor<1, 3> &x)
  {
    Assert(!surface.elements.empty(), dealii::ExcMessage("a surface without elements"));
    const unsigned int n = surface.elements.size();
    std::vector<BezierPatch> patches;
    std::vector<double> bounds;
    for (unsigned int e = 0; e < n; ++e)
    {
      patches.push_back(bezier_patch(surface, e, control_vectors));
      bounds.push_back(distance_to_box(patches.back(), x));
    }
    std::vector<unsigned int> order(n);
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&bounds](const unsigned int a, unsigned int b)
                     { return bounds[a] < bounds[b]; });

    ClosestPoint best{SurfacePoint(), std::numeric_limits<double>::infinity()};
    for (const unsigned int e : order)
    {
      if (bounds[e] >= best.distance)
        break;
      const Projection candidate = project_from_grid(patches[e], x);
      if (candidate.distance < best.distance)
        best = {{e, candidate.xi}, candidate.distance};
    }
    return best;
  }
} // namespace semilunar::spline
