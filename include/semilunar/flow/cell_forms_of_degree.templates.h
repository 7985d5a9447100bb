// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_flow_cell_forms_of_degree_templates_h
#define semilunar_flow_cell_forms_of_degree_templates_h

#include <semilunar/flow/cell_forms_of_degree.h>
#include <semilunar/flow/cell_vectors.h>

namespace semilunar::flow
{
  template <int dim, int degree>
  CellFormsOfDegree<dim, degree>::CellFormsOfDegree(const Spaces<dim> &spaces,
                                                    const Parameters &parameters)
      : spaces(spaces), prm(parameters), stress_form(parameters.viscous_form == "stress"),
        skew_form(parameters.convective_form == "skew"),
        advects(parameters.convective_form != "none")
  {
  }

  template <int dim, int degree>
  void CellFormsOfDegree<dim, degree>::read(const unsigned int batch, const Vector &vector,
                                            VectorValues &values) const
  {
    read_nodes(spaces.velocity_nodes(batch), vector.begin(), values);
  }

  template <int dim, int degree>
  void CellFormsOfDegree<dim, degree>::read_pressure(const unsigned int batch, const Vector &vector,
                                                     Lanes *nodal) const
  {
    const double *source = vector.begin();
    const auto *nodes = spaces.pressure_nodes(batch);
    for (int i = 0; i < n_pressure_nodes; ++i)
      for (unsigned int lane = 0; lane < n_lanes; ++lane)
        nodal[i][lane] = source[nodes[i][lane]];
  }

  template <int dim, int degree>
  void CellFormsOfDegree<dim, degree>::add(const unsigned int batch, const VectorValues &values,
                                           Vector &vector) const
  {
    add_to_nodes(spaces.velocity_nodes(batch), spaces.n_filled_lanes(batch), values,
                 vector.begin());
  }

  template <int dim, int degree>
  void CellFormsOfDegree<dim, degree>::add_pressure(const unsigned int batch, const Lanes *nodal,
                                                    Vector &vector) const
  {
    double *target = vector.begin();
    const auto *nodes = spaces.pressure_nodes(batch);
    for (unsigned int lane = 0; lane < spaces.n_filled_lanes(batch); ++lane)
      for (int i = 0; i < n_pressure_nodes; ++i)
        target[nodes[i][lane]] += nodal[i][lane];
  }

  template <int dim, int degree>
  void CellFormsOfDegree<dim, degree>::evaluate(VectorValues &values, Gradients &gradients) const
  {
    for (int c = 0; c < dim; ++c)
    {
      kernel.interpolate(values[c]);
      kernel.gradient(values[c], gradients[c]);
    }
  }

  template <int dim, int degree>
  void CellFormsOfDegree<dim, degree>::evaluate_pressure(const unsigned int batch,
                                                         const Vector &pressure, Values &values,
                                                         VectorValues &gradients) const
  {
    Lanes nodal[n_pressure_nodes];
    read_pressure(batch, pressure, nodal);
    kernel.interpolate_pressure(nodal, values);
    kernel.gradient(values, gradients);
  }

  template <int dim, int degree>
  void CellFormsOfDegree<dim, degree>::integrate(const unsigned int batch, VectorValues &values,
                                                 const Gradients &fluxes, Vector &momentum) const
  {
    for (int c = 0; c < dim; ++c)
    {
      kernel.gradient_transposed(fluxes[c], values[c]);
      kernel.interpolate_transposed(values[c]);
    }
    add(batch, values, momentum);
  }

  template <int dim, int degree>
  void CellFormsOfDegree<dim, degree>::integrate_pressure(const unsigned int batch,
                                                          const Values &values,
                                                          Vector &continuity) const
  {
    Lanes nodal[n_pressure_nodes];
    kernel.interpolate_pressure_transposed(values, nodal);
    add_pressure(batch, nodal, continuity);
  }

  /// Sum of reference derivatives [direction] times d xi / dx: the physical derivatives.
  template <int dim, int n_points>
  inline void physical_gradient(const Lanes (&reference)[dim][n_points], const int q,
                                const Lanes (&inverse)[dim][dim], Lanes (&result)[dim])
  {
    for (int e = 0; e < dim; ++e)
    {
      result[e] = reference[0][q] * inverse[0][e];
      for (int d = 1; d < dim; ++d)
        result[e] += reference[d][q] * inverse[d][e];
    }
  }

  /// Flux in reference directions from one in physical directions, times jxw.
  template <int dim, int n_points>
  inline void reference_flux(const Lanes (&flux)[dim], const int q,
                             const Lanes (&inverse)[dim][dim], const Lanes &jxw,
                             Lanes (&result)[dim][n_points])
  {
    for (int d = 0; d < dim; ++d)
    {
      Lanes sum = flux[0] * inverse[d][0];
      for (int e = 1; e < dim; ++e)
        sum += flux[e] * inverse[d][e];
      result[d][q] = jxw * sum;
    }
  }

  template <int dim>
  inline Lanes dot(const Lanes (&a)[dim], const Lanes (&b)[dim])
  {
    Lanes sum = a[0] * b[0];
    for (int c = 1; c < dim; ++c)
      sum += a[c] * b[c];
    return sum;
  }

