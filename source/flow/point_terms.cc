// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/flow/point_terms.h>
#include <semilunar/flow/tensor_kernel.h>

#include <deal.II/base/polynomial.h>

namespace semilunar::flow
{
  using dealii::Tensor;

  template <int dim>
  PointTerms<dim>::PointTerms(const Spaces<dim> &spaces)
      : spaces(spaces), n_nodes(power(spaces.degree() + 1, dim))
  {
  }

  template <int dim>
  void PointTerms<dim>::set(const std::vector<PointTerm<dim>> &new_terms)
  {
    const auto shapes =
        dealii::Polynomials::generate_complete_Lagrange_basis(nodes_1d(spaces.degree()));
    const unsigned int n_1d = shapes.size();
    std::vector<std::array<double, dim>> values(n_1d);
    terms = new_terms;
    shape.resize(terms.size() * n_nodes);
    node.resize(shape.size());
    cell.resize(terms.size());
    for (unsigned int t = 0; t < terms.size(); ++t)
    {
      cell[t] = spaces.lane_of(terms[t].active_cell_index);
      const auto *nodes = spaces.velocity_nodes(cell[t].batch);
      for (unsigned int i = 0; i < n_1d; ++i)
        for (unsigned int d = 0; d < dim; ++d)
          values[i][d] = shapes[i].value(terms[t].unit_point[d]);
      for (unsigned int i = 0; i < n_nodes; ++i)
      {
        double product = 1.;
        for (unsigned int d = 0, index = i; d < dim; ++d, index /= n_1d)
          product *= values[index % n_1d][d];
        shape[t * n_nodes + i] = product;
        node[t * n_nodes + i] = nodes[i][cell[t].lane];
      }
    }
  }

  template <int dim>
  void PointTerms<dim>::set_forces(const std::vector<Tensor<1, dim>> &forces)
  {
    AssertDimension(forces.size(), terms.size());
    for (unsigned int t = 0; t < terms.size(); ++t)
      terms[t].force = forces[t];
  }

  template <int dim>
  std::vector<Tensor<1, dim>> PointTerms<dim>::velocities(const Vector &velocity) const
  {
    std::vector<Tensor<1, dim>> values(terms.size());
    for (unsigned int t = 0; t < terms.size(); ++t)
      for (unsigned int i = t * n_nodes; i < (t + 1) * n_nodes; ++i)
        for (unsigned int c = 0; c < dim; ++c)
          values[t][c] += shape[i] * velocity.local_element(dim * node[i] + c);
    return values;
  }

  template <int dim>
  void PointTerms<dim>::add(const Vector &velocity, const bool with_force, Vector &momentum) const
  {
    auto values = velocities(velocity);
    if (response)
    {
      const auto structure = response(values);
      for (unsigned int t = 0; t < terms.size(); ++t)
        values[t] -= structure[t];
    }
    for (unsigned int t = 0; t < terms.size(); ++t)
    {
      Tensor<1, dim> force = terms[t].penalty * values[t];
      if (with_force)
        force -= terms[t].force;
      for (unsigned int i = t * n_nodes; i < (t + 1) * n_nodes; ++i)
        for (unsigned int c = 0; c < dim; ++c)
          momentum.local_element(dim * node[i] + c) += shape[i] * force[c];
    }
  }

  template <int dim>
  double PointTerms<dim>::power_at_nodes(const Vector &velocity) const
  {
    Vector momentum(spaces.velocities());
    add(velocity, true, momentum);
    double sum = 0.;
    for (const unsigned int i : node)
      for (unsigned int c = 0; c < dim; ++c)
      {
        double &entry = momentum.local_element(dim * i + c);
        sum += entry * velocity.local_element(dim * i + c);
        entry = 0.; // nodes repeat
      }
    return sum;
  }

  template class PointTerms<2>;
  template class PointTerms<3>;
} // namespace semilunar::flow
