// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_shell_materials_saint_venant_kirchhoff_h
#define semilunar_shell_materials_saint_venant_kirchhoff_h

#include <semilunar/shell/materials/material_response.h>

namespace semilunar::shell
{
  /// Stress linear in the Green-Lagrange strain, plane stress (M13). Compressible: the thickness
  /// change does not enter.
  struct SaintVenantKirchhoff
  {
    static constexpr bool admits_any_deformation = true;

    double youngs_modulus; ///< [dyn/cm^2]
    double poisson_ratio;

    MaterialResponse evaluate(const ThicknessPoint &p) const
    {
      const double factor = youngs_modulus / (1. - poisson_ratio * poisson_ratio);
      const SymmetricMap trace = outer_product(p.reference),
                         exchange = exchange_product(p.reference);
      MaterialResponse response;
      SymmetricMap &D = response.tangent;
      for (unsigned int i = 0; i < 6; ++i)
        D[i] = factor * (poisson_ratio * trace[i] + 0.5 * (1. - poisson_ratio) * exchange[i]);

      const Symmetric &E = p.strain;
      response.stress = {{D[0] * E[0] + D[1] * E[1] + D[2] * 2. * E[2],
                          D[1] * E[0] + D[3] * E[1] + D[4] * 2. * E[2],
                          D[2] * E[0] + D[4] * E[1] + D[5] * 2. * E[2]}};
      response.energy = 0.5 * contract(response.stress, E);
      return response;
    }
  };
} // namespace semilunar::shell

#endif
