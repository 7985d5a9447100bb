// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_flow_wall_matrix_h
#define semilunar_flow_wall_matrix_h

#include <semilunar/flow/sparse_cholesky.h>
#include <semilunar/flow/velocity_constraints.h>
#include <semilunar/flow/wall_forms.h>
#include <semilunar/flow/wall_nodes.h>

#include <type_traits>

namespace semilunar::flow
{
  /// The matrix between the velocities of the nodes of wall cells that a rank owns, those of the
  /// interface with the lumen included, and its factorisation: what the wall is preconditioned
  /// with, or solved for on one rank. It is symmetric: its upper triangle counts.
  template <int dim>
  class WallMatrix
  {
  public:
    WallMatrix(const Spaces<dim> &spaces, const WallNodes<dim> &nodes)
        : spaces(spaces), wall_nodes(nodes)
    {
    }

    /// Build the pattern, after construction and when the mesh was refined.
    void reinit();

    /// Assemble what the forms were linearised about.
    void assemble(const WallForms<dim> &forms);
    /// Add the same entry for all components, between owned nodes of the wall.
    void add(unsigned int row, unsigned int column, double entry);
    /// Remove given directions and factorise. @throws NumericsError if that is not possible
    void factorise(const VelocityConstraints<dim> &constraints);

    /// x = A^-1 b for the entries of owned nodes of the wall; others stay.
    void solve(const Vector &b, Vector &x) const;

  private:
    using Block = dealii::Tensor<2, dim>;
    /// Factors in space are large; what they precondition needs no digits of theirs.
    using Number = std::conditional_t<dim == 3, float, double>;

    Block *find(unsigned int row, unsigned int column);
    void add_cell(const CellLane &cell, const Lanes *matrix);
    void eliminate(const VelocityConstraints<dim> &constraints);

    const Spaces<dim> &spaces;
    const WallNodes<dim> &wall_nodes;
    std::vector<int> number; ///< of a stored node among the owned ones of the wall, or -1
    // Blocks of rows, in each those from the diagonal on, columns sorted.
    std::vector<unsigned int> row_start, column;
    std::vector<Block> value;
    SparseCholesky<Number> factors;
    mutable std::vector<double> work;
  };
} // namespace semilunar::flow

#endif
