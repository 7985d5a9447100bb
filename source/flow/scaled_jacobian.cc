// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/flow/lane_matrices.h>
#include <semilunar/flow/scaled_jacobian.h>
#include <semilunar/flow/tensor_kernel.h>

#include <deal.II/base/aligned_vector.h>

#include <algorithm>
#include <limits>

namespace semilunar::flow
{
  namespace
  {
    /// Derivatives of the shape functions in one direction at the nodes, [node][shape function].
    std::vector<double> derivatives_at_nodes(const unsigned int degree)
    {
      const auto nodes = nodes_1d(degree);
      const auto basis = dealii::Polynomials::generate_complete_Lagrange_basis(nodes);
      std::vector<double> result, both(2);
      for (const auto &node : nodes)
        for (const auto &polynomial : basis)
        {
          polynomial.value(node[0], both);
          result.push_back(both[1]);
        }
      return result;
    }

    template <int dim>
    Lanes scaled_determinant(const Lanes (&columns)[dim][dim])
    {
      Lanes inverse[dim][dim], squared_lengths = Lanes{} + 1.;
      for (int d = 0; d < dim; ++d)
      {
        Lanes squared = columns[d][0] * columns[d][0];
        for (int c = 1; c < dim; ++c)
          squared += columns[d][c] * columns[d][c];
        squared_lengths *= squared;
      }
      return invert(columns, inverse) / square_root(squared_lengths);
    }
  } // namespace

  template <int dim>
  double min_scaled_jacobian(const Spaces<dim> &spaces, const Vector &positions)
  {
    const unsigned int n = spaces.degree() + 1, n_nodes = power(n, dim);
    const std::vector<double> derivative = derivatives_at_nodes(spaces.degree());
    dealii::AlignedVector<Lanes> x(n_nodes * dim);
    Lanes smallest = Lanes{} + std::numeric_limits<double>::max();
    for (unsigned int batch = 0; batch < spaces.n_owned_batches(); ++batch)
    {
      for (unsigned int i = 0; i < n_nodes; ++i)
        for (int c = 0; c < dim; ++c)
          for (unsigned int lane = 0; lane < n_lanes; ++lane)
            x[dim * i + c][lane] =
                positions.local_element(dim * spaces.velocity_nodes(batch)[i][lane] + c);
      for (unsigned int q = 0; q < n_nodes; ++q)
      {
        Lanes columns[dim][dim] = {};
        for (int d = 0; d < dim; ++d)
        {
          const unsigned int stride = power(n, d), at = q / stride % n;
          for (unsigned int i = 0; i < n; ++i)
            for (int c = 0; c < dim; ++c)
              columns[d][c] += derivative[at * n + i] * x[dim * (q + i * stride - at * stride) + c];
        }
        const Lanes value = scaled_determinant<dim>(columns);
        for (unsigned int lane = 0; lane < n_lanes; ++lane)
          smallest[lane] = std::min(smallest[lane], value[lane]);
      }
    }
    double of_rank = smallest[0];
    for (unsigned int lane = 1; lane < n_lanes; ++lane)
      of_rank = std::min(of_rank, smallest[lane]);
    return dealii::Utilities::MPI::min(of_rank, spaces.communicator());
  }

  template double min_scaled_jacobian<2>(const Spaces<2> &, const Vector &);
  template double min_scaled_jacobian<3>(const Spaces<3> &, const Vector &);
} // namespace semilunar::flow
