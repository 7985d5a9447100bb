// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/output/tensor_product.h>
#include <semilunar/spline/bernstein.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/numbers.h>

#include <cmath>

namespace semilunar::output
{
  Matrix bernstein_matrix(const unsigned int degree, const std::vector<double> &coordinates)
  {
    const unsigned int n = coordinates.size();
    Matrix matrix{n, degree + 1, std::vector<double>(n * (degree + 1))};
    for (unsigned int k = 0; k < n; ++k)
      spline::bernstein_values(degree, coordinates[k], &matrix.entries[k * (degree + 1)]);
    return matrix;
  }

  std::vector<double> apply(const Matrix &first, const Matrix &second,
                            const std::vector<double> &in, const unsigned int n_components)
  {
    AssertDimension(in.size(), first.n_columns * second.n_columns * n_components);
    const unsigned int row_length = first.n_rows * n_components;
    std::vector<double> half(second.n_columns * row_length, 0.);
    for (unsigned int j = 0; j < second.n_columns; ++j)
      for (unsigned int k = 0; k < first.n_rows; ++k)
        for (unsigned int i = 0; i < first.n_columns; ++i)
          for (unsigned int c = 0; c < n_components; ++c)
            half[j * row_length + k * n_components + c] +=
                first.entries[k * first.n_columns + i] *
                in[(j * first.n_columns + i) * n_components + c];

    std::vector<double> out(second.n_rows * row_length, 0.);
    for (unsigned int l = 0; l < second.n_rows; ++l)
      for (unsigned int j = 0; j < second.n_columns; ++j)
        for (unsigned int k = 0; k < row_length; ++k)
          out[l * row_length + k] +=
              second.entries[l * second.n_columns + j] * half[j * row_length + k];
    return out;
  }

  std::vector<double> chebyshev_points(const unsigned int n)
  {
    std::vector<double> x(n);
    for (unsigned int k = 0; k < n; ++k)
      x[k] = (1. - std::cos((k + 0.5) * dealii::numbers::PI / n)) / 2.;
    return x;
  }

  std::vector<dealii::Point<2>> tensor_points(const std::array<std::vector<double>, 2> &coordinates)
  {
    std::vector<dealii::Point<2>> points;
    for (const double y : coordinates[1])
      for (const double x : coordinates[0])
        points.emplace_back(x, y);
    return points;
  }
} // namespace semilunar::output
