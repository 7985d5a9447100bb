// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/flow/state_transfer.h>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_dgq.h>

namespace semilunar::flow
{
  namespace
  {
    std::vector<const Vector *> pointers(const std::vector<Vector> &vectors)
    {
      std::vector<const Vector *> result;
      for (const Vector &vector : vectors)
        result.push_back(&vector);
      return result;
    }

    std::vector<Vector *> pointers(std::vector<Vector> &vectors)
    {
      std::vector<Vector *> result;
      for (Vector &vector : vectors)
        result.push_back(&vector);
      return result;
    }

    /// Calls visit(cell, its numbers at the points of all batches begin at, lane) for owned cells
    /// of the lumen: those of a wall have no such numbers.
    template <int dim, class Visit>
    void for_owned_lumen_cells(const dealii::DoFHandler<dim> &dofs, const Spaces<dim> &spaces,
                               const Visit &visit)
    {
      for (const auto &cell : dofs.active_cell_iterators())
        if (cell->is_locally_owned())
        {
          const CellLane where = spaces.lane_of(cell->active_cell_index());
          if (where.batch < spaces.n_owned_batches())
            visit(cell, std::size_t(where.batch) * dofs.get_fe().dofs_per_cell, where.lane);
        }
    }
  } // namespace

  template <int dim>
  void StateTransfer<dim>::size_parts(const std::size_t n_velocities, const std::size_t n_pressures)
  {
    // Assigned to, vectors may keep the ghosts of the old mesh.
    velocity_parts.clear();
    pressure_parts.clear();
    velocity_parts.assign(dim * n_velocities, Vector(spaces.nodes()));
    pressure_parts.assign(n_pressures, Vector(spaces.pressures()));
  }

  template <int dim>
  void StateTransfer<dim>::make_point_space()
  {
    // The Gauss points as nodes, in the order of the batches.
    const dealii::FE_DGQArbitraryNodes<dim> element(dealii::QGauss<1>(spaces.degree() + 1));
    if (!point_dofs)
      point_dofs =
          std::make_unique<dealii::DoFHandler<dim>>(spaces.velocity_dofs().get_triangulation());
    point_dofs->distribute_dofs(element);
    dealii::IndexSet relevant;
    dealii::DoFTools::extract_locally_relevant_dofs(*point_dofs, relevant);
    point_values.reinit(point_dofs->locally_owned_dofs(), relevant, spaces.communicator());
  }

  template <int dim>
  void StateTransfer<dim>::split(const State &state)
  {
    size_parts(state.velocities.size(), state.pressures.size());
    for (unsigned int v = 0; v < state.velocities.size(); ++v)
      for (unsigned int c = 0; c < dim; ++c)
      {
        Vector &part = velocity_parts[dim * v + c];
        for (unsigned int i = 0; i < part.locally_owned_size(); ++i)
          part.local_element(i) = state.velocities[v]->local_element(dim * i + c);
        part.update_ghost_values();
      }
    for (unsigned int v = 0; v < state.pressures.size(); ++v)
    {
      pressure_parts[v] = *state.pressures[v];
      pressure_parts[v].update_ghost_values();
    }
    point_dofs.reset();
    if (!state.at_points)
      return;
    make_point_space();
    dealii::Vector<double> values(point_dofs->get_fe().dofs_per_cell);
    for_owned_lumen_cells(*point_dofs, spaces,
                          [&](const auto &cell, const auto first, const auto lane)
                          {
                            for (unsigned int q = 0; q < values.size(); ++q)
                              values[q] = (*state.at_points)[first + q][lane];
                            cell->set_dof_values(values, point_values);
                          });
    point_values.update_ghost_values();
  }

  template <int dim>
  void StateTransfer<dim>::attach(const bool for_file)
  {
    const auto prepare_transfer =
        [for_file](Transfer &transfer, const std::vector<const Vector *> &vectors)
    {
      if (for_file)
        transfer.prepare_for_serialization(vectors);
      else
        transfer.prepare_for_coarsening_and_refinement(vectors);
    };
    velocity_transfer = std::make_unique<Transfer>(spaces.velocity_dofs());
    prepare_transfer(*velocity_transfer, pointers(std::as_const(velocity_parts)));
    pressure_transfer = std::make_unique<Transfer>(spaces.pressure_dofs());
    prepare_transfer(*pressure_transfer, pointers(std::as_const(pressure_parts)));
    point_transfer.reset();
    if (point_dofs)
    {
      point_transfer = std::make_unique<Transfer>(*point_dofs);
      prepare_transfer(*point_transfer, {&point_values});
    }
  }

  template <int dim>
  void StateTransfer<dim>::prepare(const State &state, const bool for_file)
  {
    split(state);
    attach(for_file);
  }

  template <int dim>
  void StateTransfer<dim>::merge(const State &state)
  {
    for (unsigned int v = 0; v < state.velocities.size(); ++v)
    {
      state.velocities[v]->reinit(spaces.velocities());
      for (unsigned int c = 0; c < dim; ++c)
        for (unsigned int i = 0; i < velocity_parts[0].locally_owned_size(); ++i)
          state.velocities[v]->local_element(dim * i + c) =
              velocity_parts[dim * v + c].local_element(i);
      spaces.make_readable_velocity(*state.velocities[v]);
    }
    for (unsigned int v = 0; v < state.pressures.size(); ++v)
    {
      // Assignment alone may keep the ghosts of the old mesh.
      state.pressures[v]->reinit(spaces.pressures());
      *state.pressures[v] = pressure_parts[v];
      spaces.make_readable_pressure(*state.pressures[v]);
    }
    if (!point_dofs)
      return;
    const unsigned int n = point_dofs->get_fe().dofs_per_cell;
    state.at_points->assign(std::size_t(spaces.n_owned_batches()) * n, Lanes{});
    dealii::Vector<double> values(n);
    for_owned_lumen_cells(*point_dofs, spaces,
                          [&](const auto &cell, const auto first, const auto lane)
                          {
                            cell->get_dof_values(point_values, values);
                            for (unsigned int q = 0; q < n; ++q)
                              (*state.at_points)[first + q][lane] = values[q];
                          });
  }

  template <int dim>
  void StateTransfer<dim>::finish(const State &state)
  {
    size_parts(state.velocities.size(), state.pressures.size());
    auto velocities = pointers(velocity_parts), pressures = pointers(pressure_parts);
    velocity_transfer->interpolate(velocities);
    pressure_transfer->interpolate(pressures);
    if (point_transfer)
    {
      make_point_space();
      point_transfer->interpolate(point_values);
    }
    merge(state);
  }

  template <int dim>
  void StateTransfer<dim>::load(const State &state, const bool with_points)
  {
    size_parts(state.velocities.size(), state.pressures.size());
    auto velocities = pointers(velocity_parts), pressures = pointers(pressure_parts);
    Transfer(spaces.velocity_dofs()).deserialize(velocities);
    Transfer(spaces.pressure_dofs()).deserialize(pressures);
    point_dofs.reset();
    if (with_points)
    {
      make_point_space();
      std::vector<Vector *> points = {&point_values};
      Transfer(*point_dofs).deserialize(points);
    }
    merge(state);
  }

  template class StateTransfer<2>;
  template class StateTransfer<3>;
} // namespace semilunar::flow
