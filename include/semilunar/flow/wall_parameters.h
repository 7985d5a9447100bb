// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_flow_wall_parameters_h
#define semilunar_flow_wall_parameters_h

#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace semilunar::flow
{
  /// The solid that wall cells consist of: the entries of section "Wall". The defaults are those of
  /// an aorta.
  struct WallParameters
  {
    void add_parameters(dealii::ParameterHandler &prm);
    /// @throws InputError if components are missing
    void check(unsigned int dim) const;

    std::string material = "neo-Hookean"; ///< or "St.Venant-Kirchhoff"
    double youngs_modulus = 1e7;          ///< dyn/cm^2
    double poisson_ratio = 0.45;
    double density = 1.;                             ///< g/cm^3
    double damping = 1e4;                            ///< proportional to mass [1/s]
    std::vector<double> acceleration = {0., 0., 0.}; ///< of gravity [cm/s^2]
    double prestress = 0.; ///< pressure of the blood that the wall at rest balances [mmHg]
    std::vector<std::string> supported = {"outer_wall"}; ///< names of parts of the boundary
    double support_stiffness = 0.;                       ///< [dyn/cm^3]
    double support_damping = 0.;                         ///< [dyn s/cm^3]
    std::string prediction = "extrapolated";             ///< of the wall's velocity: its mesh
    unsigned int max_geometry_iterations = 1;            ///< of a step
    double geometry_tolerance = 1e-4;                    ///< of the interface [cm]

    bool given = false;  ///< whether any entry was written
    std::string changed; ///< an entry that is not what it is by default; empty: there is none

    bool has_support() const { return support_stiffness > 0. || support_damping > 0.; }
    /// Lame's constants and the bulk modulus [dyn/cm^2].
    double shear_modulus() const { return youngs_modulus / (2. * (1. + poisson_ratio)); }
    double lame() const
    {
      return youngs_modulus * poisson_ratio / ((1. + poisson_ratio) * (1. - 2. * poisson_ratio));
    }
    double bulk_modulus() const { return youngs_modulus / (3. * (1. - 2. * poisson_ratio)); }
  };
} // namespace semilunar::flow

#endif
