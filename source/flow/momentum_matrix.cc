// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/flow/momentum_matrix.h>
#include <semilunar/flow/tensor_kernel.h>

#include <deal.II/base/aligned_vector.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <algorithm>

namespace semilunar::flow
{
  template <int dim>
  MomentumMatrix<dim>::MomentumMatrix(const Spaces<dim> &spaces)
      : spaces(spaces), n_cell_nodes(power(spaces.degree() + 1, dim))
  {
  }

  template <int dim>
  void MomentumMatrix<dim>::reinit()
  {
    n_owned = spaces.nodes()->locally_owned_size();
    irregular.assign(spaces.n_batches() * n_lanes, false);
    dealii::DynamicSparsityPattern pattern(n_owned, n_owned);
    std::vector<HangingNodes::Master> masters;
    std::vector<dealii::types::global_dof_index> nodes;
    for (unsigned int i = 0; i < n_owned; ++i)
      pattern.add(i, i);
    for (unsigned int batch = 0; batch < spaces.n_batches(); ++batch)
      for (unsigned int lane = 0; lane < spaces.n_filled_lanes(batch); ++lane)
      {
        nodes.clear();
        for (unsigned int i = 0; i < n_cell_nodes; ++i)
        {
          const unsigned int node = spaces.velocity_nodes(batch)[i][lane];
          if (spaces.velocity_hanging().hangs(node))
            irregular[batch * n_lanes + lane] = true;
          spaces.velocity_hanging().masters_of(node, masters);
          for (const auto &master : masters)
            if (master.node < n_owned)
              nodes.push_back(master.node);
        }
        std::sort(nodes.begin(), nodes.end());
        nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
        for (const auto row : nodes)
          pattern.add_entries(row, nodes.begin(), nodes.end(), true);
      }
    matrix.row_start.assign(1, 0);
    matrix.column.clear();
    for (unsigned int i = 0; i < n_owned; ++i)
    {
      for (auto entry = pattern.begin(i); entry != pattern.end(i); ++entry)
        matrix.column.push_back(entry->column());
      matrix.row_start.push_back(matrix.column.size());
    }
    matrix.value.resize(matrix.column.size());
    find_places();
  }

  template <int dim>
  float *MomentumMatrix<dim>::find(const unsigned int row, const unsigned int column)
  {
    const auto begin = matrix.column.begin() + matrix.row_start[row];
    const auto end = matrix.column.begin() + matrix.row_start[row + 1];
    return matrix.value.data() + (std::lower_bound(begin, end, column) - matrix.column.begin());
  }

  template <int dim>
  void MomentumMatrix<dim>::find_places()
  {
    const std::size_t n2 = n_cell_nodes * n_cell_nodes;
    place.assign(spaces.n_batches() * n_lanes * n2, absent);
    for (unsigned int batch = 0; batch < spaces.n_batches(); ++batch)
      for (unsigned int lane = 0; lane < spaces.n_filled_lanes(batch); ++lane)
        if (!irregular[batch * n_lanes + lane])
        {
          const auto *nodes = spaces.velocity_nodes(batch);
          unsigned short *places = place.data() + (batch * n_lanes + lane) * n2;
          for (unsigned int i = 0; i < n_cell_nodes; ++i)
            for (unsigned int j = 0; j < n_cell_nodes; ++j)
              if (nodes[i][lane] < n_owned && nodes[j][lane] < n_owned)
                places[i * n_cell_nodes + j] = find(nodes[i][lane], nodes[j][lane]) -
                                               matrix.value.data() -
                                               matrix.row_start[nodes[i][lane]];
        }
  }

  template <int dim>
  void MomentumMatrix<dim>::add_entry(const CellLane &cell, const unsigned int i,
                                      const unsigned int j, const double entry)
  {
    std::vector<HangingNodes::Master> rows, columns;
    const auto *nodes = spaces.velocity_nodes(cell.batch);
    spaces.velocity_hanging().masters_of(nodes[i][cell.lane], rows);
    spaces.velocity_hanging().masters_of(nodes[j][cell.lane], columns);
    for (const auto &row : rows)
      for (const auto &column : columns)
        if (row.node < n_owned && column.node < n_owned)
          *find(row.node, column.node) += row.weight * column.weight * entry;
  }

