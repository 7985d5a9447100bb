// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_output_tensor_product_h
#define semilunar_output_tensor_product_h

#include <deal.II/base/point.h>

#include <array>
#include <vector>

namespace semilunar::output
{
  /// A small dense matrix, row by row.
  struct Matrix
  {
    unsigned int n_rows, n_columns;
    std::vector<double> entries;
  };

  /// The Bernstein polynomials of a degree (columns) at coordinates in [0,1] (rows).
  Matrix bernstein_matrix(unsigned int degree, const std::vector<double> &coordinates);

  /// Apply one matrix along each direction of an array, (O1): out_kl = sum_ij A_ki B_lj in_ij,
  /// where the first index runs fastest and n_components numbers belong to each pair of indices.
  std::vector<double> apply(const Matrix &first, const Matrix &second,
                            const std::vector<double> &in, unsigned int n_components);

  /// The n roots of the Chebyshev polynomial, mapped to [0,1], rising. Interpolation there is close
  /// to the best approximation, and stays away from the ends.
  std::vector<double> chebyshev_points(unsigned int n);

  /// All pairs of the coordinates, first direction fastest.
  std::vector<dealii::Point<2>>
  tensor_points(const std::array<std::vector<double>, 2> &coordinates);
} // namespace semilunar::output

#endif
