// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_flow_tensor_kernel_h
#define semilunar_flow_tensor_kernel_h

#include <semilunar/flow/lanes.h>

#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>

#include <array>

namespace semilunar::flow
{
  constexpr int power(const int base, const int exponent)
  {
    return exponent == 0 ? 1 : base * power(base, exponent - 1);
  }

  /// Apply a matrix of n_out rows and n_in columns (its transpose: of n_in rows) along one
  /// direction of a tensor whose lower directions have n_before entries in all, the higher ones
  /// n_after. May work in place if n_in = n_out.
  template <int n_before, int n_after, int n_in, int n_out, bool transpose = false,
            bool add = false>
  inline void contract(const double *matrix, const Lanes *in, Lanes *out)
  {
    for (int after = 0; after < n_after; ++after)
      for (int before = 0; before < n_before; ++before)
      {
        Lanes x[n_in];
        for (int i = 0; i < n_in; ++i)
          x[i] = in[(after * n_in + i) * n_before + before];
        for (int q = 0; q < n_out; ++q)
        {
          Lanes sum = x[0] * (transpose ? matrix[q] : matrix[q * n_in]);
          for (int i = 1; i < n_in; ++i)
            sum += x[i] * (transpose ? matrix[i * n_out + q] : matrix[q * n_in + i]);
          Lanes &target = out[(after * n_out + q) * n_before + before];
          if constexpr (add)
            target += sum;
          else
            target = sum;
        }
      }
  }

  /// Sum factorisation on the unit cell: velocity (and geometry) of degree k, pressure of degree
  /// k-1, k+1 Gauss points in each direction. All tensors are lexicographic, x fastest.
  template <int dim, int degree>
  class TensorKernel
  {
  public:
    static constexpr int n_1d = degree + 1; ///< nodes and points in each direction
    static constexpr int n_nodes = power(n_1d, dim);
    static constexpr int n_pressure_nodes = power(degree, dim);
    static constexpr int n_points = n_nodes;

    TensorKernel();

    /// Values at the points of a function of degree k from its values at the nodes, in place.
    void interpolate(Lanes *values) const
    {
      along_all_directions<false, false>(velocity_values.data(), values);
    }

    /// The transpose: from point values to a sum for each node, in place.
    void interpolate_transposed(Lanes *values) const
    {
      along_all_directions<true, false>(velocity_values.data(), values);
    }

    /// Derivative along direction d of the polynomial with these values at the points; out = d or,
    /// with add, out += d.
    template <int d, bool add = false>
    void differentiate(const Lanes *values, Lanes *out) const
    {
      contract<power(n_1d, d), power(n_1d, dim - 1 - d), n_1d, n_1d, false, add>(
          point_derivatives.data(), values, out);
    }

    /// values += transpose of the derivative along direction d, applied to fluxes.
    template <int d>
    void differentiate_transposed(const Lanes *fluxes, Lanes *values) const
    {
      contract<power(n_1d, d), power(n_1d, dim - 1 - d), n_1d, n_1d, true, true>(
          point_derivatives.data(), fluxes, values);
    }

    /// Reference gradient, [direction][point], from values at the points.
    void gradient(const Lanes *values, Lanes (*out)[n_points]) const
    {
      differentiate<0>(values, out[0]);
      differentiate<1>(values, out[1]);
      if constexpr (dim == 3)
        differentiate<2>(values, out[2]);
    }

    /// values += transposed gradient of fluxes [direction][point].
    void gradient_transposed(const Lanes (*fluxes)[n_points], Lanes *values) const
    {
      differentiate_transposed<0>(fluxes[0], values);
      differentiate_transposed<1>(fluxes[1], values);
      if constexpr (dim == 3)
        differentiate_transposed<2>(fluxes[2], values);
    }

    /// Point values of a function of degree k-1 from its nodal values.
    void interpolate_pressure(const Lanes *nodal, Lanes *values) const;
    /// The transpose.
    void interpolate_pressure_transposed(const Lanes *values, Lanes *nodal) const;

    /// Products of the weights of the Gauss points, which sum up to 1.
    const std::array<double, n_points> &weights() const { return point_weights; }

