// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_shell_materials_mooney_rivlin_h
#define semilunar_shell_materials_mooney_rivlin_h

#include <semilunar/shell/materials/incompressible.h>

namespace semilunar::shell
{
  /// psi = c10 (I1 - 3) + c01 (I2 - 3), with I2 = C_33 g0^ab C_ab + det C_ab / det g0_ab (M10)
  struct MooneyRivlinEnergy
  {
    double c10; ///< [dyn/cm^2]
    double c01; ///< [dyn/cm^2]

    EnergyDerivatives derivatives(const ThicknessPoint &p) const
    {
      const double in_plane_trace = 2. + p.trace;
      const double area_squared = 1. + p.trace + p.determinant;
      const SymmetricMap gg = outer_product(p.deformed), exchange = exchange_product(p.deformed);

      EnergyDerivatives psi;
      psi.energy = c10 * p.I1_minus_3() + c01 * p.I2_minus_3();
      psi.dC33 = c10 + c01 * in_plane_trace;
      psi.dC33_dC33 = 0.;
      for (unsigned int i = 0; i < 3; ++i)
      {
        psi.dC[i] = (c10 + c01 * p.C33) * p.reference[i] + c01 * area_squared * p.deformed[i];
        psi.dC_dC33[i] = c01 * p.reference[i];
      }
      for (unsigned int i = 0; i < 6; ++i)
        psi.dC_dC[i] = c01 * area_squared * (gg[i] - 0.5 * exchange[i]);
      return psi;
    }
  };

  using MooneyRivlin = Incompressible<MooneyRivlinEnergy>;
} // namespace semilunar::shell

#endif
