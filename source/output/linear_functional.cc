// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/output/linear_functional.h>

namespace semilunar::output
{
  template <int dim>
  void LinearFunctional::add(const dealii::DoFHandler<dim> &dofs,
                             const typename dealii::Triangulation<dim>::cell_iterator &cell,
                             const std::vector<dealii::Point<dim>> &points,
                             const std::vector<double> &point_weights, const unsigned int component)
  {
    const auto &fe = dofs.get_fe();
    const typename dealii::DoFHandler<dim>::active_cell_iterator dof_cell(
        &dofs.get_triangulation(), cell->level(), cell->index(), &dofs);
    std::vector<dealii::types::global_dof_index> indices(fe.dofs_per_cell);
    dof_cell->get_dof_indices(indices);
    for (unsigned int i = 0; i < fe.dofs_per_cell; ++i)
      if (fe.system_to_component_index(i).first == component)
        for (std::size_t q = 0; q < points.size(); ++q)
          weights[indices[i]] +=
              point_weights[q] * fe.shape_value_component(i, points[q], component);
  }

  double LinearFunctional::local_value(const FlowVector &vector) const
  {
    double sum = 0.;
    for (const auto &[index, weight] : weights)
      sum += weight * vector(index);
    return sum;
  }

  template void LinearFunctional::add(const dealii::DoFHandler<2> &,
                                      const typename dealii::Triangulation<2>::cell_iterator &,
                                      const std::vector<dealii::Point<2>> &,
                                      const std::vector<double> &, unsigned int);
  template void LinearFunctional::add(const dealii::DoFHandler<3> &,
                                      const typename dealii::Triangulation<3>::cell_iterator &,
                                      const std::vector<dealii::Point<3>> &,
                                      const std::vector<double> &, unsigned int);
} // namespace semilunar::output
