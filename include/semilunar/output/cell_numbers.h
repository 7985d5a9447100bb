// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_output_cell_numbers_h
#define semilunar_output_cell_numbers_h

#include <semilunar/output/flow_state.h>

#include <deal.II/lac/vector.h>

namespace semilunar::output
{
  /// How well cells resolve a flow, by active cell index (O5).
  struct CellNumbers
  {
    dealii::Vector<float> reynolds; ///< rho |u| h / (k mu)
    dealii::Vector<float> cfl;      ///< |u| dt k / h
  };

  /// The largest values over the corners and the centre of each locally owned cell.
  template <int dim>
  CellNumbers cell_numbers(const FlowState<dim> &state);

  /// Indicators of the error of the velocity (H7), by active cell index; NaN-free also on ghost
  /// cells, where they are 0.
  template <int dim>
  dealii::Vector<float> error_indicators(const FlowState<dim> &state, double vorticity_weight);
} // namespace semilunar::output

#endif
