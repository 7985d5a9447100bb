// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_flow_cell_forms_of_degree_h
#define semilunar_flow_cell_forms_of_degree_h

#include <semilunar/flow/cell_forms.h>
#include <semilunar/flow/tensor_kernel.h>

namespace semilunar::flow
{
  /// The forms for one degree, which the loops are unrolled for.
  template <int dim, int degree>
  class CellFormsOfDegree : public CellForms<dim>
  {
  public:
    CellFormsOfDegree(const Spaces<dim> &spaces, const Parameters &parameters);

    void update_geometry(const Vector &positions) override;
    void linearise(const typename CellForms<dim>::Linearisation &about) override;
    void set_body_force(const VectorFunction<dim> &force, double time) override;
    void add_residual(const Vector &velocity, const Vector &pressure, const Vector &history,
                      Vector &momentum, Vector &continuity) override;
    void add_jacobian(const Vector &velocity, const Vector &pressure, Vector &momentum,
                      Vector &continuity) const override;
    void add_gradient(const Vector &pressure, Vector &momentum) const override;
    void momentum_matrix(unsigned int batch, Lanes *matrix) const override;
    void divergence_matrix(unsigned int batch, Lanes *matrix) const override;
    void pressure_mass_matrix(unsigned int batch, Lanes *matrix) const override;
    void set_accumulated_grad_div(const std::vector<Lanes> &weights) override;
    void accumulate_divergence(const Vector &velocity) override;
    std::vector<Lanes> *accumulated_pressure() override
    {
      return accumulates ? &accumulated : nullptr;
    }
    void reinit(bool accumulates) override;
    typename CellForms<dim>::Rates largest_rates() const override;
    double volume() const override;

  private:
    using Kernel = TensorKernel<dim, degree>;
    static constexpr int n_nodes = Kernel::n_nodes;
    static constexpr int n_pressure_nodes = Kernel::n_pressure_nodes;
    static constexpr int n_points = Kernel::n_points;

    /// What the mesh gives at a Gauss point.
    struct GeometryPoint
    {
      Lanes inverse[dim][dim]; ///< d xi_d / d x_e
      Lanes jxw;
    };
    /// What advection gives: w = u* - uhat, tau of SUPG, and rho/2 div u* of the skew form.
    struct AdvectionPoint
    {
      Lanes w[dim], tau, skew;
    };
    /// What Newton's method needs in addition: of the last residual.
    struct NewtonPoint
    {
      Lanes velocity[dim], gradient[dim][dim], strong_residual[dim];
    };

    using Values = Lanes[n_points];
    using VectorValues = Lanes[dim][n_points];
    using Gradients = Lanes[dim][dim][n_points];

    void read(unsigned int batch, const Vector &vector, VectorValues &values) const;
    void read_pressure(unsigned int batch, const Vector &vector, Lanes *nodal) const;
    void add(unsigned int batch, const VectorValues &values, Vector &vector) const;
    void add_pressure(unsigned int batch, const Lanes *nodal, Vector &vector) const;

    /// values: nodal values, then values at the points; gradients: reference gradients.
    void evaluate(VectorValues &values, Gradients &gradients) const;
    void evaluate_pressure(unsigned int batch, const Vector &pressure, Values &values,
                           VectorValues &gradients) const;
    /// Sum up point values and fluxes (reference directions) for each node; destroys the values.
    void integrate(unsigned int batch, VectorValues &values, const Gradients &fluxes,
                   Vector &momentum) const;
    void integrate_pressure(unsigned int batch, const Values &values, Vector &continuity) const;

    template <bool newton>
    void add_jacobian_of(const Vector &velocity, const Vector &pressure, Vector &momentum,
                         Vector &continuity) const;
    /// At a Gauss point: from u, du, p, dp to what their test functions are integrated with, in
    /// their place.
    template <bool newton>
    void jacobian_at_point(unsigned int batch, int q, VectorValues &u, Gradients &du, Values &p,
                           const VectorValues &dp) const;
    /// The same for the residual. @param past history at the points @param gradients physical
    /// @param fluxes result of du
    void residual_at_point(unsigned int batch, int q, const VectorValues &past,
                           const Gradients &gradients, const VectorValues &laplacian,
                           const VectorValues &dp, VectorValues &u, Gradients &fluxes, Values &p);
    /// Laplacian of the velocity at the points from its physical gradients.
    void laplacian(unsigned int batch, const Gradients &gradients, VectorValues &result) const;
    void linearise_batch(unsigned int batch, const typename CellForms<dim>::Linearisation &about);
    Lanes stabilisation_time(const GeometryPoint &point, const Lanes (&w)[dim]) const;
    void shape_functions(unsigned int q, double (&values)[n_nodes],
                         double (&gradients)[dim][n_nodes]) const;
    std::array<double, n_pressure_nodes> pressure_shapes(int q) const;

    const GeometryPoint &geometry(const unsigned int batch, const int q) const
    {
      return geometry_points[std::size_t(batch) * n_points + q];
    }
    const AdvectionPoint &advection(const unsigned int batch, const int q) const
    {
      return advection_points[std::size_t(batch) * n_points + q];
    }

    const Spaces<dim> &spaces;
    const Parameters &prm;
    const Kernel kernel;
    const bool stress_form, skew_form, advects;

    std::vector<GeometryPoint> geometry_points;
    std::vector<AdvectionPoint> advection_points;
    std::vector<NewtonPoint> newton_points;
    std::vector<Lanes> grad_div;            ///< of a batch, the accumulated weight included
    std::vector<Lanes> force;               ///< [batch][point][component], empty: none
    std::vector<Lanes> positions_of_points; ///< [batch][point][component]
    std::vector<Lanes> accumulation_weight, accumulated;
    double inertia = 0.;
    bool newton = false, accumulates = false;
  };
} // namespace semilunar::flow

#endif
