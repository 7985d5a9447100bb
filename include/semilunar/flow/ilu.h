// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_flow_ilu_h
#define semilunar_flow_ilu_h

#include <vector>

namespace semilunar::flow
{
  /// Rows, columns (sorted in each row, the diagonal included) and values of a square matrix on one
  /// rank.
  struct CompressedRows
  {
    std::vector<unsigned int> row_start; ///< n + 1 entries
    std::vector<unsigned int> column;
    std::vector<float> value;

    unsigned int n_rows() const { return row_start.size() - 1; }

    /// y = A x, for n_components interleaved vectors.
    template <int n_components>
    void vmult(const double *x, double *y) const;
  };

  /// Incomplete factorisation without fill-in, in single precision, applied to up to four
  /// interleaved vectors at once: the matrix is read once for all components of the velocity.
  class Ilu
  {
  public:
    /// Factorise. @throws NumericsError if a pivot is not positive
    void factorise(const CompressedRows &matrix);

    /// x = (LU)^-1 b, for n_components interleaved vectors.
    template <int n_components>
    void solve(const double *b, double *x) const;

    bool empty() const { return diagonal.empty(); }

  private:
    using Four = float __attribute__((vector_size(4 * sizeof(float))));

    std::vector<unsigned int> row_start, diagonal, column;
    std::vector<float> value; ///< L without its unit diagonal, U with inverse diagonal
    mutable std::vector<Four> work;
  };
} // namespace semilunar::flow

#endif