    /// Values of the shape functions in one direction, [point][node], and derivatives.
    const std::array<double, n_1d * n_1d> &values_1d() const { return velocity_values; }
    const std::array<double, n_1d * n_1d> &derivatives_1d() const { return node_derivatives; }
    /// The same for the pressure.
    const std::array<double, n_1d * degree> &pressure_values_1d() const { return pressure_values; }

  private:
    template <bool transpose, bool add>
    static void along_all_directions(const double *matrix, Lanes *values)
    {
      contract<1, power(n_1d, dim - 1), n_1d, n_1d, transpose, add>(matrix, values, values);
      contract<n_1d, power(n_1d, dim - 2), n_1d, n_1d, transpose, add>(matrix, values, values);
      if constexpr (dim == 3)
        contract<n_1d * n_1d, 1, n_1d, n_1d, transpose, add>(matrix, values, values);
    }

    std::array<double, n_1d * n_1d> velocity_values, node_derivatives, point_derivatives;
    std::array<double, n_1d * degree> pressure_values;
    std::array<double, n_points> point_weights;
  };

  /// Rows: points; columns: Lagrange polynomials of the nodes (or their derivatives).
  template <std::size_t size>
  void tabulate_lagrange(const std::vector<dealii::Point<1>> &nodes,
                         const std::vector<dealii::Point<1>> &points, const unsigned int derivative,
                         std::array<double, size> &table)
  {
    const auto basis = dealii::Polynomials::generate_complete_Lagrange_basis(nodes);
    std::vector<double> values(2);
    for (unsigned int q = 0; q < points.size(); ++q)
      for (unsigned int i = 0; i < nodes.size(); ++i)
      {
        basis[i].value(points[q][0], values);
        table[q * nodes.size() + i] = values[derivative];
      }
  }

  /// Nodes of FE_Q in one direction.
  inline std::vector<dealii::Point<1>> nodes_1d(const unsigned int degree)
  {
    if (degree == 0)
      return {dealii::Point<1>(0.5)};
    return dealii::QGaussLobatto<1>(degree + 1).get_points();
  }

  template <int dim, int degree>
  TensorKernel<dim, degree>::TensorKernel()
  {
    const dealii::QGauss<1> gauss(n_1d);
    const auto nodes = nodes_1d(degree);
    tabulate_lagrange(nodes, gauss.get_points(), 0, velocity_values);
    tabulate_lagrange(nodes, gauss.get_points(), 1, node_derivatives);
    tabulate_lagrange(gauss.get_points(), gauss.get_points(), 1, point_derivatives);
    tabulate_lagrange(nodes_1d(degree - 1), gauss.get_points(), 0, pressure_values);
    const dealii::Quadrature<dim> points(gauss);
    for (int q = 0; q < n_points; ++q)
      point_weights[q] = points.weight(q);
  }

  template <int dim, int degree>
  void TensorKernel<dim, degree>::interpolate_pressure(const Lanes *nodal, Lanes *values) const
  {
    const double *matrix = pressure_values.data();
    if constexpr (dim == 2)
    {
      Lanes first[n_1d * degree];
      contract<1, degree, degree, n_1d>(matrix, nodal, first);
      contract<n_1d, 1, degree, n_1d>(matrix, first, values);
    }
    else
    {
      Lanes first[n_1d * degree * degree], second[n_1d * n_1d * degree];
      contract<1, degree * degree, degree, n_1d>(matrix, nodal, first);
      contract<n_1d, degree, degree, n_1d>(matrix, first, second);
      contract<n_1d * n_1d, 1, degree, n_1d>(matrix, second, values);
    }
  }

  template <int dim, int degree>
  void TensorKernel<dim, degree>::interpolate_pressure_transposed(const Lanes *values,
                                                                  Lanes *nodal) const
  {
    const double *matrix = pressure_values.data();
    if constexpr (dim == 2)
    {
      Lanes first[n_1d * degree];
      contract<n_1d, 1, n_1d, degree, true>(matrix, values, first);
      contract<1, degree, n_1d, degree, true>(matrix, first, nodal);
    }
    else
    {
      Lanes first[n_1d * n_1d * degree], second[n_1d * degree * degree];
      contract<n_1d * n_1d, 1, n_1d, degree, true>(matrix, values, first);
      contract<n_1d, degree, n_1d, degree, true>(matrix, first, second);
      contract<1, degree * degree, n_1d, degree, true>(matrix, second, nodal);
    }
  }
} // namespace semilunar::flow

#endif
