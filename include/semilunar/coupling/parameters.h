// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_coupling_parameters_h
#define semilunar_coupling_parameters_h

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace semilunar::coupling
{
  /// How structures and fluid hold each other: the entries of section "Coupling".
  struct Parameters
  {
    double beta_normal = 2000.;     ///< g/(cm^2 s)
    double beta_tangential = 2000.; ///< g/(cm^2 s)
    double relaxation = 1e-5;       ///< r of the multiplier [-]
    double points_per_cell = 3.;    ///< points per width of a fluid cell and direction
    double incompressibility = 0.4; ///< weight of the accumulated grad-div, in rho h^2 / dt [-]

    std::string scheme = "quasi-direct"; ///< or "block"
    double tolerance = 1e-3;             ///< of the shell's residual relative to its forces
    unsigned int max_iterations = 12;

    void add_parameters(dealii::ParameterHandler &prm);
  };
} // namespace semilunar::coupling

#endif
