// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_flow_parameters_h
#define semilunar_flow_parameters_h

#include <limits>
#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace semilunar::flow
{
  /// How blood flow is modelled and computed: the entries of section "Flow".
  struct Parameters
  {
    void add_parameters(dealii::ParameterHandler &prm);
    /// @throws InputError if an entry is out of its range
    void check() const;

    double density = 1.;     ///< g/cm^3
    double viscosity = 0.03; ///< g/(cm s)

    unsigned int degree = 2; ///< of the velocity; the pressure has one less

    std::string viscous_form = "stress";  ///< or "Laplacian"
    std::string convective_form = "skew"; ///< or "convective", "none" (Stokes)
    bool supg = true;
    double grad_div = 1.;          ///< constant weight [g/(cm s)]
    double grad_div_velocity = 0.; ///< weight that grows with the velocity, times rho h |w| / k [-]
    double backflow = 0.5;         ///< beta of open boundaries [-]

    std::string time_scheme = "BDF2";          ///< or "BDF1"
    std::string nonlinear = "linear-implicit"; ///< or "Newton", "Picard"
    double nonlinear_tolerance = 1e-8;         ///< relative to the first residual of the step
    unsigned int max_nonlinear = 12;
    double linear_tolerance = 1e-4; ///< relative to the residual of the old state
    unsigned int max_linear = 500;

    std::string step_control = "fixed"; ///< or "CFL", "error"
    double cfl = 1.;                    ///< wanted, by |w| dt k / h
    double time_error = 1e-3;           ///< wanted local error relative to the largest velocity
    double min_dt = 0., max_dt = std::numeric_limits<double>::max(); ///< s
  };
} // namespace semilunar::flow

#endif