  /// viscosity grad u, and its transpose in the stress form, plus an isotropic part.
  template <int dim>
  inline void viscous_flux(const Lanes (&gradient)[dim][dim], const double viscosity,
                           const double transposed_viscosity, const Lanes &isotropic,
                           Lanes (&flux)[dim][dim])
  {
    for (int c = 0; c < dim; ++c)
    {
      for (int e = 0; e < dim; ++e)
        flux[c][e] = viscosity * gradient[c][e] + transposed_viscosity * gradient[e][c];
      flux[c][c] += isotropic;
    }
  }

  template <int dim, int degree>
  void CellFormsOfDegree<dim, degree>::add_jacobian(const Vector &velocity, const Vector &pressure,
                                                    Vector &momentum, Vector &continuity) const
  {
    if (newton)
      add_jacobian_of<true>(velocity, pressure, momentum, continuity);
    else
      add_jacobian_of<false>(velocity, pressure, momentum, continuity);
  }

  template <int dim, int degree>
  template <bool newton>
  void CellFormsOfDegree<dim, degree>::add_jacobian_of(const Vector &velocity,
                                                       const Vector &pressure, Vector &momentum,
                                                       Vector &continuity) const
  {
    for (unsigned int batch = 0; batch < spaces.n_owned_batches(); ++batch)
    {
      VectorValues u, dp;
      Gradients du;
      Values p;
      read(batch, velocity, u);
      evaluate(u, du);
      evaluate_pressure(batch, pressure, p, dp);
      for (int q = 0; q < n_points; ++q)
        jacobian_at_point<newton>(batch, q, u, du, p, dp);
      integrate(batch, u, du, momentum);
      integrate_pressure(batch, p, continuity);
    }
  }

  template <int dim, int degree>
  template <bool newton>
  DEAL_II_ALWAYS_INLINE inline void
  CellFormsOfDegree<dim, degree>::jacobian_at_point(const unsigned int batch, const int q,
                                                    VectorValues &u, Gradients &du, Values &p,
                                                    const VectorValues &dp) const
  {
    const GeometryPoint &point = geometry(batch, q);
    const AdvectionPoint &adv = advection(batch, q);
    const double rho = prm.density, mu = prm.viscosity;
    Lanes gradient[dim][dim], pressure_gradient[dim], value[dim];
    Lanes divergence = Lanes{};
    for (int c = 0; c < dim; ++c)
    {
      physical_gradient(du[c], q, point.inverse, gradient[c]);
      divergence += gradient[c][c];
      value[c] = u[c][q];
    }
    physical_gradient(dp, q, point.inverse, pressure_gradient);

    Lanes flux[dim][dim];
    viscous_flux(gradient, mu, stress_form ? mu : 0., grad_div[batch] * divergence - p[q], flux);
    for (int c = 0; c < dim; ++c)
    {
      Lanes momentum_change = rho * (inertia * value[c] + dot(adv.w, gradient[c]));
      Lanes tested = momentum_change + adv.skew * value[c];
      if constexpr (newton)
      {
        const NewtonPoint &old = newton_points[std::size_t(batch) * n_points + q];
        const Lanes reaction = rho * dot(value, old.gradient[c]);
        momentum_change += reaction;
        tested += reaction;
        if (skew_form)
          tested += 0.5 * rho * divergence * old.velocity[c];
        const Lanes along = adv.tau * old.strong_residual[c];
        for (int e = 0; e < dim; ++e)
          flux[c][e] += along * value[e];
      }
      const Lanes along = adv.tau * (momentum_change + pressure_gradient[c]);
      for (int e = 0; e < dim; ++e)
        flux[c][e] += along * adv.w[e];
      u[c][q] = tested * point.jxw;
      reference_flux(flux[c], q, point.inverse, point.jxw, du[c]);
    }
    p[q] = -divergence * point.jxw;
  }

  template <int dim, int degree>
  void CellFormsOfDegree<dim, degree>::add_gradient(const Vector &pressure, Vector &momentum) const
  {
    for (unsigned int batch = 0; batch < spaces.n_owned_batches(); ++batch)
    {
      Values p;
      VectorValues dp, values = {};
      Gradients fluxes;
      evaluate_pressure(batch, pressure, p, dp);
      for (int q = 0; q < n_points; ++q)
      {
        const GeometryPoint &point = geometry(batch, q);
        const AdvectionPoint &adv = advection(batch, q);
        Lanes pressure_gradient[dim];
        physical_gradient(dp, q, point.inverse, pressure_gradient);
        for (int c = 0; c < dim; ++c)
        {
          Lanes flux[dim];
          for (int e = 0; e < dim; ++e)
            flux[e] = adv.tau * pressure_gradient[c] * adv.w[e];
          flux[c] -= p[q];
          reference_flux(flux, q, point.inverse, point.jxw, fluxes[c]);
        }
      }
      integrate(batch, values, fluxes, momentum);
    }
  }

