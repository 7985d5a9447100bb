// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/flow/velocity_constraints.h>

namespace semilunar::flow
{
  using dealii::Tensor;

  namespace
  {
    template <int dim>
    Tensor<1, dim> vector_at(const Vector &vector, const unsigned int node)
    {
      Tensor<1, dim> value;
      for (unsigned int c = 0; c < dim; ++c)
        value[c] = vector.local_element(dim * node + c);
      return value;
    }
  } // namespace

  template <int dim>
  typename VelocityConstraints<dim>::Entry *
  VelocityConstraints<dim>::entry(const unsigned int node, const dealii::types::boundary_id id)
  {
    if (spaces->velocity_hanging().hangs(node))
      return nullptr; // its masters are constrained
    if (entry_of_node[node] < 0)
    {
      entry_of_node[node] = entries.size();
      entries.push_back({node, 0, {}, {}, id});
    }
    return &entries[entry_of_node[node]];
  }

  template <int dim>
  void VelocityConstraints<dim>::fix(const std::vector<unsigned int> &nodes,
                                     const dealii::types::boundary_id id)
  {
    for (const unsigned int node : nodes)
      if (Entry *e = entry(node, id); e && e->n < dim)
      {
        e->n = dim;
        e->id = id;
        for (unsigned int c = 0; c < dim; ++c)
          e->directions[c] = dealii::Point<dim>::unit_vector(c);
      }
  }

  template <int dim>
  void VelocityConstraints<dim>::slip(const std::vector<unsigned int> &nodes, const Vector &normals,
                                      const dealii::types::boundary_id id)
  {
    // Normals of parts that meet at a smaller angle (5 degrees) count as one.
    constexpr double same_direction = 0.087;
    for (const unsigned int node : nodes)
      if (Entry *e = entry(node, id); e && e->n < dim)
      {
        Tensor<1, dim> n = vector_at<dim>(normals, node);
        n /= n.norm();
        for (unsigned int d = 0; d < e->n; ++d)
          n -= (n * e->directions[d]) * e->directions[d];
        if (n.norm() > same_direction)
          e->directions[e->n++] = n / n.norm();
      }
  }

  template <int dim>
  void VelocityConstraints<dim>::reinit(const Spaces<dim> &s, const BoundaryFaces<dim> &faces,
                                        const BoundaryConditions<dim> &conditions)
  {
    spaces = &s;
    entries.clear();
    n_owned_nodes = spaces->nodes()->locally_owned_size();
    const unsigned int n_stored = n_owned_nodes + spaces->nodes()->n_ghost_indices();
    entry_of_node.assign(n_stored, -1);
    using Kind = typename BoundaryConditions<dim>::Kind;
    for (const Kind kind : {Kind::wall, Kind::velocity})
      for (const auto &[id, part] : faces.parts())
        if (conditions.all().at(id).kind == kind)
          fix(part.nodes, id);
    for (const auto &[id, part] : faces.parts())
      if (conditions.all().at(id).kind == Kind::slip)
        slip(part.nodes, part.normals, id);

    owned_hanging.clear();
    for (unsigned int node = 0; node < n_owned_nodes; ++node)
      if (spaces->velocity_hanging().hangs(node))
        owned_hanging.push_back(node);
  }

  template <int dim>
  void VelocityConstraints<dim>::set_values(const BoundaryConditions<dim> &conditions,
                                            const Vector &positions, const Vector *mesh_velocity,
                                            const double time)
  {
    using Kind = typename BoundaryConditions<dim>::Kind;
    for (Entry &e : entries)
    {
      if (e.node >= n_owned_nodes)
        continue;
      Tensor<1, dim> velocity;
      const auto condition = conditions.all().find(e.id);
      if (condition != conditions.all().end() && condition->second.kind == Kind::velocity)
        velocity =
            condition->second.velocity(dealii::Point<dim>(vector_at<dim>(positions, e.node)), time);
      else if (mesh_velocity && condition != conditions.all().end())
        velocity = vector_at<dim>(*mesh_velocity, e.node);
      for (unsigned int d = 0; d < e.n; ++d)
        e.values[d] = velocity * e.directions[d];
    }
  }

  template <int dim>
  void VelocityConstraints<dim>::impose(Vector &velocity) const
  {
    for (const Entry &e : entries)
      if (e.node < n_owned_nodes)
      {
        const Tensor<1, dim> old = vector_at<dim>(velocity, e.node);
        Tensor<1, dim> updated = old;
        for (unsigned int d = 0; d < e.n; ++d)
          updated += (e.values[d] - old * e.directions[d]) * e.directions[d];
        for (unsigned int c = 0; c < dim; ++c)
          velocity.local_element(dim * e.node + c) = updated[c];
      }
  }

  template <int dim>
  void VelocityConstraints<dim>::mask(Vector &residual) const
  {
    for (const Entry &e : entries)
      if (e.node < n_owned_nodes)
      {
        Tensor<1, dim> value;
        if (e.n < dim)
        {
          value = vector_at<dim>(residual, e.node);
          for (unsigned int d = 0; d < e.n; ++d)
            value -= (value * e.directions[d]) * e.directions[d];
        }
        for (unsigned int c = 0; c < dim; ++c)
          residual.local_element(dim * e.node + c) = value[c];
      }
    for (const unsigned int node : owned_hanging)
      for (unsigned int c = 0; c < dim; ++c)
        residual.local_element(dim * node + c) = 0.;
  }

  template class VelocityConstraints<2>;
  template class VelocityConstraints<3>;
} // namespace semilunar::flow
