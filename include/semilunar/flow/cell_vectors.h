// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_flow_cell_vectors_h
#define semilunar_flow_cell_vectors_h

#include <semilunar/flow/lanes.h>

#include <array>

namespace semilunar::flow
{
  /// Values [component][node] of the cells of a batch from a vector with interleaved components.
  /// @param nodes stored node of each lane
  template <int n_components, int n_nodes>
  inline void read_nodes(const std::array<unsigned int, n_lanes> *nodes, const double *vector,
                         Lanes (&values)[n_components][n_nodes])
  {
    for (int i = 0; i < n_nodes; ++i)
      for (int c = 0; c < n_components; ++c)
        for (unsigned int lane = 0; lane < n_lanes; ++lane)
          values[c][i][lane] = vector[n_components * nodes[i][lane] + c];
  }

  /// Add such values to a vector, those of the first n_filled lanes.
  template <int n_components, int n_nodes>
  inline void add_to_nodes(const std::array<unsigned int, n_lanes> *nodes,
                           const unsigned int n_filled,
                           const Lanes (&values)[n_components][n_nodes], double *vector)
  {
    for (unsigned int lane = 0; lane < n_filled; ++lane)
      for (int i = 0; i < n_nodes; ++i)
        for (int c = 0; c < n_components; ++c)
          vector[n_components * nodes[i][lane] + c] += values[c][i][lane];
  }
} // namespace semilunar::flow

#endif
