// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_flow_velocity_constraints_h
#define semilunar_flow_velocity_constraints_h

#include <semilunar/flow/boundary_faces.h>

namespace semilunar::flow
{
  /// The directions in which velocities of nodes are given, in frames of their own: all at walls
  /// and given velocities, the normals at slip boundaries.
  template <int dim>
  class VelocityConstraints
  {
  public:
    struct Entry
    {
      unsigned int node;                                  ///< stored index
      unsigned int n;                                     ///< constrained directions, 1 to dim
      std::array<dealii::Tensor<1, dim>, dim> directions; ///< orthonormal
      std::array<double, dim> values;                     ///< along them [cm/s]
      dealii::types::boundary_id id; ///< the part that gives the values, unless normals of several;
                                     ///< invalid: the node is held
    };

    /// Find the nodes. @param faces with up-to-date normals
    void reinit(const Spaces<dim> &spaces, const BoundaryFaces<dim> &faces,
                const BoundaryConditions<dim> &conditions);

    /// Nodes that stand still, whatever is given there. After reinit().
    void hold(const std::vector<unsigned int> &nodes)
    {
      fix(nodes, dealii::numbers::invalid_boundary_id);
    }

    /// Values at a time. @param mesh_velocity nullptr: at rest
    void set_values(const BoundaryConditions<dim> &conditions, const Vector &positions,
                    const Vector *mesh_velocity, double time);

    /// Set the given components of owned nodes (hanging nodes are not expanded).
    void impose(Vector &velocity) const;
    /// Set the given components of owned nodes to zero, and hanging nodes.
    void mask(Vector &residual) const;

    /// Entries of all stored nodes.
    const std::vector<Entry> &all() const { return entries; }
    /// The entry of a stored node, or nullptr.
    const Entry *of_node(const unsigned int node) const
    {
      return entry_of_node[node] < 0 ? nullptr : &entries[entry_of_node[node]];
    }
    bool fixed(const unsigned int node) const
    {
      return entry_of_node[node] >= 0 && entries[entry_of_node[node]].n == dim;
    }

  private:
    void fix(const std::vector<unsigned int> &nodes, dealii::types::boundary_id id);
    void slip(const std::vector<unsigned int> &nodes, const Vector &normals,
              dealii::types::boundary_id id);
    Entry *entry(unsigned int node, dealii::types::boundary_id id);

    const Spaces<dim> *spaces = nullptr;
    std::vector<Entry> entries;
    std::vector<int> entry_of_node;
    std::vector<unsigned int> owned_hanging;
    unsigned int n_owned_nodes = 0;
  };
} // namespace semilunar::flow

#endif
