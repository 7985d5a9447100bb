// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/output/flow_errors.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <cmath>

namespace semilunar::output
{
  namespace
  {
    template <int dim>
    using VelocityField = std::function<dealii::Tensor<1, dim>(const dealii::Point<dim> &)>;

    /// du_i/dx_j by central differences of fourth order: accurate to 1e-10 of the velocity's scale
    /// for fields that vary over lengths of 1.
    template <int dim>
    dealii::Tensor<2, dim> gradient(const VelocityField<dim> &velocity, const dealii::Point<dim> &x)
    {
      constexpr double step = 1e-3;
      dealii::Tensor<2, dim> result;
      for (unsigned int j = 0; j < dim; ++j)
      {
        const auto at = [&](const double offset)
        {
          dealii::Point<dim> moved = x;
          moved[j] += offset * step;
          return velocity(moved);
        };
        const auto derivative = (8. * (at(1.) - at(-1.)) - (at(2.) - at(-2.))) / (12. * step);
        for (unsigned int i = 0; i < dim; ++i)
          result[i][j] = derivative[i];
      }
      return result;
    }
  } // namespace

  template <int dim>
  FlowErrors flow_errors(const FlowState<dim> &state, const VelocityField<dim> &velocity,
                         const std::function<double(const dealii::Point<dim> &)> &pressure,
                         const bool level_is_free)
  {
    const dealii::QGauss<dim> points(state.degree() + 2);
    const auto flags = dealii::update_values | dealii::update_gradients |
                       dealii::update_quadrature_points | dealii::update_JxW_values;
    dealii::FEValues<dim> u_values(state.mapping, state.velocity_dofs.get_fe(), points, flags);
    dealii::FEValues<dim> p_values(state.mapping, state.pressure_dofs.get_fe(), points,
                                   dealii::update_values);
    const dealii::FEValuesExtractors::Vector extractor(0);
    std::vector<dealii::Tensor<1, dim>> u(points.size());
    std::vector<dealii::Tensor<2, dim>> grad_u(points.size());
    std::vector<double> p(points.size());
    double u_sum = 0., grad_sum = 0., p_sum = 0., p_square = 0., volume = 0., u_max = 0.;
    auto p_cell = state.pressure_dofs.begin_active();
    for (const auto &cell : state.velocity_dofs.active_cell_iterators())
    {
      if (cell->is_locally_owned())
      {
        u_values.reinit(cell);
        p_values.reinit(p_cell);
        u_values[extractor].get_function_values(state.velocity, u);
        u_values[extractor].get_function_gradients(state.velocity, grad_u);
        p_values.get_function_values(state.pressure, p);
        for (unsigned int q = 0; q < points.size(); ++q)
        {
          const auto &x = u_values.quadrature_point(q);
          const double jxw = u_values.JxW(q);
          const double u_error = (u[q] - velocity(x)).norm_square();
          u_sum += jxw * u_error;
          u_max = std::max(u_max, u_error);
          grad_sum += jxw * (grad_u[q] - gradient<dim>(velocity, x)).norm_square();
          const double p_error = pressure ? p[q] - pressure(x) : 0.;
          p_sum += jxw * p_error;
          p_square += jxw * p_error * p_error;
          volume += jxw;
        }
      }
      ++p_cell;
    }
    std::vector<double> sums = {u_sum, grad_sum, p_square, p_sum, volume};
    dealii::Utilities::MPI::sum(sums, state.communicator(), sums);
    const double p_mean = level_is_free ? sums[3] / sums[4] : 0.;
    return {std::sqrt(sums[0]), std::sqrt(sums[1]),
            std::sqrt(std::max(0., sums[2] - 2. * p_mean * sums[3] + p_mean * p_mean * sums[4])),
            std::sqrt(dealii::Utilities::MPI::max(u_max, state.communicator()))};
  }

  template FlowErrors flow_errors(const FlowState<2> &, const VelocityField<2> &,
                                  const std::function<double(const dealii::Point<2> &)> &, bool);
  template FlowErrors flow_errors(const FlowState<3> &, const VelocityField<3> &,
                                  const std::function<double(const dealii::Point<3> &)> &, bool);
} // namespace semilunar::output
