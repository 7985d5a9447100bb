// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/flow/tensor_kernel.h>
#include <semilunar/flow/wall_matrix.h>

#include <deal.II/base/aligned_vector.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <algorithm>

namespace semilunar::flow
{
  using Masters = std::vector<HangingNodes::Master>;

  template <int dim>
  void WallMatrix<dim>::reinit()
  {
    find_nodes();
    make_pattern();
  }

  template <int dim>
  std::vector<unsigned int> WallMatrix<dim>::overlap() const
  {
    // Rows are complete where as many cells are seen as there are on all ranks.
    const unsigned int n_cell_nodes = power(spaces.degree() + 1, dim);
    std::vector<unsigned int> seen(spaces.nodes()->locally_owned_size() +
                                   spaces.nodes()->n_ghost_indices());
    Vector all(spaces.nodes());
    Masters masters;
    for (unsigned int batch = spaces.n_batches(); batch < spaces.end_of_wall(); ++batch)
      for (unsigned int lane = 0; lane < spaces.n_filled_lanes(batch); ++lane)
        for (unsigned int i = 0; i < n_cell_nodes; ++i)
        {
          spaces.velocity_hanging().masters_of(spaces.velocity_nodes(batch)[i][lane], masters);
          for (const auto &master : masters)
          {
            ++seen[master.node];
            if (batch < spaces.end_of_owned_wall())
              all.local_element(master.node) += 1.;
          }
        }
    all.compress(dealii::VectorOperation::add);
    all.update_ghost_values();
    std::vector<unsigned int> result;
    for (unsigned int node = spaces.nodes()->locally_owned_size(); node < seen.size(); ++node)
      if (seen[node] > 0 && seen[node] == all.local_element(node))
        result.push_back(node);
    return result;
  }

  template <int dim>
  void WallMatrix<dim>::find_nodes()
  {
    nodes = wall_nodes.owned();
    if (overlapping)
    {
      const std::vector<unsigned int> others = overlap();
      if (!nodes.empty())
        nodes.insert(nodes.end(), others.begin(), others.end());
    }
    number.assign(spaces.nodes()->locally_owned_size() + spaces.nodes()->n_ghost_indices(), -1);
    dealii::IndexSet ghosts(spaces.velocities()->size());
    for (unsigned int i = 0; i < nodes.size(); ++i)
    {
      number[nodes[i]] = i;
      const auto first = dim * spaces.nodes()->local_to_global(nodes[i]);
      if (i >= wall_nodes.owned().size())
        ghosts.add_range(first, first + dim);
    }
    const auto partitioner = std::make_shared<dealii::Utilities::MPI::Partitioner>(
        spaces.velocities()->locally_owned_range(), ghosts, spaces.communicator());
    shared.reinit(partitioner);
    place.clear();
    for (const unsigned int node : nodes)
      place.push_back(partitioner->global_to_local(dim * spaces.nodes()->local_to_global(node)));
    work.resize(dim * nodes.size());
  }

  template <int dim>
  void WallMatrix<dim>::make_pattern()
  {
    const unsigned int n_cell_nodes = power(spaces.degree() + 1, dim);
    dealii::DynamicSparsityPattern pattern(nodes.size(), nodes.size());
    Masters masters;
    std::vector<dealii::types::global_dof_index> of_cell;
    for (unsigned int batch = spaces.n_batches(); batch < spaces.end_of_wall(); ++batch)
      for (unsigned int lane = 0; lane < spaces.n_filled_lanes(batch); ++lane)
      {
        of_cell.clear();
        for (unsigned int i = 0; i < n_cell_nodes; ++i)
        {
          spaces.velocity_hanging().masters_of(spaces.velocity_nodes(batch)[i][lane], masters);
          for (const auto &master : masters)
            if (number[master.node] >= 0)
              of_cell.push_back(number[master.node]);
        }
        std::sort(of_cell.begin(), of_cell.end());
        of_cell.erase(std::unique(of_cell.begin(), of_cell.end()), of_cell.end());
        for (const auto row : of_cell)
          pattern.add_entries(row, of_cell.begin(), of_cell.end(), true);
      }
    row_start.assign(1, 0);
    column.clear();
    for (unsigned int i = 0; i < nodes.size(); ++i)
    {
      for (auto entry = pattern.begin(i); entry != pattern.end(i); ++entry)
        if (entry->column() >= i)
          column.push_back(entry->column());
      row_start.push_back(column.size());
    }
    value.resize(column.size());
    factors.clear();
  }

  template <int dim>
  typename WallMatrix<dim>::Block *WallMatrix<dim>::find(const unsigned int row,
                                                         const unsigned int col)
  {
    const auto begin = column.begin() + row_start[row], end = column.begin() + row_start[row + 1];
    const auto found = std::lower_bound(begin, end, col);
    return found != end && *found == col ? value.data() + (found - column.begin()) : nullptr;
  }

  template <int dim>
  void WallMatrix<dim>::add_cell(const CellLane &cell, const Lanes *matrix)
  {
    const unsigned int n_cell_nodes = power(spaces.degree() + 1, dim), n = dim * n_cell_nodes;
    std::vector<Masters> masters(n_cell_nodes);
    for (unsigned int i = 0; i < n_cell_nodes; ++i)
      spaces.velocity_hanging().masters_of(spaces.velocity_nodes(cell.batch)[i][cell.lane],
                                           masters[i]);
    for (unsigned int i = 0; i < n_cell_nodes; ++i)
      for (unsigned int j = 0; j < n_cell_nodes; ++j)
      {
        Block block;
        for (int c = 0; c < dim; ++c)
          for (int d = 0; d < dim; ++d)
            block[c][d] = matrix[(i * dim + c) * n + j * dim + d][cell.lane];
        for (const auto &row : masters[i])
          for (const auto &col : masters[j])
            if (number[row.node] >= 0 && number[col.node] >= number[row.node])
              *find(number[row.node], number[col.node]) += row.weight * col.weight * block;
      }
  }

