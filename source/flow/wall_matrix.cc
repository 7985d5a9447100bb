// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/flow/tensor_kernel.h>
#include <semilunar/flow/wall_matrix.h>

#include <deal.II/base/aligned_vector.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/vector.h>

#include <algorithm>

namespace semilunar::flow
{
  using Masters = std::vector<HangingNodes::Master>;

  template <int dim>
  void WallMatrix<dim>::reinit()
  {
    const auto &owned = wall_nodes.owned();
    number.assign(spaces.nodes()->locally_owned_size() + spaces.nodes()->n_ghost_indices(), -1);
    for (unsigned int i = 0; i < owned.size(); ++i)
      number[owned[i]] = i;
    const unsigned int n_cell_nodes = power(spaces.degree() + 1, dim);
    dealii::DynamicSparsityPattern nodal(owned.size(), owned.size());
    Masters masters;
    std::vector<dealii::types::global_dof_index> nodes;
    for (unsigned int batch = spaces.n_batches(); batch < spaces.end_of_wall(); ++batch)
      for (unsigned int lane = 0; lane < spaces.n_filled_lanes(batch); ++lane)
      {
        nodes.clear();
        for (unsigned int i = 0; i < n_cell_nodes; ++i)
        {
          spaces.velocity_hanging().masters_of(spaces.velocity_nodes(batch)[i][lane], masters);
          for (const auto &master : masters)
            if (number[master.node] >= 0)
              nodes.push_back(number[master.node]);
        }
        std::sort(nodes.begin(), nodes.end());
        nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
        for (const auto row : nodes)
          nodal.add_entries(row, nodes.begin(), nodes.end(), true);
      }
    row_start.assign(1, 0);
    column.clear();
    dealii::DynamicSparsityPattern all(dim * owned.size(), dim * owned.size());
    for (unsigned int i = 0; i < owned.size(); ++i)
    {
      for (auto entry = nodal.begin(i); entry != nodal.end(i); ++entry)
      {
        column.push_back(entry->column());
        for (int c = 0; c < dim; ++c)
          for (int d = 0; d < dim; ++d)
            all.add(dim * i + c, dim * entry->column() + d);
      }
      row_start.push_back(column.size());
    }
    value.resize(column.size());
    matrix.clear();
    pattern.copy_from(all);
    matrix.reinit(pattern);
    source.clear();
    for (const auto &entry : pattern)
      source.push_back((find(entry.row() / dim, entry.column() / dim) - value.data()) * dim * dim +
                       entry.row() % dim * dim + entry.column() % dim);
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
  void WallMatrix<dim>::assemble(const WallForms<dim> &forms)
  {
    const unsigned int n_cell_nodes = power(spaces.degree() + 1, dim), n = dim * n_cell_nodes;
    std::fill(value.begin(), value.end(), Block());
    dealii::AlignedVector<Lanes> cell(n * n);
    Masters rows, columns;
    for (unsigned int batch = spaces.n_batches(); batch < spaces.end_of_wall(); ++batch)
    {
      forms.tangent_matrix(batch, cell.data());
      const auto *nodes = spaces.velocity_nodes(batch);
      for (unsigned int lane = 0; lane < spaces.n_filled_lanes(batch); ++lane)
        for (unsigned int i = 0; i < n_cell_nodes; ++i)
        {
          spaces.velocity_hanging().masters_of(nodes[i][lane], rows);
          for (unsigned int j = 0; j < n_cell_nodes; ++j)
          {
            spaces.velocity_hanging().masters_of(nodes[j][lane], columns);
            Block block;
            for (int c = 0; c < dim; ++c)
              for (int d = 0; d < dim; ++d)
                block[c][d] = cell[(i * dim + c) * n + j * dim + d][lane];
            for (const auto &row : rows)
              for (const auto &col : columns)
                if (number[row.node] >= 0 && number[col.node] >= 0)
                  *find(number[row.node], number[col.node]) += row.weight * col.weight * block;
          }
        }
    }
  }

  template <int dim>
  void WallMatrix<dim>::add(const unsigned int row, const unsigned int col, const double entry)
  {
    if (Block *block = find(number[row], number[col]))
      for (int c = 0; c < dim; ++c)
        (*block)[c][c] += entry;
  }

  template <int dim>
  void WallMatrix<dim>::eliminate(const VelocityConstraints<dim> &constraints)
  {
    using Entry = typename VelocityConstraints<dim>::Entry;
    const auto projector = [](const Entry *entry)
    {
      Block P = dealii::unit_symmetric_tensor<dim>();
      if (entry)
        for (unsigned int d = 0; d < entry->n; ++d)
          P -= outer_product(entry->directions[d], entry->directions[d]);
      return P;
    };
    const auto &owned = wall_nodes.owned();
    for (unsigned int i = 0; i < owned.size(); ++i)
    {
      const Entry *row = constraints.of_node(owned[i]);
      const Block left = projector(row);
      for (unsigned int k = row_start[i]; k < row_start[i + 1]; ++k)
      {
        const Entry *col = constraints.of_node(owned[column[k]]);
        if (!row && !col)
          continue;
        const double scale = trace(value[k]) / dim;
        const Block right = projector(col);
        value[k] = left * value[k] * right;
        if (column[k] == i)
          value[k] += scale * (Block(dealii::unit_symmetric_tensor<dim>()) - left);
      }
    }
  }

  template <int dim>
  void WallMatrix<dim>::factorise(const VelocityConstraints<dim> &constraints)
  {
    if (wall_nodes.owned().empty())
      return;
    eliminate(constraints);
    std::size_t k = 0;
    for (auto entry = matrix.begin(); entry != matrix.end(); ++entry, ++k)
    {
      const std::size_t within = source[k] % (dim * dim);
      entry->value() = value[source[k] / (dim * dim)][within / dim][within % dim];
    }
    try
    {
      factors.factorize(matrix);
    }
    catch (const dealii::ExceptionBase &)
    {
      throw NumericsError("the matrix of the wall is singular", "", "");
    }
  }

  template <int dim>
  void WallMatrix<dim>::solve(const Vector &b, Vector &x) const
  {
    const auto &owned = wall_nodes.owned();
    if (owned.empty())
      return;
    dealii::Vector<double> work(dim * owned.size());
    for (unsigned int i = 0; i < owned.size(); ++i)
      for (int c = 0; c < dim; ++c)
        work[dim * i + c] = b.local_element(dim * owned[i] + c);
    factors.solve(work);
    for (unsigned int i = 0; i < owned.size(); ++i)
      for (int c = 0; c < dim; ++c)
        x.local_element(dim * owned[i] + c) = work[dim * i + c];
  }

  template class WallMatrix<2>;
  template class WallMatrix<3>;
} // namespace semilunar::flow
