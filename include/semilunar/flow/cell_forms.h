// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_flow_cell_forms_h
#define semilunar_flow_cell_forms_h

#include <semilunar/flow/parameters.h>
#include <semilunar/flow/spaces.h>

#include <functional>
#include <memory>

namespace semilunar::flow
{
  /// A vector that varies in space and time, such as a force per volume [dyn/cm^3].
  template <int dim>
  using VectorFunction =
      std::function<dealii::Tensor<1, dim>(const dealii::Point<dim> &x, double time)>;

  /// The integrals over cells of the Navier-Stokes equations, equations (1) to (6) of
  /// doc/theory/flow.md, evaluated without matrices at all Gauss points of n_lanes cells at once.
  ///
  /// Vectors that are read must be readable (Spaces::make_readable_*); vectors that are written are
  /// added to, hanging nodes and ghosts included: fold and compress them afterwards.
  template <int dim>
  class CellForms
  {
  public:
    static std::unique_ptr<CellForms> create(const Spaces<dim> &spaces,
                                             const Parameters &parameters);
    virtual ~CellForms() = default;

    /// Jacobians from the positions of the nodes.
    /// @throws NumericsError on all ranks if one is not positive
    virtual void update_geometry(const Vector &positions) = 0;

    /// What the forms are linear in the velocity about.
    struct Linearisation
    {
      const Vector &velocity;      ///< u* that advects
      const Vector *mesh_velocity; ///< uhat, nullptr: at rest
      double inertia = 0.;         ///< alpha_0 of u in du/dt [1/s]
      bool newton = false;         ///< add the derivative of u* in the advection
    };
    virtual void linearise(const Linearisation &about) = 0;

    /// Force per volume at all Gauss points.
    virtual void set_body_force(const VectorFunction<dim> &force, double time) = 0;

    /// Add momentum and continuity residuals of (u, p), with du/dt = inertia u + history.
    virtual void add_residual(const Vector &velocity, const Vector &pressure, const Vector &history,
                              Vector &momentum, Vector &continuity) = 0;
    /// Add the derivative of the residuals applied to (u, p).
    virtual void add_jacobian(const Vector &velocity, const Vector &pressure, Vector &momentum,
                              Vector &continuity) const = 0;
    /// The part of it that is the pressure's in the momentum equation.
    virtual void add_gradient(const Vector &pressure, Vector &momentum) const = 0;

    /// Matrices of one velocity component in the cells of a batch, [node][node][lane]: inertia,
    /// advection, SUPG, and a Laplacian for viscosity and grad-div. For preconditioning.
    virtual void momentum_matrix(unsigned int batch, Lanes *matrix) const = 0;
    /// Divergence matrices, [pressure node][velocity node][component][lane]: -(q, dv_c/dx_c).
    virtual void divergence_matrix(unsigned int batch, Lanes *matrix) const = 0;
    /// Pressure mass matrices [pressure node][pressure node][lane], weighted with
    /// 1/(viscosity + grad-div weight) of the cell.
    virtual void pressure_mass_matrix(unsigned int batch, Lanes *matrix) const = 0;

    /// Accumulated grad-div, equation (6): a weight gamma_L [g/(cm s)] for each batch and lane, 0
    /// where cells are not marked. What was accumulated stays in cells that stay marked.
    virtual void set_accumulated_grad_div(const std::vector<Lanes> &weights) = 0;
    /// p'_q <- p'_q - gamma_L div u at the points of marked cells.
    virtual void accumulate_divergence(const Vector &velocity) = 0;
    /// p'_q, [batch][point] of owned cells; nullptr on all ranks if no cell was ever marked.
    virtual std::vector<Lanes> *accumulated_pressure() = 0;
    /// The mesh was refined: forget the weights and the body force, and allow for p'_q on the new
    /// mesh if there is any.
    virtual void reinit(bool accumulates) = 0;

    /// Largest |w| k / h of a rank's cells [1/s], w = u* - uhat of the last linearisation, for the
    /// time step; and the largest cell Reynolds number rho |w| h / (k mu).
    struct Rates
    {
      double advection = 0., cell_reynolds = 0.;
    };
    virtual Rates largest_rates() const = 0;

    /// Volume of a rank's cells [cm^dim].
    virtual double volume() const = 0;
  };
} // namespace semilunar::flow

#endif