  template <int dim>
  template <class GetEntry>
  void MomentumMatrix<dim>::add_irregular_cell(const CellLane &cell, const GetEntry &entry)
  {
    // The rows and columns of hanging nodes go to those that they hang from: W^T A W, with each
    // pair of nodes then looked up once.
    const auto *nodes = spaces.velocity_nodes(cell.batch);
    std::vector<std::vector<HangingNodes::Master>> masters(n_cell_nodes);
    std::vector<unsigned int> all;
    for (unsigned int i = 0; i < n_cell_nodes; ++i)
    {
      spaces.velocity_hanging().masters_of(nodes[i][cell.lane], masters[i]);
      for (const auto &master : masters[i])
        all.push_back(master.node);
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    const unsigned int n = all.size();
    for (auto &of_node : masters) // from here on numbered in all
      for (auto &master : of_node)
        master.node = std::lower_bound(all.begin(), all.end(), master.node) - all.begin();

    std::vector<double> half(n), condensed(n * n, 0.);
    for (unsigned int i = 0; i < n_cell_nodes; ++i)
    {
      std::fill(half.begin(), half.end(), 0.);
      for (unsigned int j = 0; j < n_cell_nodes; ++j)
      {
        const double a = entry(i * n_cell_nodes + j);
        for (const auto &master : masters[j])
          half[master.node] += master.weight * a;
      }
      for (const auto &master : masters[i])
        for (unsigned int k = 0; k < n; ++k)
          condensed[master.node * n + k] += master.weight * half[k];
    }
    const unsigned int n_of_rank =
        std::lower_bound(all.begin(), all.end(), n_owned) - all.begin(); // others come last
    for (unsigned int i = 0; i < n_of_rank; ++i)
    {
      unsigned int at = matrix.row_start[all[i]];
      for (unsigned int j = 0; j < n_of_rank; ++j)
      {
        while (matrix.column[at] != all[j]) // both ascend
          ++at;
        matrix.value[at] += condensed[i * n + j];
      }
    }
  }

  template <int dim>
  void MomentumMatrix<dim>::add_batch(const unsigned int batch, const Lanes *cell_matrix)
  {
    const std::size_t n2 = n_cell_nodes * n_cell_nodes;
    const auto *nodes = spaces.velocity_nodes(batch);
    for (unsigned int lane = 0; lane < spaces.n_filled_lanes(batch); ++lane)
    {
      if (irregular[batch * n_lanes + lane])
      {
        add_irregular_cell({batch, lane},
                           [&](const unsigned int entry) { return cell_matrix[entry][lane]; });
        continue;
      }
      const unsigned short *places = place.data() + (batch * n_lanes + lane) * n2;
      for (unsigned int i = 0; i < n_cell_nodes; ++i)
        if (nodes[i][lane] < n_owned)
        {
          float *row = matrix.value.data() + matrix.row_start[nodes[i][lane]];
          for (unsigned int j = 0; j < n_cell_nodes; ++j)
            if (const unsigned short at = places[i * n_cell_nodes + j]; at != absent)
              row[at] += cell_matrix[i * n_cell_nodes + j][lane];
        }
    }
  }

  template <int dim>
  void MomentumMatrix<dim>::add_cell(const CellLane &cell, const double *entries)
  {
    if (irregular[cell.batch * n_lanes + cell.lane])
    {
      add_irregular_cell(cell, [entries](const unsigned int entry) { return entries[entry]; });
      return;
    }
    const auto *nodes = spaces.velocity_nodes(cell.batch);
    const unsigned short *places = place.data() + (cell.batch * n_lanes + cell.lane) *
                                                      std::size_t(n_cell_nodes * n_cell_nodes);
    for (unsigned int i = 0; i < n_cell_nodes; ++i)
      if (nodes[i][cell.lane] < n_owned)
      {
        float *row = matrix.value.data() + matrix.row_start[nodes[i][cell.lane]];
        for (unsigned int j = 0; j < n_cell_nodes; ++j)
          if (const unsigned short at = places[i * n_cell_nodes + j]; at != absent)
            row[at] += entries[i * n_cell_nodes + j];
      }
  }

  template <int dim>
  void MomentumMatrix<dim>::assemble(const Equations<dim> &equations, WallMatrix<dim> *wall)
  {
    std::fill(matrix.value.begin(), matrix.value.end(), 0.f);
    dealii::AlignedVector<Lanes> cell_matrix(n_cell_nodes * n_cell_nodes);
    for (unsigned int batch = 0; batch < spaces.n_batches(); ++batch)
    {
      equations.cells().momentum_matrix(batch, cell_matrix.data());
      add_batch(batch, cell_matrix.data());
      if (wall)
        wall->add_lumen_of_others(batch, cell_matrix.data());
    }
    const auto add = [this](const CellLane &cell, const unsigned int i, const unsigned int j,
                            const double entry) { add_entry(cell, i, j, entry); };
    for (const auto &[id, condition] : equations.conditions().all())
      if (condition.pressure && equations.faces().parts().count(id) > 0)
        equations.faces().backflow_matrix(id, add);
    equations.points().matrix([this](const CellLane &cell, const double *entries)
                              { add_cell(cell, entries); });
    if (equations.wall())
      separate_wall(equations.wall()->nodes(), equations.constraints(), wall);
    eliminate(equations.constraints());
  }

  template <int dim>
  void MomentumMatrix<dim>::separate_wall(const WallNodes<dim> &nodes,
                                          const VelocityConstraints<dim> &constraints,
                                          WallMatrix<dim> *wall)
  {
    of_interface.clear();
    interface_diagonal.clear();
    for (unsigned int i = 0; i < n_owned; ++i)
      for (unsigned int k = matrix.row_start[i]; k < matrix.row_start[i + 1]; ++k)
      {
        const unsigned int j = matrix.column[k];
        if (nodes.in_wall(i) && nodes.in_wall(j))
        {
          if (wall && matrix.value[k] != 0.f)
            wall->add(i, j, matrix.value[k]);
          if (i == j && !constraints.fixed(i) && !spaces.velocity_hanging().hangs(i))
            interface_diagonal.emplace_back(i, matrix.value[k]);
        }
        else if (nodes.in_wall(j) && !constraints.fixed(i) && matrix.value[k] != 0.f)
          of_interface.push_back({i, j, matrix.value[k]});
        if (nodes.in_wall(i) || nodes.in_wall(j))
          matrix.value[k] = i == j ? 1.f : 0.f;
      }
  }

  template <int dim>
  void MomentumMatrix<dim>::subtract_interface(Vector &velocity) const
  {
    for (const Entry &entry : of_interface)
      for (unsigned int c = 0; c < dim; ++c)
        velocity.local_element(dim * entry.row + c) -=
            entry.value * velocity.local_element(dim * entry.column + c);
  }

  template <int dim>
  void MomentumMatrix<dim>::eliminate(const VelocityConstraints<dim> &constraints)
  {
    const auto is_identity = [&](const unsigned int node)
    { return constraints.fixed(node) || spaces.velocity_hanging().hangs(node); };
    for (unsigned int i = 0; i < n_owned; ++i)
    {
      const bool identity = is_identity(i);
      for (unsigned int k = matrix.row_start[i]; k < matrix.row_start[i + 1]; ++k)
        if (matrix.column[k] == i && identity)
          matrix.value[k] = 1.f;
        else if (identity || is_identity(matrix.column[k]))
          matrix.value[k] = 0.f;
    }
  }

  template <int dim>
  std::vector<double> MomentumMatrix<dim>::diagonal() const
  {
    std::vector<double> entries(n_owned);
    for (unsigned int i = 0; i < n_owned; ++i)
      for (unsigned int k = matrix.row_start[i]; k < matrix.row_start[i + 1]; ++k)
        if (matrix.column[k] == i)
          entries[i] = matrix.value[k];
    for (const auto &[node, entry] : interface_diagonal)
      if (entry > 0.)
        entries[node] = entry;
    return entries;
  }

  template class MomentumMatrix<2>;
  template class MomentumMatrix<3>;
} // namespace semilunar::flow
