// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_flow_cell_matrices_templates_h
#define semilunar_flow_cell_matrices_templates_h

#include <semilunar/core/exceptions.h>
#include <semilunar/flow/cell_forms_of_degree.h>
#include <semilunar/flow/cell_forms_of_degree.templates.h>
#include <semilunar/flow/lane_matrices.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace semilunar::flow
{
  template <int dim, int degree>
  void CellFormsOfDegree<dim, degree>::update_geometry(const Vector &positions)
  {
    geometry_points.resize(std::size_t(spaces.n_batches()) * n_points);
    positions_of_points.resize(geometry_points.size() * dim);
    double smallest = 1.;
    for (unsigned int batch = 0; batch < spaces.n_batches(); ++batch)
    {
      VectorValues x;
      Gradients dx;
      read(batch, positions, x);
      evaluate(x, dx);
      for (int q = 0; q < n_points; ++q)
      {
        const std::size_t index = std::size_t(batch) * n_points + q;
        Lanes jacobian[dim][dim];
        for (int c = 0; c < dim; ++c)
        {
          positions_of_points[index * dim + c] = x[c][q];
          for (int d = 0; d < dim; ++d)
            jacobian[c][d] = dx[c][d][q];
        }
        GeometryPoint &point = geometry_points[index];
        const Lanes det = invert(jacobian, point.inverse);
        point.jxw = det * kernel.weights()[q];
        for (unsigned int lane = 0; lane < n_lanes; ++lane)
          if (!(det[lane] > 0.))
            smallest = -1.;
      }
    }
    if (dealii::Utilities::MPI::min(smallest, spaces.communicator()) < 0.)
      throw NumericsError("the flow mesh has a cell with a Jacobian that is not positive", "", "");
  }

  template <int dim, int degree>
  Lanes CellFormsOfDegree<dim, degree>::stabilisation_time(const GeometryPoint &point,
                                                           const Lanes (&w)[dim]) const
  {
    // Equation (4); lengths are those between nodes, h / k, so that the unit cell has 2 k.
    const double scale = 2. * degree;
    const double rho = prm.density, mu = prm.viscosity, inverse_inequality = 9.;
    Lanes advective = Lanes{}, metric_squared = Lanes{};
    for (int d = 0; d < dim; ++d)
    {
      const Lanes along = scale * dot(point.inverse[d], w);
      advective += along * along;
    }
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j)
      {
        Lanes metric = Lanes{};
        for (int d = 0; d < dim; ++d)
          metric += point.inverse[d][i] * point.inverse[d][j];
        metric_squared += metric * metric;
      }
    const double transient = 2. * rho * inertia;
    const double viscous = mu * scale * scale;
    return 1. / square_root(transient * transient + rho * rho * advective +
                            inverse_inequality * viscous * viscous * metric_squared);
  }

  template <int dim, int degree>
  void CellFormsOfDegree<dim, degree>::linearise_batch(
      const unsigned int batch, const typename CellForms<dim>::Linearisation &about)
  {
    VectorValues u, mesh = {};
    Gradients du;
    read(batch, about.velocity, u);
    evaluate(u, du);
    if (about.mesh_velocity)
    {
      read(batch, *about.mesh_velocity, mesh);
      for (int c = 0; c < dim; ++c)
        kernel.interpolate(mesh[c]);
    }
    Lanes weight = Lanes{}, volume = Lanes{};
    for (int q = 0; q < n_points; ++q)
    {
      const std::size_t index = std::size_t(batch) * n_points + q;
      const GeometryPoint &point = geometry_points[index];
      AdvectionPoint &adv = advection_points[index];
      Lanes divergence = Lanes{}, along_squared = Lanes{};
      for (int c = 0; c < dim; ++c)
      {
        adv.w[c] = advects ? u[c][q] - mesh[c][q] : Lanes{};
        for (int d = 0; d < dim; ++d)
          divergence += du[c][d][q] * point.inverse[d][c];
      }
      for (int d = 0; d < dim; ++d)
      {
        const Lanes along = dot(point.inverse[d], adv.w);
        along_squared += along * along;
      }
      adv.skew = skew_form ? 0.5 * prm.density * divergence : Lanes{};
      adv.tau = prm.supg && advects ? stabilisation_time(point, adv.w) : Lanes{};
      // |w| h, with h along w: |w|^2 / |d xi/dx w|.
      const Lanes speed_squared = dot(adv.w, adv.w);
      weight += point.jxw * speed_squared / (square_root(along_squared) + 1e-100);
      volume += point.jxw;
    }
    grad_div[batch] = prm.grad_div + prm.grad_div_velocity * prm.density / degree * weight / volume;
    if (!accumulation_weight.empty())
      grad_div[batch] += accumulation_weight[batch];
  }

  template <int dim, int degree>
  void
  CellFormsOfDegree<dim, degree>::linearise(const typename CellForms<dim>::Linearisation &about)
  {
    inertia = about.inertia;
    newton = about.newton;
    advection_points.resize(geometry_points.size());
    grad_div.resize(spaces.n_batches());
    if (newton)
      newton_points.resize(std::size_t(spaces.n_owned_batches()) * n_points);
    for (unsigned int batch = 0; batch < spaces.n_batches(); ++batch)
      linearise_batch(batch, about);
  }

  template <int dim, int degree>
  void CellFormsOfDegree<dim, degree>::set_body_force(const VectorFunction<dim> &f,
                                                      const double time)
  {
    force.resize(std::size_t(spaces.n_owned_batches()) * n_points * dim);
    for (std::size_t i = 0; i < force.size() / dim; ++i)
      for (unsigned int lane = 0; lane < n_lanes; ++lane)
      {
        dealii::Point<dim> x;
        for (int c = 0; c < dim; ++c)
          x[c] = positions_of_points[i * dim + c][lane];
        const auto value = f(x, time);
        for (int c = 0; c < dim; ++c)
          force[i * dim + c][lane] = value[c];
      }
  }

  template <int dim, int degree>
  void CellFormsOfDegree<dim, degree>::shape_functions(const unsigned int q,
                                                       double (&values)[n_nodes],
                                                       double (&gradients)[dim][n_nodes]) const
  {
    constexpr int n_1d = degree + 1;
    const auto &value = kernel.values_1d(), &derivative = kernel.derivatives_1d();
    for (int i = 0; i < n_nodes; ++i)
    {
      values[i] = 1.;
      for (int d = 0; d < dim; ++d)
        gradients[d][i] = 1.;
      for (int d = 0; d < dim; ++d)
      {
        const int entry = (q / power(n_1d, d)) % n_1d * n_1d + (i / power(n_1d, d)) % n_1d;
        values[i] *= value[entry];
        for (int e = 0; e < dim; ++e)
          gradients[e][i] *= d == e ? derivative[entry] : value[entry];
      }
    }
  }

  template <int dim, int degree>
  void CellFormsOfDegree<dim, degree>::momentum_matrix(const unsigned int batch,
                                                       Lanes *matrix) const
  {
    // A third (in 2D: half) of the grad-div weight and of the transposed part of the stress reach
    // each component by itself.
    const Lanes diffusion =
        prm.viscosity * (stress_form ? 1. + 1. / dim : 1.) + grad_div[batch] / double(dim);
    const double rho = prm.density;
    std::fill(matrix, matrix + n_nodes * n_nodes, Lanes{});
    for (int q = 0; q < n_points; ++q)
    {
      const GeometryPoint &point = geometry(batch, q);
      const AdvectionPoint &adv = advection(batch, q);
      double values[n_nodes], reference[dim][n_nodes];
      shape_functions(q, values, reference);

      Lanes trial[n_nodes], gradient[dim][n_nodes], test[n_nodes];
      const Lanes reaction = rho * inertia + adv.skew;
      for (int i = 0; i < n_nodes; ++i)
      {
        Lanes along = Lanes{};
        for (int e = 0; e < dim; ++e)
        {
          gradient[e][i] = reference[0][i] * point.inverse[0][e];
          for (int d = 1; d < dim; ++d)
            gradient[e][i] += reference[d][i] * point.inverse[d][e];
          along += adv.w[e] * gradient[e][i];
        }
        trial[i] = reaction * values[i] + rho * along;
        test[i] = point.jxw * (values[i] + adv.tau * along);
      }
      const Lanes diffusion_jxw = diffusion * point.jxw;
      for (int i = 0; i < n_nodes; ++i)
      {
        Lanes flux[dim];
        for (int e = 0; e < dim; ++e)
          flux[e] = diffusion_jxw * gradient[e][i];
        Lanes *row = matrix + i * n_nodes;
        for (int j = 0; j < n_nodes; ++j)
        {
          Lanes sum = test[i] * trial[j];
          for (int e = 0; e < dim; ++e)
            sum += flux[e] * gradient[e][j];
          row[j] += sum;
        }
      }
    }
  }

  template <int dim, int degree>
  void CellFormsOfDegree<dim, degree>::divergence_matrix(const unsigned int batch,
                                                         Lanes *matrix) const
  {
    std::fill(matrix, matrix + n_pressure_nodes * n_nodes * dim, Lanes{});
    for (int q = 0; q < n_points; ++q)
    {
      const GeometryPoint &point = geometry(batch, q);
      double values[n_nodes], reference[dim][n_nodes];
      shape_functions(q, values, reference);
      const auto pressure = pressure_shapes(q);
      for (int j = 0; j < n_nodes; ++j)
        for (int c = 0; c < dim; ++c)
        {
          Lanes derivative = reference[0][j] * point.inverse[0][c];
          for (int d = 1; d < dim; ++d)
            derivative += reference[d][j] * point.inverse[d][c];
          derivative *= -point.jxw;
          for (int i = 0; i < n_pressure_nodes; ++i)
            matrix[(i * n_nodes + j) * dim + c] += pressure[i] * derivative;
        }
    }
  }

  template <int dim, int degree>
  std::array<double, CellFormsOfDegree<dim, degree>::n_pressure_nodes>
  CellFormsOfDegree<dim, degree>::pressure_shapes(const int q) const
  {
    constexpr int n_1d = degree + 1;
    std::array<double, n_pressure_nodes> values;
    for (int i = 0; i < n_pressure_nodes; ++i)
    {
      values[i] = 1.;
      for (int d = 0; d < dim; ++d)
        values[i] *= kernel.pressure_values_1d()[(q / power(n_1d, d)) % n_1d * degree +
                                                 (i / power(degree, d)) % degree];
    }
    return values;
  }

  template <int dim, int degree>
  void CellFormsOfDegree<dim, degree>::pressure_mass_matrix(const unsigned int batch,
                                                            Lanes *matrix) const
  {
    std::fill(matrix, matrix + n_pressure_nodes * n_pressure_nodes, Lanes{});
    for (int q = 0; q < n_points; ++q)
    {
      const auto pressure = pressure_shapes(q);
      const Lanes weight = geometry(batch, q).jxw / (prm.viscosity + grad_div[batch]);
      for (int i = 0; i < n_pressure_nodes; ++i)
        for (int j = 0; j < n_pressure_nodes; ++j)
          matrix[i * n_pressure_nodes + j] += weight * (pressure[i] * pressure[j]);
    }
  }

  template <int dim, int degree>
  void CellFormsOfDegree<dim, degree>::reinit(const bool with_accumulation)
  {
    accumulates = with_accumulation;
    accumulated.assign(accumulates ? std::size_t(spaces.n_owned_batches()) * n_points : 0, Lanes{});
    accumulation_weight.clear();
    force.clear();
  }

  template <int dim, int degree>
  void CellFormsOfDegree<dim, degree>::set_accumulated_grad_div(const std::vector<Lanes> &weights)
  {
    accumulates = true;
    accumulated.resize(std::size_t(spaces.n_owned_batches()) * n_points, Lanes{});
    accumulation_weight = weights;
    for (unsigned int batch = 0; batch < spaces.n_owned_batches(); ++batch)
      for (unsigned int lane = 0; lane < n_lanes; ++lane)
        if (weights[batch][lane] == 0.)
          for (int q = 0; q < n_points; ++q)
            accumulated[std::size_t(batch) * n_points + q][lane] = 0.;
  }

  template <int dim, int degree>
  typename CellForms<dim>::Rates CellFormsOfDegree<dim, degree>::largest_rates() const
  {
    typename CellForms<dim>::Rates rates;
    for (unsigned int batch = 0; batch < spaces.n_owned_batches(); ++batch)
      for (int q = 0; q < n_points; ++q)
      {
        const GeometryPoint &point = geometry(batch, q);
        const AdvectionPoint &adv = advection(batch, q);
        Lanes along_squared = Lanes{};
        for (int d = 0; d < dim; ++d)
        {
          const Lanes along = dot(point.inverse[d], adv.w);
          along_squared += along * along;
        }
        const Lanes rate = square_root(along_squared), speed_squared = dot(adv.w, adv.w);
        for (unsigned int lane = 0; lane < n_lanes; ++lane)
        {
          rates.advection = std::max(rates.advection, degree * rate[lane]);
          if (rate[lane] > 0.)
            rates.cell_reynolds =
                std::max(rates.cell_reynolds,
                         prm.density * speed_squared[lane] / (rate[lane] * degree * prm.viscosity));
        }
      }
    return rates;
  }

  template <int dim, int degree>
  double CellFormsOfDegree<dim, degree>::volume() const
  {
    double sum = 0.;
    for (unsigned int batch = 0; batch < spaces.n_owned_batches(); ++batch)
      for (int q = 0; q < n_points; ++q)
        for (unsigned int lane = 0; lane < spaces.n_filled_lanes(batch); ++lane)
          sum += geometry(batch, q).jxw[lane];
    return sum;
  }
} // namespace semilunar::flow

#endif