  template <int dim>
  void WallMatrix<dim>::assemble(const WallForms<dim> &forms)
  {
    std::fill(value.begin(), value.end(), Block());
    const unsigned int n = dim * power(spaces.degree() + 1, dim);
    dealii::AlignedVector<Lanes> cells(n * n);
    for (unsigned int batch = spaces.n_batches(); batch < spaces.end_of_wall(); ++batch)
    {
      forms.tangent_matrix(batch, cells.data());
      for (unsigned int lane = 0; lane < spaces.n_filled_lanes(batch); ++lane)
        add_cell({batch, lane}, cells.data());
    }
  }

  template <int dim>
  void WallMatrix<dim>::add(const unsigned int row, const unsigned int col, const double entry)
  {
    if (number[row] < 0 || number[col] < number[row])
      return;
    if (Block *block = find(number[row], number[col]))
      for (int c = 0; c < dim; ++c)
        (*block)[c][c] += entry;
  }

  template <int dim>
  void WallMatrix<dim>::add_lumen_of_others(const unsigned int batch, const Lanes *matrix)
  {
    const unsigned int n = power(spaces.degree() + 1, dim),
                       n_owned = spaces.nodes()->locally_owned_size();
    const auto *cell_nodes = spaces.velocity_nodes(batch);
    std::vector<Masters> masters(n);
    for (unsigned int lane = 0; lane < spaces.n_filled_lanes(batch); ++lane)
    {
      bool has_others = false;
      for (unsigned int i = 0; i < n; ++i)
      {
        spaces.velocity_hanging().masters_of(cell_nodes[i][lane], masters[i]);
        for (const auto &master : masters[i])
          has_others = has_others || (master.node >= n_owned && number[master.node] >= 0);
      }
      if (!has_others)
        continue;
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          for (const auto &row : masters[i])
            for (const auto &col : masters[j])
              if (row.node >= n_owned || col.node >= n_owned)
                add(row.node, col.node, row.weight * col.weight * matrix[i * n + j][lane]);
    }
  }

  template <int dim>
  void WallMatrix<dim>::eliminate(const VelocityConstraints<dim> &constraints)
  {
    using Entry = typename VelocityConstraints<dim>::Entry;
    const Block unit = dealii::unit_symmetric_tensor<dim>();
    const auto projector = [&unit](const Entry *entry)
    {
      Block P = unit;
      if (entry)
        for (unsigned int d = 0; d < entry->n; ++d)
          P -= outer_product(entry->directions[d], entry->directions[d]);
      return P;
    };
    for (unsigned int i = 0; i < nodes.size(); ++i)
    {
      const Entry *row = constraints.of_node(nodes[i]);
      const Block left = projector(row);
      for (unsigned int k = row_start[i]; k < row_start[i + 1]; ++k)
      {
        const Entry *col = constraints.of_node(nodes[column[k]]);
        if (!row && !col)
          continue;
        const double scale = trace(value[k]) / dim;
        value[k] = left * value[k] * projector(col);
        if (column[k] == i)
          value[k] += scale * (unit - left);
      }
    }
  }

  template <int dim>
  void WallMatrix<dim>::factorise(const VelocityConstraints<dim> &constraints)
  {
    const unsigned int n_nodes = nodes.size();
    if (n_nodes == 0)
      return;
    eliminate(constraints);
    // The rows of the upper triangle are the columns of the lower one.
    typename SparseCholesky<Number>::Columns matrix;
    matrix.start.push_back(0);
    for (unsigned int i = 0; i < n_nodes; ++i)
      for (int c = 0; c < dim; ++c)
      {
        for (unsigned int k = row_start[i]; k < row_start[i + 1]; ++k)
          for (int d = column[k] == i ? c : 0; d < dim; ++d)
          {
            matrix.row.push_back(dim * column[k] + d);
            matrix.value.push_back(value[k][c][d]);
          }
        matrix.start.push_back(matrix.row.size());
      }
    factors.factorise(matrix);
  }

  template <int dim>
  void WallMatrix<dim>::solve(const Vector &b, Vector &x) const
  {
    const auto &owned = wall_nodes.owned();
    shared.zero_out_ghost_values();
    for (const unsigned int node : owned)
      for (int c = 0; c < dim; ++c)
        shared.local_element(dim * node + c) = b.local_element(dim * node + c);
    shared.update_ghost_values();
    if (owned.empty())
      return;
    for (unsigned int i = 0; i < nodes.size(); ++i)
      for (int c = 0; c < dim; ++c)
        work[dim * i + c] = shared.local_element(place[i] + c);
    factors.solve(work.data(), work.data());
    for (unsigned int i = 0; i < owned.size(); ++i)
      for (int c = 0; c < dim; ++c)
        x.local_element(dim * owned[i] + c) = work[dim * i + c];
  }

  template class WallMatrix<2>;
  template class WallMatrix<3>;
} // namespace semilunar::flow
