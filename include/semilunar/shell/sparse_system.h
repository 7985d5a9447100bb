// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_shell_sparse_system_h
#define semilunar_shell_sparse_system_h

#include <semilunar/shell/direct_solver.h>
#include <semilunar/shell/equations.h>
#include <semilunar/spline/surface.h>

#include <deal.II/lac/sparse_matrix.h>

#include <set>

namespace semilunar::shell
{
  /// The tangent matrix of a shell and its factorisation (UMFPACK: follower loads make it
  /// unsymmetric). Its sparsity is that of the elements plus the pairs of elements that have
  /// touched so far.
  class SparseSystem
  {
  public:
    SparseSystem(const spline::Surface &surface, const Equations &equations);

    /// Make room for blocks that couple these pairs of elements; costs nothing if it is there
    /// already.
    void couple(const std::vector<std::pair<unsigned int, unsigned int>> &element_pairs);

    /// Forget which pairs were coupled, and the ordering of the factorisation: the next one depends
    /// on nothing but its matrix.
    void forget();

    void set_zero() { matrix = 0.; }

    /// Add a dense block to all free components of these control points: (3c) x (3c), row by row,
    /// index 3 a + i. Control points may be repeated.
    void add(const std::vector<unsigned int> &control_points, const double *block);

    /// Add a number for each equation to the diagonal.
    void add_diagonal(const dealii::Vector<double> &diagonal, double factor);

    /// @throws NumericsError if the matrix is singular or not finite
    void factorize() { factors.factorize(matrix); }
    void solve(dealii::Vector<double> &right_hand_side) const { factors.solve(right_hand_side); }
    void multiply(dealii::Vector<double> &result, const dealii::Vector<double> &x) const
    {
      matrix.vmult(result, x);
    }

  private:
    const spline::Surface &surface;
    const Equations &equations;
    std::set<std::pair<unsigned int, unsigned int>> coupled;
    dealii::SparsityPattern sparsity;
    dealii::SparseMatrix<double> matrix;
    DirectSolver factors;

    struct Entry
    {
      unsigned int equation;
      unsigned int local;
      bool operator<(const Entry &other) const { return equation < other.equation; }
    };
    // work space of add()
    std::vector<Entry> entries;
    std::vector<dealii::types::global_dof_index> columns;
    std::vector<double> row;

    std::vector<dealii::types::global_dof_index>
    free_equations(const std::vector<unsigned int> &control_points) const;
    void make_sparsity();
  };
} // namespace semilunar::shell

#endif
