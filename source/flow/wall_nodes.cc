// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/flow/tensor_kernel.h>
#include <semilunar/flow/wall_nodes.h>

namespace semilunar::flow
{
  /// Stored nodes of the owned cells of batches on any rank, with the masters of hanging ones.
  template <int dim>
  std::vector<bool> WallNodes<dim>::touched(const unsigned int begin, const unsigned int end) const
  {
    const unsigned int n_cell_nodes = power(spaces.degree() + 1, dim);
    Vector count(spaces.nodes());
    std::vector<HangingNodes::Master> masters;
    for (unsigned int batch = begin; batch < end; ++batch)
      for (unsigned int i = 0; i < n_cell_nodes; ++i)
        for (unsigned int lane = 0; lane < spaces.n_filled_lanes(batch); ++lane)
        {
          const unsigned int node = spaces.velocity_nodes(batch)[i][lane];
          count.local_element(node) += 1.;
          spaces.velocity_hanging().masters_of(node, masters);
          for (const auto &master : masters)
            count.local_element(master.node) += 1.;
        }
    count.compress(dealii::VectorOperation::add);
    count.update_ghost_values();
    std::vector<bool> result;
    for (unsigned int i = 0; i < count.locally_owned_size() + spaces.nodes()->n_ghost_indices();
         ++i)
      result.push_back(count.local_element(i) > 0.);
    return result;
  }

  template <int dim>
  void WallNodes<dim>::reinit()
  {
    lumen = touched(0, spaces.n_owned_batches());
    wall = touched(spaces.n_batches(), spaces.end_of_owned_wall());
    owned_nodes.clear();
    for (unsigned int node = 0; node < spaces.nodes()->locally_owned_size(); ++node)
      if (wall[node] && !spaces.velocity_hanging().hangs(node))
        owned_nodes.push_back(node);

    std::vector<bool> used(spaces.pressures()->locally_owned_size() +
                           spaces.pressures()->n_ghost_indices());
    std::vector<HangingNodes::Master> masters;
    for (unsigned int batch = 0; batch < spaces.n_batches(); ++batch)
      for (int i = 0; i < power(spaces.degree(), dim); ++i)
        for (unsigned int lane = 0; lane < spaces.n_filled_lanes(batch); ++lane)
        {
          spaces.pressure_hanging().masters_of(spaces.pressure_nodes(batch)[i][lane], masters);
          for (const auto &master : masters)
            used[master.node] = true;
        }
    idle.clear();
    for (unsigned int i = 0; i < spaces.pressures()->locally_owned_size(); ++i)
      if (!used[i] && !spaces.pressure_hanging().hangs(i))
        idle.push_back(i);
  }

  template class WallNodes<2>;
  template class WallNodes<3>;
} // namespace semilunar::flow
