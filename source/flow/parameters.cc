// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/core/parameters.h>
#include <semilunar/flow/parameters.h>

#include <deal.II/base/parameter_handler.h>

namespace semilunar::flow
{
  namespace Patterns = dealii::Patterns;

  namespace
  {
    void add_discretisation(Parameters &p, dealii::ParameterHandler &prm)
    {
      const Patterns::Double not_negative(0.);
      prm.add_parameter("Degree", p.degree,
                        "Polynomial degree of the velocity, 2 or 3; the pressure has one less",
                        Patterns::Integer(2, 3));
      prm.add_parameter(
          "Viscous form", p.viscous_form,
          "stress: 2 mu eps(u), tractions are sigma n; Laplacian: mu grad u, tractions "
          "are -p n + mu du/dn (the do-nothing condition of many benchmarks)",
          Patterns::Selection("stress|Laplacian"));
      prm.add_parameter(
          "Convective form", p.convective_form,
          "skew: convective plus rho/2 (div u) u, which keeps the energy bounded; none: "
          "Stokes flow",
          Patterns::Selection("skew|convective|none"));
      prm.add_parameter("SUPG", p.supg, "Streamline-upwind stabilisation of the momentum equation");
      prm.add_parameter("Grad-div", p.grad_div, "Constant weight of (div u, div v) [g/(cm s)]",
                        not_negative);
      prm.add_parameter("Grad-div velocity", p.grad_div_velocity,
                        "Weight of (div u, div v) that grows with the velocity, as a multiple of "
                        "rho |u| h / degree [-]",
                        not_negative);
      prm.add_parameter("Backflow", p.backflow,
                        "Factor beta of the stabilisation where fluid enters through open "
                        "boundaries [-]; 0.5 bounds the energy, 0 turns it off",
                        Patterns::Double(0., 1.));
    }

    void add_solvers(Parameters &p, dealii::ParameterHandler &prm)
    {
      const Patterns::Double tolerance(0., 0.5);
      prm.add_parameter("Time scheme", p.time_scheme,
                        "Backward differentiation of order 2 or 1 (the first step is always of "
                        "order 1)",
                        Patterns::Selection("BDF2|BDF1"));
      prm.add_parameter("Nonlinear scheme", p.nonlinear,
                        "linear-implicit: one linear system a step, advected by the velocity "
                        "extrapolated from the last two; Newton and Picard: iterate until the "
                        "residual has converged",
                        Patterns::Selection("linear-implicit|Newton|Picard"));
      prm.add_parameter("Nonlinear tolerance", p.nonlinear_tolerance,
                        "Newton, Picard: reduction of the residual of the old state [-]",
                        tolerance);
      prm.add_parameter("Nonlinear iterations", p.max_nonlinear,
                        "Newton, Picard: after these the step has failed", Patterns::Integer(1));
      prm.add_parameter("Linear tolerance", p.linear_tolerance,
                        "Reduction of the residual of the old state [-]", tolerance);
      prm.add_parameter("Linear iterations", p.max_linear,
                        "After these the linear solver has failed", Patterns::Integer(1));
    }

    void add_step_control(Parameters &p, dealii::ParameterHandler &prm)
    {
      prm.add_parameter("Step control", p.step_control,
                        "Time step: as given, by the CFL number, or by an estimate of the error of "
                        "each step",
                        Patterns::Selection("fixed|CFL|error"));
      prm.add_parameter("CFL", p.cfl, "Wanted largest |u| dt degree / h [-]", positive_number());
      prm.add_parameter("Time error", p.time_error,
                        "Wanted error of a step relative to the largest velocity (root mean square "
                        "over the nodes) [-]",
                        positive_number());
      prm.add_parameter("Smallest step", p.min_dt, "Of step control [s]", Patterns::Double(0.));
      prm.add_parameter("Largest step", p.max_dt, "Of step control [s]", positive_number());
    }
  } // namespace

  void Parameters::add_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Flow");
    prm.add_parameter("Density", density, "[g/cm^3]", positive_number());
    prm.add_parameter("Viscosity", viscosity, "Dynamic viscosity [g/(cm s)]", positive_number());
    add_discretisation(*this, prm);
    add_solvers(*this, prm);
    add_step_control(*this, prm);
    prm.leave_subsection();
  }

  void Parameters::check() const
  {
    if (min_dt > max_dt)
      throw InputError("Flow/Smallest step", std::to_string(min_dt), "more than the largest step",
                       "give a value below Flow/Largest step");
  }
} // namespace semilunar::flow
