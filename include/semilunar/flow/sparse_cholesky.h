// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_flow_sparse_cholesky_h
#define semilunar_flow_sparse_cholesky_h

#include <memory>
#include <vector>

namespace semilunar::flow
{
  /// A symmetric positive definite matrix on one rank, factorised by CHOLMOD (supernodes in an
  /// order of nested dissection); the factors are kept and applied in the precision of Number.
  template <class Number>
  class SparseCholesky
  {
  public:
    SparseCholesky();
    ~SparseCholesky();

    /// The lower triangle, column by column: rows ascend, the diagonal comes first.
    struct Columns
    {
      std::vector<int> start, row; ///< start: n + 1 entries
      std::vector<double> value;
    };

    /// Forget what is known of the pattern of matrices.
    void clear();

    /// Factorise a matrix of the same pattern as before. If it is not positive definite, a share of
    /// its mean diagonal is added to the diagonal, as much as makes it so.
    /// @throws NumericsError if it has entries that are not finite or there is not enough memory
    void factorise(Columns &matrix);

    /// x = A^-1 b; both may be the same.
    void solve(const double *b, double *x) const;

  private:
    struct Cholmod; ///< its workspace and the symbolic factors

    void keep_factors();

    std::unique_ptr<Cholmod> cholmod;
    // L in supernodes, sets of columns that have their rows in common: dense matrices of rows times
    // columns, column by column, the diagonal block first, its diagonal inverted.
    std::vector<int> permutation, first_column, row_start, row;
    std::vector<std::size_t> value_start;
    std::vector<Number> value;
    mutable std::vector<Number> work, rows_below;
  };
} // namespace semilunar::flow

#endif
