// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_flow_sparse_map_h
#define semilunar_flow_sparse_map_h

#include <vector>

namespace semilunar::flow
{
  /// Some entries of a vector as weighted sums of entries of a vector, by their stored indices
  /// (ghosts included), the same for all of several interleaved components.
  class SparseMap
  {
  public:
    struct Entry
    {
      unsigned int index;
      double weight;
    };

    void clear()
    {
      rows.clear();
      row_start.assign(1, 0);
      entries.clear();
    }

    void add_row(const unsigned int row, const std::vector<Entry> &of_row)
    {
      rows.push_back(row);
      entries.insert(entries.end(), of_row.begin(), of_row.end());
      row_start.push_back(entries.size());
    }

    /// to[row] += sum of weight * from[index] for all rows.
    template <int n_components>
    void add(const double *from, double *to) const
    {
      for (unsigned int i = 0; i < rows.size(); ++i)
        for (unsigned int k = row_start[i]; k < row_start[i + 1]; ++k)
          for (int c = 0; c < n_components; ++c)
            to[n_components * rows[i] + c] +=
                entries[k].weight * from[n_components * entries[k].index + c];
    }

    /// The same as to[row] = sum; rows must not be among the indices if both are one vector.
    template <int n_components>
    void set(const double *from, double *to) const
    {
      for (const unsigned int row : rows)
        for (int c = 0; c < n_components; ++c)
          to[n_components * row + c] = 0.;
      add<n_components>(from, to);
    }

  private:
    std::vector<unsigned int> rows, row_start = {0};
    std::vector<Entry> entries;
  };
} // namespace semilunar::flow

#endif
