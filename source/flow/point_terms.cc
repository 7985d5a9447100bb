// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/flow/point_terms.h>
#include <semilunar/flow/tensor_kernel.h>

#include <deal.II/base/tensor_product_polynomials.h>

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
    const dealii::TensorProductPolynomials<dim> shapes(
        dealii::Polynomials::generate_complete_Lagrange_basis(nodes_1d(spaces.degree())));
    terms = new_terms;
    shape.resize(terms.size() * n_nodes);
    node.resize(shape.size());
    cell.resize(terms.size());
    for (unsigned int t = 0; t < terms.size(); ++t)
    {
      cell[t] = spaces.lane_of(terms[t].active_cell_index);
      const auto *nodes = spaces.velocity_nodes(cell[t].batch);
      for (unsigned int i = 0; i < n_nodes; ++i)
      {
        shape[t * n_nodes + i] = shapes.compute_value(i, terms[t].unit_point);
        node[t * n_nodes + i] = nodes[i][cell[t].lane];
      }
    }
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
    const auto values = velocities(velocity);
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

  template class PointTerms<2>;
  template class PointTerms<3>;
} // namespace semilunar::flow
