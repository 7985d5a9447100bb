// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_flow_mesh_interpolation_h
#define semilunar_flow_mesh_interpolation_h

#include <semilunar/flow/sparse_map.h>
#include <semilunar/flow/wall_nodes.h>

#include <functional>

namespace semilunar::flow
{
  /// Displacements of the nodes of the lumen from those of its vertices, by linear interpolation in
  /// cells, and from those of the interface: what it does beyond its vertices decreases linearly to
  /// the opposite faces of its cells.
  template <int dim>
  class MeshInterpolation
  {
  public:
    MeshInterpolation(const Spaces<dim> &spaces, const WallNodes<dim> &nodes);

    /// After construction and when the mesh was refined.
    /// @param vertex_of number of a vertex of a cell in vectors of vertices
    void reinit(const std::function<unsigned int(const CellLane &, unsigned int)> &vertex_of);

    /// Set the entries of nodes of the lumen that a rank owns and that are not of the interface.
    /// @param of_vertices displacements, ghosts included
    /// @param displacement of nodes; those of the interface readable
    void apply(const Vector &of_vertices, Vector &displacement) const
    {
      from_vertices.template set<dim>(of_vertices.begin(), displacement.begin());
      from_interface.template add<dim>(displacement.begin(), displacement.begin());
    }

    /// Lexicographic number in a cell of the node at a vertex.
    unsigned int node_at(unsigned int vertex) const;

  private:
    static constexpr unsigned int n_vertices = 1 << dim;

    std::vector<unsigned int> faces_at_wall(const CellLane &cell) const;
    /// What the node on a face of the interface does beyond its vertices, times a factor.
    void add_surplus(const CellLane &cell, unsigned int on_face, double factor,
                     std::vector<SparseMap::Entry> &entries) const;

    const Spaces<dim> &spaces;
    const WallNodes<dim> &wall_nodes;
    const unsigned int n, n_nodes;     ///< in one direction of a cell, in all
    std::vector<double> vertex_weight; ///< [lexicographic node][vertex]
    SparseMap from_vertices, from_interface;
  };
} // namespace semilunar::flow

#endif
