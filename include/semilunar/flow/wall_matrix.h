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
  /// The matrix between the velocities of the nodes of wall cells, those of the interface with the
  /// lumen included, and its factorisation on each rank: what the wall is preconditioned with, or
  /// solved for on one rank. It is symmetric: its upper triangle counts. Each rank has the nodes
  /// that it owns, if asked for also those of ghost cells all of whose wall cells it sees
  /// (restricted additive Schwarz method: the inverse is not symmetric then).
  template <int dim>
  class WallMatrix
  {
  public:
    WallMatrix(const Spaces<dim> &spaces, const WallNodes<dim> &nodes, const bool overlapping)
        : spaces(spaces), wall_nodes(nodes), overlapping(overlapping)
    {
    }

    /// Build the pattern, after construction and when the mesh was refined. Collective.
    void reinit();

    /// Assemble what the forms were linearised about.
    void assemble(const WallForms<dim> &forms);
    /// Add the same entry for all components, between two stored nodes; those that have no part in
    /// the matrix are passed over.
    void add(unsigned int row, unsigned int column, double entry);
    /// Add the entries [node][node] of cells of the lumen but for those between two owned nodes.
    void add_lumen_of_others(unsigned int batch, const Lanes *matrix);
    /// Remove given directions and factorise. @throws NumericsError if that is not possible
    void factorise(const VelocityConstraints<dim> &constraints);

    /// x = A^-1 b for the entries of owned nodes of the wall; others stay. Both may be the same.
    /// Collective.
    void solve(const Vector &b, Vector &x) const;

  private:
    using Block = dealii::Tensor<2, dim>;
    /// Factors in space are large; what they precondition needs no digits of theirs.
    using Number = std::conditional_t<dim == 3, float, double>;

    /// The nodes of the matrix, numbered.
    void find_nodes();
    void make_pattern();
    /// Nodes of other ranks all of whose wall cells this one sees.
    std::vector<unsigned int> overlap() const;
    Block *find(unsigned int row, unsigned int column);
    void add_cell(const CellLane &cell, const Lanes *matrix);
    void eliminate(const VelocityConstraints<dim> &constraints);

    const Spaces<dim> &spaces;
    const WallNodes<dim> &wall_nodes;
    const bool overlapping;
    std::vector<unsigned int> nodes; ///< stored indices, owned ones first
    std::vector<int> number;         ///< of a stored node among them, or -1
    /// Where values of other ranks arrive, with no more ghosts than that takes.
    mutable Vector shared;
    std::vector<unsigned int> place; ///< of each node's first component in it
    // Blocks of rows, in each those from the diagonal on, columns sorted.
    std::vector<unsigned int> row_start, column;
    std::vector<Block> value;
    SparseCholesky<Number> factors;
    mutable std::vector<double> work;
  };
} // namespace semilunar::flow

#endif
