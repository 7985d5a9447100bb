// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/flow/mesh_interpolation.h>
#include <semilunar/flow/tensor_kernel.h>

namespace semilunar::flow
{
  using Entries = std::vector<SparseMap::Entry>;

  template <int dim>
  MeshInterpolation<dim>::MeshInterpolation(const Spaces<dim> &spaces, const WallNodes<dim> &nodes)
      : spaces(spaces), wall_nodes(nodes), n(spaces.degree() + 1), n_nodes(power(n, dim))
  {
    const auto points = nodes_1d(spaces.degree());
    for (unsigned int i = 0; i < n_nodes; ++i)
      for (unsigned int v = 0; v < n_vertices; ++v)
      {
        double weight = 1.;
        for (int d = 0; d < dim; ++d)
        {
          const double x = points[i / power(n, d) % n][0];
          weight *= (v >> d & 1) != 0 ? x : 1. - x;
        }
        vertex_weight.push_back(weight);
      }
  }

  template <int dim>
  unsigned int MeshInterpolation<dim>::node_at(const unsigned int vertex) const
  {
    unsigned int node = 0;
    for (int d = 0; d < dim; ++d)
      node += (vertex >> d & 1) * (n - 1) * power(n, d);
    return node;
  }

  template <int dim>
  std::vector<unsigned int> MeshInterpolation<dim>::faces_at_wall(const CellLane &cell) const
  {
    std::vector<unsigned int> faces;
    for (unsigned int face = 0; face < 2 * dim; ++face)
    {
      const unsigned int stride = power(n, face / 2), end = face % 2 * (n - 1);
      bool at_wall = true;
      for (unsigned int i = 0; i < n_nodes && at_wall; ++i)
        at_wall = i / stride % n != end ||
                  wall_nodes.in_wall(spaces.velocity_nodes(cell.batch)[i][cell.lane]);
      if (at_wall)
        faces.push_back(face);
    }
    return faces;
  }

  template <int dim>
  void MeshInterpolation<dim>::add_surplus(const CellLane &cell, const unsigned int on_face,
                                           const double factor, Entries &entries) const
  {
    const auto node = [&](const unsigned int i)
    { return spaces.velocity_nodes(cell.batch)[i][cell.lane]; };
    entries.push_back({node(on_face), factor});
    for (unsigned int v = 0; v < n_vertices; ++v)
      if (const double weight = vertex_weight[on_face * n_vertices + v]; weight != 0.)
        entries.push_back({node(node_at(v)), -factor * weight});
  }

  template <int dim>
  void MeshInterpolation<dim>::reinit(
      const std::function<unsigned int(const CellLane &, unsigned int)> &vertex_of)
  {
    const unsigned int n_owned = spaces.nodes()->locally_owned_size();
    const auto points = nodes_1d(spaces.degree());
    std::vector<Entries> vertices(n_owned), interface(n_owned);
    std::vector<unsigned int> n_faces(n_owned, 0); // that are continued to a node
    for (unsigned int batch = 0; batch < spaces.n_batches(); ++batch)
      for (unsigned int lane = 0; lane < spaces.n_filled_lanes(batch); ++lane)
      {
        const CellLane cell{batch, lane};
        const auto faces = faces_at_wall(cell);
        for (unsigned int i = 0; i < n_nodes; ++i)
        {
          const unsigned int node = spaces.velocity_nodes(batch)[i][lane];
          if (node >= n_owned || wall_nodes.in_wall(node))
            continue;
          if (vertices[node].empty()) // all cells at a node agree
            for (unsigned int v = 0; v < n_vertices; ++v)
              if (const double weight = vertex_weight[i * n_vertices + v]; weight != 0.)
                vertices[node].push_back({vertex_of(cell, v), weight});
          for (const unsigned int face : faces)
          {
            const unsigned int stride = power(n, face / 2), along = i / stride % n;
            const double x = points[along][0];
            const unsigned int on_face = i + (face % 2 * (n - 1) - along) * stride;
            add_surplus(cell, on_face, face % 2 == 0 ? 1. - x : x, interface[node]);
            ++n_faces[node];
          }
        }
      }
    from_vertices.clear();
    from_interface.clear();
    for (unsigned int node = 0; node < n_owned; ++node)
    {
      if (!vertices[node].empty())
        from_vertices.add_row(node, vertices[node]);
      for (auto &entry : interface[node]) // the mean of all faces
        entry.weight /= n_faces[node];
      if (!interface[node].empty())
        from_interface.add_row(node, interface[node]);
    }
  }

  template class MeshInterpolation<2>;
  template class MeshInterpolation<3>;
} // namespace semilunar::flow
