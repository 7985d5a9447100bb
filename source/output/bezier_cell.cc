// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/output/bezier_cell.h>
#include <semilunar/spline/bernstein.h>

namespace semilunar::output
{
  std::vector<unsigned int> vtk_node_order(const std::array<unsigned int, 2> &degree)
  {
    const auto [p, q] = degree;
    std::vector<unsigned int> order;
    const auto add = [&order, n = p + 1](const unsigned int i, const unsigned int j)
    { order.push_back(j * n + i); };

    add(0, 0), add(p, 0), add(p, q), add(0, q);
    for (unsigned int i = 1; i < p; ++i)
      add(i, 0);
    for (unsigned int j = 1; j < q; ++j)
      add(p, j);
    for (unsigned int i = 1; i < p; ++i)
      add(i, q);
    for (unsigned int j = 1; j < q; ++j)
      add(0, j);
    for (unsigned int j = 1; j < q; ++j)
      for (unsigned int i = 1; i < p; ++i)
        add(i, j);
    return order;
  }

  RationalInterpolation::RationalInterpolation(const std::array<unsigned int, 2> &degree)
  {
    std::array<std::vector<double>, 2> coordinates;
    for (unsigned int d = 0; d < 2; ++d)
    {
      coordinates[d] = chebyshev_points(degree[d] + 1);
      at_points[d] = bernstein_matrix(degree[d], coordinates[d]);
      from_points[d] = {degree[d] + 1, degree[d] + 1,
                        spline::bernstein_from_values(coordinates[d])};
    }
    nodes = tensor_points(coordinates);
  }

  std::vector<double> RationalInterpolation::coefficients(const std::vector<double> &weights,
                                                          std::vector<double> values,
                                                          const unsigned int n_components) const
  {
    const std::vector<double> w_at_points = apply(at_points[0], at_points[1], weights, 1);
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] *= w_at_points[i / n_components];
    std::vector<double> result = apply(from_points[0], from_points[1], values, n_components);
    for (std::size_t i = 0; i < result.size(); ++i)
      result[i] /= weights[i / n_components];
    return result;
  }
} // namespace semilunar::output
