// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_flow_hanging_nodes_h
#define semilunar_flow_hanging_nodes_h

#include <deal.II/base/partitioner.h>
#include <deal.II/lac/affine_constraints.h>

#include <vector>

namespace semilunar::flow
{
  /// The hanging nodes that a rank sees, with the nodes that determine them, for vectors with any
  /// number of interleaved components. Indices are those of the entries that a rank stores: its
  /// own, then copies of others (ghosts).
  class HangingNodes
  {
  public:
    void reinit(const dealii::AffineConstraints<double> &constraints,
                const dealii::Utilities::MPI::Partitioner &nodes);

    bool empty() const { return node.empty(); }

    /// Interpolate the values of hanging nodes from current values of the others, ghosts included.
    template <int n_components>
    void expand(double *values) const;
    /// The transpose: what was summed up at hanging nodes goes to the others (before the sums of
    /// ghosts are sent to their owners).
    template <int n_components>
    void fold(double *values) const;

    /// One node and its weight.
    struct Master
    {
      unsigned int node;
      double weight;
    };
    /// The nodes that determine a node: itself if it does not hang.
    void masters_of(unsigned int node, std::vector<Master> &result) const;

    bool hangs(const unsigned int i) const { return i < position.size() && position[i] >= 0; }

  private:
    std::vector<unsigned int> node;
    std::vector<unsigned int> first_master; ///< n + 1 entries
    std::vector<Master> masters;
    std::vector<int> position; ///< of a node in the list above, or -1; empty if none hangs
  };

  template <int n_components>
  void HangingNodes::expand(double *values) const
  {
    for (unsigned int h = 0; h < node.size(); ++h)
    {
      double sum[n_components] = {};
      for (unsigned int m = first_master[h]; m < first_master[h + 1]; ++m)
        for (int c = 0; c < n_components; ++c)
          sum[c] += masters[m].weight * values[n_components * masters[m].node + c];
      for (int c = 0; c < n_components; ++c)
        values[n_components * node[h] + c] = sum[c];
    }
  }

  template <int n_components>
  void HangingNodes::fold(double *values) const
  {
    for (unsigned int h = 0; h < node.size(); ++h)
    {
      double *hanging = values + n_components * node[h];
      for (unsigned int m = first_master[h]; m < first_master[h + 1]; ++m)
        for (int c = 0; c < n_components; ++c)
          values[n_components * masters[m].node + c] += masters[m].weight * hanging[c];
      for (int c = 0; c < n_components; ++c)
        hanging[c] = 0.;
    }
  }
} // namespace semilunar::flow

#endif
