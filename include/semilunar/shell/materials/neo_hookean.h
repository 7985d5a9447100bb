// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_shell_materials_neo_hookean_h
#define semilunar_shell_materials_neo_hookean_h

#include <semilunar/shell/materials/incompressible.h>

namespace semilunar::shell
{
  /// psi = mu/2 (I1 - 3) (M9)
  struct NeoHookeanEnergy
  {
    double shear_modulus; ///< mu [dyn/cm^2]

    EnergyDerivatives derivatives(const ThicknessPoint &p) const
    {
      return energy_of_I1(0.5 * shear_modulus * p.I1_minus_3(), 0.5 * shear_modulus, 0., p);
    }
  };

  using NeoHookean = Incompressible<NeoHookeanEnergy>;
} // namespace semilunar::shell

#endif
