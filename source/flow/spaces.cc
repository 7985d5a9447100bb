// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/flow/spaces.h>
#include <semilunar/mesh/mesh.h>

#include <deal.II/dofs/dof_renumbering.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_tools.h>

namespace semilunar::flow
{
  namespace
  {
    using dealii::IndexSet;
    using dealii::types::global_dof_index;

    template <int dim>
    void constrain_hanging_nodes(const dealii::DoFHandler<dim> &dofs, const IndexSet &relevant,
                                 dealii::AffineConstraints<double> &constraints)
    {
      constraints.clear();
      constraints.reinit(relevant);
      dealii::DoFTools::make_hanging_node_constraints(dofs, constraints);
      constraints.close();
    }

    IndexSet interleaved(const IndexSet &nodes, const unsigned int n_components)
    {
      IndexSet all(nodes.size() * n_components);
      for (auto interval = nodes.begin_intervals(); interval != nodes.end_intervals(); ++interval)
        all.add_range(*interval->begin() * n_components, (interval->last() + 1) * n_components);
      all.compress();
      return all;
    }
  } // namespace

  template <int dim>
  Spaces<dim>::Spaces(const dealii::parallel::distributed::Triangulation<dim> &triangulation,
                      const unsigned int degree)
      : velocity_element(degree), pressure_element(degree - 1), velocity_handler(triangulation),
        pressure_handler(triangulation)
  {
    distribute_dofs();
  }

  template <int dim>
  void Spaces<dim>::distribute_dofs()
  {
    number_unknowns();
    make_batches();
  }

  template <int dim>
  void Spaces<dim>::number_unknowns()
  {
    velocity_handler.distribute_dofs(velocity_element);
    pressure_handler.distribute_dofs(pressure_element);
    dealii::DoFRenumbering::Cuthill_McKee(velocity_handler);

    IndexSet relevant;
    dealii::DoFTools::extract_locally_relevant_dofs(velocity_handler, relevant);
    const IndexSet &owned = velocity_handler.locally_owned_dofs();
    constrain_hanging_nodes(velocity_handler, relevant, velocity_affine);
    node_partitioner = std::make_shared<Partitioner>(owned, relevant, communicator());
    velocity_partitioner = std::make_shared<Partitioner>(
        interleaved(owned, dim), interleaved(relevant, dim), communicator());
    hanging_velocity.reinit(velocity_affine, *node_partitioner);

    dealii::DoFTools::extract_locally_relevant_dofs(pressure_handler, relevant);
    constrain_hanging_nodes(pressure_handler, relevant, pressure_affine);
    pressure_partitioner = std::make_shared<Partitioner>(pressure_handler.locally_owned_dofs(),
                                                         relevant, communicator());
    hanging_pressure.reinit(pressure_affine, *pressure_partitioner);
  }

  template <int dim>
  void Spaces<dim>::make_batches()
  {
    n_cells_of_batch.clear();
    velocity_nodes_of_batch.clear();
    pressure_nodes_of_batch.clear();
    lane_of_cell.assign(velocity_handler.get_triangulation().n_active_cells(), CellLane());
    append_cells(true, false);
    owned_batches = n_cells_of_batch.size();
    append_cells(false, false);
    lumen_batches = n_cells_of_batch.size();
    append_cells(true, true);
    owned_wall_end = n_cells_of_batch.size();
    append_cells(false, true);
    lumen_exists = dealii::Utilities::MPI::max(owned_batches, communicator()) > 0;
    wall_exists = dealii::Utilities::MPI::max(owned_wall_end - lumen_batches, communicator()) > 0;
  }

  template <int dim>
  void Spaces<dim>::append_cells(const bool owned, const bool in_wall)
  {
    const unsigned int n_u = velocity_element.dofs_per_cell, n_p = pressure_element.dofs_per_cell;
    const auto order_u = dealii::FETools::lexicographic_to_hierarchic_numbering<dim>(degree());
    const auto order_p = dealii::FETools::lexicographic_to_hierarchic_numbering<dim>(degree() - 1);
    std::vector<global_dof_index> dofs_u(n_u), dofs_p(n_p);

    const auto append = [](const unsigned int lane, const std::vector<global_dof_index> &dofs,
                           const std::vector<unsigned int> &order, const Partitioner &partitioner,
                           std::vector<NodesOfLanes> &nodes)
    {
      if (lane == 0)
        nodes.resize(nodes.size() + dofs.size());
      NodesOfLanes *batch = nodes.data() + nodes.size() - dofs.size();
      for (unsigned int i = 0; i < dofs.size(); ++i)
      {
        const unsigned int stored = partitioner.global_to_local(dofs[order[i]]);
        for (unsigned int l = lane; l < (lane == 0 ? n_lanes : lane + 1); ++l)
          batch[i][l] = stored;
      }
    };

    unsigned int lane = n_lanes;
    auto pressure_cell = pressure_handler.begin_active();
    for (const auto &cell : velocity_handler.active_cell_iterators())
    {
      const auto cell_p = pressure_cell++;
      if ((owned ? !cell->is_locally_owned() : !cell->is_ghost()) ||
          (cell->material_id() == mesh::wall) != in_wall)
        continue;
      if (lane == n_lanes)
      {
        n_cells_of_batch.push_back(0);
        lane = 0;
      }
      cell->get_dof_indices(dofs_u);
      cell_p->get_dof_indices(dofs_p);
      append(lane, dofs_u, order_u, *node_partitioner, velocity_nodes_of_batch);
      append(lane, dofs_p, order_p, *pressure_partitioner, pressure_nodes_of_batch);
      lane_of_cell[cell->active_cell_index()] = {
          static_cast<unsigned int>(n_cells_of_batch.size() - 1), lane};
      n_cells_of_batch.back() = ++lane;
    }
  }

  template <int dim>
  void Spaces<dim>::make_readable_velocity(const Vector &velocity) const
  {
    velocity.update_ghost_values();
    if (!hanging_velocity.empty())
      hanging_velocity.expand<dim>(const_cast<double *>(velocity.begin()));
  }

  template <int dim>
  void Spaces<dim>::make_readable_pressure(const Vector &pressure) const
  {
    pressure.update_ghost_values();
    if (!hanging_pressure.empty())
      hanging_pressure.expand<1>(const_cast<double *>(pressure.begin()));
  }

  template class Spaces<2>;
  template class Spaces<3>;
} // namespace semilunar::flow
