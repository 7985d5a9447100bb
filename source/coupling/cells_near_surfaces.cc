// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/coupling/cells_near_surfaces.h>

#include <deal.II/base/mpi.h>

#include <cmath>

namespace semilunar::coupling
{
  CellsNearSurfaces::CellsNearSurfaces(const flow::Spaces<3> &spaces) : spaces(spaces) {}

  bool CellsNearSurfaces::mark(const std::vector<unsigned int> &cut)
  {
    // Two cells touch if they share a node of the pressure: the vertices, with hanging ones.
    flow::Vector touched(spaces.pressures());
    const auto &handler = spaces.pressure_dofs();
    std::vector<bool> is_cut(handler.get_triangulation().n_active_cells(), false);
    for (const unsigned int cell : cut)
      is_cut[cell] = true;
    std::vector<dealii::types::global_dof_index> dofs(handler.get_fe().dofs_per_cell);
    for (const auto &cell : handler.active_cell_iterators())
      if (cell->is_locally_owned() && is_cut[cell->active_cell_index()])
      {
        cell->get_dof_indices(dofs);
        for (const auto dof : dofs)
          touched(dof) = 1.;
      }
    touched.compress(dealii::VectorOperation::add);
    touched.update_ghost_values();

    std::vector<bool> new_marks(is_cut.size(), false);
    for (const auto &cell : handler.active_cell_iterators())
      if (!cell->is_artificial() && spaces.in_lumen(cell->active_cell_index()))
      {
        cell->get_dof_indices(dofs);
        for (const auto dof : dofs)
          if (touched(dof) > 0.)
            new_marks[cell->active_cell_index()] = true;
      }
    const bool changed = new_marks != is_marked;
    is_marked = std::move(new_marks);
    return dealii::Utilities::MPI::max(changed ? 1 : 0, spaces.communicator()) > 0;
  }

  std::vector<flow::Lanes> CellsNearSurfaces::weights(const double factor,
                                                      const double constant) const
  {
    std::vector<flow::Lanes> result(spaces.n_batches(), flow::Lanes{});
    for (const auto &cell : spaces.velocity_dofs().active_cell_iterators())
      if (!cell->is_artificial() && is_marked[cell->active_cell_index()])
      {
        const auto [batch, lane] = spaces.lane_of(cell->active_cell_index());
        result[batch][lane] = factor * std::pow(cell->measure(), 2. / 3.) + constant;
      }
    return result;
  }
} // namespace semilunar::coupling
