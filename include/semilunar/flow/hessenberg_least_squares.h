// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_flow_hessenberg_least_squares_h
#define semilunar_flow_hessenberg_least_squares_h

#include <cmath>
#include <vector>

namespace semilunar::flow
{
  /// The small problem of GMRES: minimise |beta e_1 - H y| for a Hessenberg matrix H that grows by
  /// columns, with Givens rotations.
  class HessenbergLeastSquares
  {
  public:
    explicit HessenbergLeastSquares(const double beta) : right(1, beta) {}

    /// The next column of H: n + 1 entries if there were n - 1 columns.
    void add_column(std::vector<double> column)
    {
      const std::size_t j = triangle.size();
      for (std::size_t i = 0; i < j; ++i)
      {
        const double rotated = cosine[i] * column[i] + sine[i] * column[i + 1];
        column[i + 1] = -sine[i] * column[i] + cosine[i] * column[i + 1];
        column[i] = rotated;
      }
      const double length = std::hypot(column[j], column[j + 1]);
      cosine.push_back(column[j] / length);
      sine.push_back(column[j + 1] / length);
      column[j] = length;
      right.push_back(-sine[j] * right[j]);
      right[j] *= cosine[j];
      triangle.push_back(std::move(column));
    }

    /// The minimum.
    double residual() const { return std::abs(right.back()); }

    /// y
    std::vector<double> solution() const
    {
      std::vector<double> y(right.begin(), right.end() - 1);
      for (std::size_t i = y.size(); i-- > 0;)
      {
        for (std::size_t k = i + 1; k < y.size(); ++k)
          y[i] -= triangle[k][i] * y[k];
        y[i] /= triangle[i][i];
      }
      return y;
    }

  private:
    std::vector<std::vector<double>> triangle; // columns of R
    std::vector<double> cosine, sine, right;   // rotations, Q^T beta e_1
  };
} // namespace semilunar::flow

#endif
