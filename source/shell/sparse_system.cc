// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/shell/sparse_system.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <algorithm>

namespace semilunar::shell
{
  SparseSystem::SparseSystem(const spline::Surface &surface, const Equations &equations)
      : surface(surface), equations(equations)
  {
    make_sparsity();
  }

  void SparseSystem::couple(const std::vector<std::pair<unsigned int, unsigned int>> &element_pairs)
  {
    bool is_new = false;
    for (const auto &[e, f] : element_pairs)
      is_new = coupled.insert({std::min(e, f), std::max(e, f)}).second || is_new;
    if (is_new)
      make_sparsity();
  }

  void SparseSystem::forget()
  {
    if (coupled.empty())
      factors.analyse(sparsity);
    else
    {
      coupled.clear();
      make_sparsity();
    }
  }

  std::vector<dealii::types::global_dof_index>
  SparseSystem::free_equations(const std::vector<unsigned int> &control_points) const
  {
    std::vector<dealii::types::global_dof_index> free;
    for (const unsigned int c : control_points)
      for (unsigned int i = 0; i < 3; ++i)
        if (equations(c, i) != Equations::none)
          free.push_back(equations(c, i));
    std::sort(free.begin(), free.end());
    free.erase(std::unique(free.begin(), free.end()), free.end());
    return free;
  }

  void SparseSystem::make_sparsity()
  {
    dealii::DynamicSparsityPattern pattern(equations.n_equations());
    std::vector<std::vector<dealii::types::global_dof_index>> of_element;
    for (const auto &element : surface.elements)
    {
      of_element.push_back(free_equations(element.control_points));
      for (const auto i : of_element.back())
        pattern.add_entries(i, of_element.back().begin(), of_element.back().end(), true);
    }
    for (const auto &[e, f] : coupled)
    {
      for (const auto i : of_element[e])
        pattern.add_entries(i, of_element[f].begin(), of_element[f].end(), true);
      for (const auto i : of_element[f])
        pattern.add_entries(i, of_element[e].begin(), of_element[e].end(), true);
    }
    matrix.clear();
    sparsity.copy_from(pattern);
    matrix.reinit(sparsity);
    factors.analyse(sparsity);
  }

  void SparseSystem::add(const std::vector<unsigned int> &control_points, const double *block)
  {
    const unsigned int n = 3 * control_points.size();
    entries.clear();
    for (unsigned int k = 0; k < n; ++k)
    {
      const unsigned int equation = equations(control_points[k / 3], k % 3);
      if (equation != Equations::none)
        entries.push_back({equation, k});
    }
    std::sort(entries.begin(), entries.end());
    columns.clear();
    for (unsigned int k = 0; k < entries.size(); ++k)
      if (k == 0 || entries[k].equation != entries[k - 1].equation)
        columns.push_back(entries[k].equation);
    row.resize(columns.size());

    for (const Entry &r : entries)
    {
      const double *values = block + r.local * n;
      unsigned int position = 0;
      row[0] = values[entries[0].local];
      for (unsigned int k = 1; k < entries.size(); ++k)
        if (entries[k].equation == entries[k - 1].equation) // tied components
          row[position] += values[entries[k].local];
        else
          row[++position] = values[entries[k].local];
      matrix.add(r.equation, columns.size(), columns.data(), row.data(), false, true);
    }
  }

  void SparseSystem::add_diagonal(const dealii::Vector<double> &diagonal, const double factor)
  {
    for (unsigned int i = 0; i < diagonal.size(); ++i)
      matrix.diag_element(i) += factor * diagonal[i];
  }
} // namespace semilunar::shell
