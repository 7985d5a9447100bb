// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_shell_materials_fung_h
#define semilunar_shell_materials_fung_h

#include <semilunar/shell/materials/incompressible.h>

#include <cmath>

namespace semilunar::shell
{
  /// psi = c0/2 (I1 - 3) + c1/2 (exp(c2 (I1 - 3)^2) - 1) (M11); Hsu et al. 2015, eq. (15)
  struct FungEnergy
  {
    double c0; ///< [dyn/cm^2]
    double c1; ///< [dyn/cm^2]
    double c2; ///< dimensionless

    EnergyDerivatives derivatives(const ThicknessPoint &p) const
    {
      const double excess = p.I1_minus_3();
      const double exponent = c2 * excess * excess;
      const double exponential = std::exp(exponent);
      const double stiffness = c1 * c2 * exponential;
      return energy_of_I1(0.5 * (c0 * excess + c1 * (exponential - 1.)),
                          0.5 * c0 + stiffness * excess, stiffness * (1. + 2. * exponent), p);
    }
  };

  using Fung = Incompressible<FungEnergy>;
} // namespace semilunar::shell

#endif
