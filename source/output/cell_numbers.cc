// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/output/cell_numbers.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/numerics/error_estimator.h>

#include <algorithm>
#include <cmath>

namespace semilunar::output
{
  namespace
  {
    /// Velocities in reference coordinates, J^-1 u: |u| over the cell's length along u [1/s].
    template <int dim>
    dealii::Tensor<1, dim> rate(const dealii::DerivativeForm<1, dim, dim> &inverse_jacobian,
                                const dealii::Tensor<1, dim> &u)
    {
      return dealii::apply_transformation(inverse_jacobian, u);
    }

    template <int dim>
    double squared_vorticity(const dealii::Tensor<2, dim> &gradient)
    {
      double sum = 0.;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j < i; ++j)
          sum += std::pow(gradient[i][j] - gradient[j][i], 2);
      return sum;
    }
  } // namespace

  template <int dim>
  CellNumbers cell_numbers(const FlowState<dim> &state)
  {
    const dealii::QGaussLobatto<dim> points(3);
    dealii::FEValues<dim> values(state.mapping, state.velocity_dofs.get_fe(), points,
                                 dealii::update_values | dealii::update_inverse_jacobians);
    const dealii::FEValuesExtractors::Vector velocity(0);
    std::vector<dealii::Tensor<1, dim>> u(points.size());
    CellNumbers numbers;
    numbers.reynolds.reinit(state.triangulation().n_active_cells());
    numbers.cfl.reinit(numbers.reynolds);
    const double degree = state.degree();
    for (const auto &cell : state.velocity_dofs.active_cell_iterators())
      if (is_owned_lumen(cell))
      {
        values.reinit(cell);
        values[velocity].get_function_values(state.velocity, u);
        double reynolds = 0., cfl = 0.;
        for (unsigned int q = 0; q < points.size(); ++q)
        {
          const double speed = u[q].norm();
          const double inverse_time = degree * rate<dim>(values.inverse_jacobian(q), u[q]).norm();
          cfl = std::max(cfl, inverse_time * state.dt);
          if (inverse_time > 0.)
            reynolds =
                std::max(reynolds, state.density * speed * speed / inverse_time / state.viscosity);
        }
        numbers.reynolds[cell->active_cell_index()] = reynolds;
        numbers.cfl[cell->active_cell_index()] = cfl;
      }
    return numbers;
  }

  template <int dim>
  dealii::Vector<float> error_indicators(const FlowState<dim> &state, const double vorticity_weight)
  {
    const unsigned int n_points = state.degree() + 1;
    dealii::Vector<float> indicators(state.triangulation().n_active_cells());
    dealii::KellyErrorEstimator<dim>::estimate(state.mapping, state.velocity_dofs,
                                               dealii::QGauss<dim - 1>(n_points), {},
                                               state.velocity, indicators);
    const dealii::QGauss<dim> points(n_points);
    dealii::FEValues<dim> values(state.mapping, state.velocity_dofs.get_fe(), points,
                                 dealii::update_gradients | dealii::update_JxW_values);
    const dealii::FEValuesExtractors::Vector velocity(0);
    std::vector<dealii::Tensor<2, dim>> gradients(points.size());
    for (const auto &cell : state.velocity_dofs.active_cell_iterators())
      if (is_owned_lumen(cell))
      {
        values.reinit(cell);
        values[velocity].get_function_gradients(state.velocity, gradients);
        double sum = 0.;
        for (unsigned int q = 0; q < points.size(); ++q)
          sum += values.JxW(q) * squared_vorticity(gradients[q]);
        float &indicator = indicators[cell->active_cell_index()];
        indicator = std::hypot(indicator, vorticity_weight * cell->diameter() * std::sqrt(sum));
      }
    return indicators;
  }

  template CellNumbers cell_numbers(const FlowState<2> &);
  template CellNumbers cell_numbers(const FlowState<3> &);
  template dealii::Vector<float> error_indicators(const FlowState<2> &, double);
  template dealii::Vector<float> error_indicators(const FlowState<3> &, double);
} // namespace semilunar::output
