// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/flow/hanging_nodes.h>

namespace semilunar::flow
{
  void HangingNodes::reinit(const dealii::AffineConstraints<double> &constraints,
                            const dealii::Utilities::MPI::Partitioner &nodes)
  {
    node.clear();
    masters.clear();
    position.clear();
    first_master.assign(1, 0);
    const auto is_stored = [&](const dealii::types::global_dof_index i)
    { return nodes.in_local_range(i) || nodes.is_ghost_entry(i); };
    for (const auto &line : constraints.get_lines())
    {
      // Nodes at the far side of ghost cells may depend on cells that this rank does not see; no
      // cell of its own needs them.
      bool known = is_stored(line.index);
      for (const auto &entry : line.entries)
        known = known && is_stored(entry.first);
      if (!known)
        continue;
      node.push_back(nodes.global_to_local(line.index));
      for (const auto &entry : line.entries)
        masters.push_back({nodes.global_to_local(entry.first), entry.second});
      first_master.push_back(masters.size());
    }
    if (node.empty())
      return;
    position.assign(nodes.locally_owned_size() + nodes.n_ghost_indices(), -1);
    for (unsigned int h = 0; h < node.size(); ++h)
      position[node[h]] = h;
  }

  void HangingNodes::masters_of(const unsigned int i, std::vector<Master> &result) const
  {
    result.clear();
    if (!hangs(i))
      result.push_back({i, 1.});
    else
      result.assign(masters.begin() + first_master[position[i]],
                    masters.begin() + first_master[position[i] + 1]);
  }
} // namespace semilunar::flow
