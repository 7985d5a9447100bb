// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_shell_materials_incompressible_h
#define semilunar_shell_materials_incompressible_h

#include <semilunar/shell/materials/material_response.h>

namespace semilunar::shell
{
  /// A strain energy psi(C_ab, C_33) and its derivatives, C_33 taken as independent of C_ab.
  struct EnergyDerivatives
  {
    double energy;
    Symmetric dC;       ///< dpsi / dC_ab
    double dC33;        ///< dpsi / dC_33
    SymmetricMap dC_dC; ///< d2psi / dC_ab dC_cd
    Symmetric dC_dC33;  ///< d2psi / dC_ab dC_33
    double dC33_dC33;   ///< d2psi / dC_33^2
  };

  /// Derivatives of an energy of the first invariant I1 = g0^ab C_ab + C_33, given dpsi/dI1 and
  /// d2psi/dI1^2 (M8).
  inline EnergyDerivatives energy_of_I1(const double energy, const double psi1, const double psi11,
                                        const ThicknessPoint &p)
  {
    EnergyDerivatives psi;
    psi.energy = energy;
    psi.dC33 = psi1;
    psi.dC33_dC33 = psi11;
    psi.dC_dC = outer_product(p.reference);
    for (double &component : psi.dC_dC)
      component *= psi11;
    for (unsigned int i = 0; i < 3; ++i)
    {
      psi.dC[i] = psi1 * p.reference[i];
      psi.dC_dC33[i] = psi11 * p.reference[i];
    }
    return psi;
  }

  /// Plane-stress law of an incompressible material: C_33 follows from J = 1, the pressure from S33
  /// = 0 (M6), (M7). The energy is a struct with a member `EnergyDerivatives derivatives(const
  /// ThicknessPoint &) const`.
  template <class Energy>
  struct Incompressible
  {
    static constexpr bool admits_any_deformation = false;

    Energy energy;

    MaterialResponse evaluate(const ThicknessPoint &p) const
    {
      const EnergyDerivatives psi = energy.derivatives(p);
      const double pressure = psi.dC33 * p.C33;
      const Symmetric &g = p.deformed;

      MaterialResponse response;
      response.energy = psi.energy;
      for (unsigned int i = 0; i < 3; ++i)
        response.stress[i] = 2. * (psi.dC[i] - pressure * g[i]);

      const SymmetricMap gg = outer_product(g), exchange = exchange_product(g),
                         mixed = symmetric_product(psi.dC_dC33, g);
      const double factor = 4. * (psi.dC33_dC33 * p.C33 * p.C33 + pressure);
      for (unsigned int i = 0; i < 6; ++i)
        response.tangent[i] =
            4. * (psi.dC_dC[i] - p.C33 * mixed[i]) + factor * gg[i] + 2. * pressure * exchange[i];
      return response;
    }
  };
} // namespace semilunar::shell

#endif
