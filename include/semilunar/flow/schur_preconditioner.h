// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_flow_schur_preconditioner_h
#define semilunar_flow_schur_preconditioner_h

#include <semilunar/flow/equations.h>
#include <semilunar/flow/ilu.h>

#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

namespace semilunar::flow
{
  /// Approximate inverse of the Schur complement of the pressure: equation (15) where inertia
  /// rules, one V-cycle of algebraic multigrid and a diagonal scaling, or equation (16) where
  /// advection does, two V-cycles and a product with the momentum matrix.
  template <int dim>
  class SchurPreconditioner
  {
  public:
    /// @param of_lumen diagonal of the momentum matrix of the lumen, owned nodes
    void build(const Equations<dim> &equations, const std::vector<double> &of_lumen);

    /// Equation (15).
    void vmult(Vector &result, const Vector &residual) const;
    /// Equation (16). @param momentum the current one
    void vmult(Vector &result, const Vector &residual, const CompressedRows &momentum) const;

    /// What a source of volume adds to the continuity equation: the diagonal of M of equation (15).
    void volume_source(Vector &result) const;

    bool empty() const { return gradient.m() == 0; }

  private:
    void assemble_gradient(const Equations<dim> &equations);
    void assemble_mass(const Equations<dim> &equations);
    /// The diagonal with the wall's impedance at the interface: equation (8) of doc/theory/wall.md.
    std::vector<double> with_wall(const Equations<dim> &equations,
                                  const std::vector<double> &of_lumen) const;

    dealii::TrilinosWrappers::SparseMatrix gradient; ///< B^T, rows of given velocities are zero
    dealii::TrilinosWrappers::SparseMatrix schur;
    dealii::TrilinosWrappers::PreconditionAMG multigrid;
    Vector inverse_mass;                  ///< (mu + gamma) / diagonal of M
    std::vector<unsigned int> idle;       ///< pressures inside a wall
    std::vector<double> inverse_diagonal; ///< D^-1, owned nodes
    mutable Vector velocity, change, pressure;
  };
} // namespace semilunar::flow

#endif
