// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/output/velocity_dofs.h>

namespace semilunar::output
{
  template <int dim>
  VelocityDofs<dim>::VelocityDofs(const dealii::DoFHandler<dim> &scalar)
      : element(scalar.get_fe(), dim), dofs(scalar.get_triangulation())
  {
    using Index = dealii::types::global_dof_index;
    dofs.distribute_dofs(element);
    std::vector<Index> new_numbers(dofs.n_locally_owned_dofs());
    std::vector<Index> vector_indices(element.dofs_per_cell),
        scalar_indices(scalar.get_fe().dofs_per_cell);
    const dealii::IndexSet &owned = dofs.locally_owned_dofs();
    auto scalar_cell = scalar.begin_active();
    for (const auto &cell : dofs.active_cell_iterators())
    {
      if (cell->is_locally_owned())
      {
        cell->get_dof_indices(vector_indices);
        scalar_cell->get_dof_indices(scalar_indices);
        for (unsigned int i = 0; i < element.dofs_per_cell; ++i)
          if (owned.is_element(vector_indices[i]))
          {
            const auto [component, node] = element.system_to_component_index(i);
            new_numbers[owned.index_within_set(vector_indices[i])] =
                dim * scalar_indices[node] + component;
          }
      }
      ++scalar_cell;
    }
    dofs.renumber_dofs(new_numbers);
  }

  template class VelocityDofs<2>;
  template class VelocityDofs<3>;
} // namespace semilunar::output
