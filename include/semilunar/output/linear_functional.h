// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_output_linear_functional_h
#define semilunar_output_linear_functional_h

#include <semilunar/output/flow_state.h>

#include <map>

namespace semilunar::output
{
  /// A weighted sum of values of a finite element field at points that were located once.
  class LinearFunctional
  {
  public:
    /// Add the weighted sum of a component over points of a cell.
    /// @param points in the cell's reference coordinates
    template <int dim>
    void add(const dealii::DoFHandler<dim> &dofs,
             const typename dealii::Triangulation<dim>::cell_iterator &cell,
             const std::vector<dealii::Point<dim>> &points, const std::vector<double> &weights,
             unsigned int component);

    /// This rank's part of the value for a vector with ghosts.
    double local_value(const FlowVector &vector) const;

  private:
    std::map<dealii::types::global_dof_index, double> weights;
  };
} // namespace semilunar::output

#endif
