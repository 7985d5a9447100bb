// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_flow_tests_h
#define semilunar_flow_tests_h

#include <semilunar/flow/flow_solver.h>

#include <deal.II/base/mpi.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/grid_generator.h>

#include "../tests.h"

namespace semilunar::tests
{
  using namespace semilunar::flow;
  using dealii::Point;
  using dealii::Tensor;

  template <int dim>
  using Mesh = dealii::parallel::distributed::Triangulation<dim>;
  template <int dim>
  using PressureFunction = std::function<double(const Point<dim> &, double)>;

  inline bool first_rank()
  {
    return dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  }

  /// L2 norms of the errors of velocity and pressure; the mean of the pressure's error is removed
  /// on request.
  struct Errors
  {
    double velocity = 0., pressure = 0.;
  };

  template <int dim>
  Errors errors_of(const FlowSolver<dim> &solver, const VectorFunction<dim> &velocity,
                   const PressureFunction<dim> &pressure, const bool remove_mean)
  {
    const auto &spaces = solver.spaces();
    const dealii::QGauss<dim> quadrature(spaces.degree() + 2);
    dealii::FEValues<dim> fe_u(solver.mapping(), spaces.velocity_dofs().get_fe(), quadrature,
                               dealii::update_values | dealii::update_quadrature_points |
                                   dealii::update_JxW_values);
    dealii::FEValues<dim> fe_p(solver.mapping(), spaces.pressure_dofs().get_fe(), quadrature,
                               dealii::update_values);
    std::array<Vector, dim> components;
    for (unsigned int c = 0; c < dim; ++c)
      components[c] = solver.velocity_component(c);
    std::vector<double> values(quadrature.size());
    double u2 = 0., p2 = 0., p1 = 0., volume = 0.;
    auto cell_p = spaces.pressure_dofs().begin_active();
    for (const auto &cell : spaces.velocity_dofs().active_cell_iterators())
    {
      if (cell->is_locally_owned())
      {
        fe_u.reinit(cell);
        fe_p.reinit(cell_p);
        for (unsigned int c = 0; c < dim; ++c)
        {
          fe_u.get_function_values(components[c], values);
          for (unsigned int q = 0; q < values.size(); ++q)
            u2 += fe_u.JxW(q) *
                  std::pow(values[q] - velocity(fe_u.quadrature_point(q), solver.time())[c], 2);
        }
        fe_p.get_function_values(solver.pressure(), values);
        for (unsigned int q = 0; q < values.size(); ++q)
        {
          const double e = values[q] - pressure(fe_u.quadrature_point(q), solver.time());
          p2 += fe_u.JxW(q) * e * e;
          p1 += fe_u.JxW(q) * e;
          volume += fe_u.JxW(q);
        }
      }
      ++cell_p;
    }
    const auto sum = [](const double x) { return dealii::Utilities::MPI::sum(x, MPI_COMM_WORLD); };
    u2 = sum(u2), p2 = sum(p2), p1 = sum(p1), volume = sum(volume);
    return {std::sqrt(u2), std::sqrt(std::max(p2 - (remove_mean ? p1 * p1 / volume : 0.), 0.))};
  }

  /// rho (du/dt + u.grad u) + grad p - mu laplace u of a solenoidal flow, by central differences of
  /// fourth order.
  template <int dim>
  VectorFunction<dim> force_of(const VectorFunction<dim> &u, const PressureFunction<dim> &p,
                               const double rho, const double mu)
  {
    return [=](const Point<dim> &x, const double t)
    {
      const double h = 2e-3;
      const auto first = [h](const auto &f)
      { return (8. * (f(h) - f(-h)) - (f(2. * h) - f(-2. * h))) / (12. * h); };
      const auto second = [h](const auto &f)
      { return (16. * (f(h) + f(-h)) - (f(2. * h) + f(-2. * h)) - 30. * f(0.)) / (12. * h * h); };
      const Tensor<1, dim> here = u(x, t);
      Tensor<1, dim> force = rho * first([&](const double s) { return u(x, t + s); });
      for (unsigned int d = 0; d < dim; ++d)
      {
        const auto along = [&](const double s) { return u(x + s * Point<dim>::unit_vector(d), t); };
        force += rho * here[d] * first(along) - mu * second(along);
        force[d] += first([&](const double s) { return p(x + s * Point<dim>::unit_vector(d), t); });
      }
      return force;
    };
  }
} // namespace semilunar::tests

#endif
