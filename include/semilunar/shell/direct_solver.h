// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_shell_direct_solver_h
#define semilunar_shell_direct_solver_h

#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>

#include <memory>
#include <vector>

namespace semilunar::shell
{
  /// LU factorisation by UMFPACK for a sequence of matrices with one sparsity. Compared with
  /// dealii::SparseDirectUMFPACK the ordering is found once per sparsity, indices have 32 bits, and
  /// solutions are not refined iteratively, which Newton's method does anyway.
  class DirectSolver
  {
  public:
    DirectSolver() = default;

    /// Forget everything and find an ordering for matrices of this sparsity, rows sorted or with
    /// the diagonal first.
    void analyse(const dealii::SparsityPattern &sparsity);

    /// @throws NumericsError if the matrix is singular or not finite
    void factorize(const dealii::SparseMatrix<double> &matrix);

    /// Replace b by the solution of A x = b.
    void solve(dealii::Vector<double> &b) const;

  private:
    struct Free
    {
      void (*release)(void **);
      void operator()(void *object) const { release(&object); }
    };
    using Object = std::unique_ptr<void, Free>;

    std::vector<int> starts, columns;
    std::vector<unsigned int> places; // of the matrix's entries in the sorted rows
    std::vector<double> values;
    Object symbolic{nullptr, {}}, numeric{nullptr, {}};
  };
} // namespace semilunar::shell

#endif