  template <int dim, int degree>
  void CellFormsOfDegree<dim, degree>::laplacian(const unsigned int batch,
                                                 const Gradients &gradients,
                                                 VectorValues &result) const
  {
    // The gradient is interpolated at the Gauss points, which is exact on parallelepipeds.
    for (int c = 0; c < dim; ++c)
    {
      for (int q = 0; q < n_points; ++q)
        result[c][q] = Lanes{};
      for (int e = 0; e < dim; ++e)
      {
        VectorValues second;
        kernel.gradient(gradients[c][e], second);
        for (int q = 0; q < n_points; ++q)
          for (int d = 0; d < dim; ++d)
            result[c][q] += geometry(batch, q).inverse[d][e] * second[d][q];
      }
    }
  }

  template <int dim, int degree>
  void CellFormsOfDegree<dim, degree>::add_residual(const Vector &velocity, const Vector &pressure,
                                                    const Vector &history, Vector &momentum,
                                                    Vector &continuity)
  {
    for (unsigned int batch = 0; batch < spaces.n_owned_batches(); ++batch)
    {
      VectorValues u, past, dp, viscous = {};
      Gradients du, gradients;
      Values p;
      read(batch, velocity, u);
      evaluate(u, du);
      read(batch, history, past);
      for (int c = 0; c < dim; ++c)
        kernel.interpolate(past[c]);
      evaluate_pressure(batch, pressure, p, dp);
      for (int q = 0; q < n_points; ++q)
        for (int c = 0; c < dim; ++c)
        {
          Lanes gradient[dim];
          physical_gradient(du[c], q, geometry(batch, q).inverse, gradient);
          for (int e = 0; e < dim; ++e)
            gradients[c][e][q] = gradient[e];
        }
      if (prm.supg && advects)
        laplacian(batch, gradients, viscous);
      for (int q = 0; q < n_points; ++q)
        residual_at_point(batch, q, past, gradients, viscous, dp, u, du, p);
      integrate(batch, u, du, momentum);
      integrate_pressure(batch, p, continuity);
    }
  }

  template <int dim, int degree>
  DEAL_II_ALWAYS_INLINE inline void CellFormsOfDegree<dim, degree>::residual_at_point(
      const unsigned int batch, const int q, const VectorValues &past, const Gradients &gradients,
      const VectorValues &laplacian, const VectorValues &dp, VectorValues &u, Gradients &fluxes,
      Values &p)
  {
    const GeometryPoint &point = geometry(batch, q);
    const AdvectionPoint &adv = advection(batch, q);
    const std::size_t index = std::size_t(batch) * n_points + q;
    const double rho = prm.density, mu = prm.viscosity;
    Lanes gradient[dim][dim], pressure_gradient[dim];
    Lanes divergence = Lanes{};
    for (int c = 0; c < dim; ++c)
    {
      for (int e = 0; e < dim; ++e)
        gradient[c][e] = gradients[c][e][q];
      divergence += gradient[c][c];
    }
    physical_gradient(dp, q, point.inverse, pressure_gradient);

    Lanes isotropic = grad_div[batch] * divergence - p[q];
    if (!accumulated.empty())
      isotropic -= accumulated[index];
    Lanes flux[dim][dim];
    viscous_flux(gradient, mu, stress_form ? mu : 0., isotropic, flux);
    for (int c = 0; c < dim; ++c)
    {
      Lanes momentum_change = rho * (inertia * u[c][q] + past[c][q] + dot(adv.w, gradient[c]));
      if (!force.empty())
        momentum_change -= force[index * dim + c];
      const Lanes strong = momentum_change + pressure_gradient[c] - mu * laplacian[c][q];
      for (int e = 0; e < dim; ++e)
        flux[c][e] += adv.tau * strong * adv.w[e];
      if (newton)
      {
        NewtonPoint &store = newton_points[index];
        store.velocity[c] = u[c][q];
        store.strong_residual[c] = strong;
        for (int e = 0; e < dim; ++e)
          store.gradient[c][e] = gradient[c][e];
      }
      u[c][q] = (momentum_change + adv.skew * u[c][q]) * point.jxw;
      reference_flux(flux[c], q, point.inverse, point.jxw, fluxes[c]);
    }
    p[q] = -divergence * point.jxw;
  }

  template <int dim, int degree>
  void CellFormsOfDegree<dim, degree>::accumulate_divergence(const Vector &velocity)
  {
    if (accumulation_weight.empty())
      return;
    for (unsigned int batch = 0; batch < spaces.n_owned_batches(); ++batch)
    {
      VectorValues u;
      Gradients du;
      read(batch, velocity, u);
      evaluate(u, du);
      for (int q = 0; q < n_points; ++q)
      {
        const GeometryPoint &point = geometry(batch, q);
        Lanes divergence = Lanes{};
        for (int c = 0; c < dim; ++c)
          for (int d = 0; d < dim; ++d)
            divergence += du[c][d][q] * point.inverse[d][c];
        accumulated[std::size_t(batch) * n_points + q] -= accumulation_weight[batch] * divergence;
      }
    }
  }
} // namespace semilunar::flow

#endif
