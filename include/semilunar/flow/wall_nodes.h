// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_flow_wall_nodes_h
#define semilunar_flow_wall_nodes_h

#include <semilunar/flow/spaces.h>

namespace semilunar::flow
{
  /// Which velocity nodes belong to wall cells and which to the interface with the lumen.
  template <int dim>
  class WallNodes
  {
  public:
    explicit WallNodes(const Spaces<dim> &spaces) : spaces(spaces) {}

    /// After construction and when the mesh was refined. Collective.
    void reinit();

    /// Of a stored node: it belongs to a wall cell; to a cell of the lumen as well.
    bool in_wall(const unsigned int node) const { return wall[node]; }
    bool at_interface(const unsigned int node) const { return wall[node] && lumen[node]; }
    /// Owned nodes of the wall that do not hang, by their stored index.
    const std::vector<unsigned int> &owned() const { return owned_nodes; }
    /// Owned pressures that no cell of the lumen has, which mean nothing.
    const std::vector<unsigned int> &idle_pressures() const { return idle; }

  private:
    std::vector<bool> touched(unsigned int begin, unsigned int end) const;

    const Spaces<dim> &spaces;
    std::vector<bool> wall, lumen; ///< of stored nodes
    std::vector<unsigned int> owned_nodes, idle;
  };
} // namespace semilunar::flow

#endif
