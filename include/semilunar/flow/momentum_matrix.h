// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_flow_momentum_matrix_h
#define semilunar_flow_momentum_matrix_h

#include <semilunar/flow/equations.h>
#include <semilunar/flow/ilu.h>
#include <semilunar/flow/wall_matrix.h>

namespace semilunar::flow
{
  /// The matrix of one velocity component between the nodes of a rank, the same for all components:
  /// what the velocity is preconditioned with. Rows of nodes whose velocity is given in all
  /// directions, and of those of the wall, are those of the identity.
  template <int dim>
  class MomentumMatrix
  {
  public:
    /// Build the pattern.
    explicit MomentumMatrix(const Spaces<dim> &spaces);
    void reinit();

    /// Assemble the state that the equations were linearised about.
    /// @param wall gets the entries between nodes of the interface, unless nullptr
    void assemble(const Equations<dim> &equations, WallMatrix<dim> *wall);

    const CompressedRows &rows() const { return matrix; }
    /// Diagonal entries, at the interface those of the lumen; 1 where all components are given.
    std::vector<double> diagonal() const;

    /// r -= A x at nodes of the lumen, x the velocities at the interface (both in one vector).
    void subtract_interface(Vector &velocity) const;

  private:
    void find_places();
    void add_batch(unsigned int batch, const Lanes *cell_matrix);
    void add_entry(const CellLane &cell, unsigned int i, unsigned int j, double entry);
    /// Of a cell with hanging nodes. @param entry gives those of [node][node]
    template <class GetEntry>
    void add_irregular_cell(const CellLane &cell, const GetEntry &entry);
    /// Entries [node][node] of a cell.
    void add_cell(const CellLane &cell, const double *entries);
    float *find(unsigned int row, unsigned int column);
    void eliminate(const VelocityConstraints<dim> &constraints);
    void separate_wall(const WallNodes<dim> &nodes, const VelocityConstraints<dim> &constraints,
                       WallMatrix<dim> *wall);

    /// Place in its row of each pair of nodes of a cell, or this if one of them hangs or belongs to
    /// another rank.
    static constexpr unsigned short absent = -1;

    const Spaces<dim> &spaces;
    unsigned int n_cell_nodes, n_owned = 0;
    CompressedRows matrix;
    std::vector<unsigned short> place; ///< [batch][lane][i][j]
    std::vector<bool> irregular;       ///< [batch * n_lanes + lane]: a node hangs

    /// What separate_wall() takes out of the matrix.
    struct Entry
    {
      unsigned int row, column;
      double value;
    };
    std::vector<Entry> of_interface; ///< columns of the interface in rows of the lumen
    std::vector<std::pair<unsigned int, double>> interface_diagonal;
  };
} // namespace semilunar::flow

#endif
