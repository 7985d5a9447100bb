// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_shell_materials_lee_sacks_h
#define semilunar_shell_materials_lee_sacks_h

#include <semilunar/shell/materials/incompressible.h>

#include <cmath>

namespace semilunar::shell
{
  /// psi = c0/2 (I1 - 3) + c1/2 (w exp(c2 (I1 - 3)^2) + (1 - w) exp(c3 (I4 - 1)^2) - 1), with I4 =
  /// m . C m the squared stretch of the fibres (M12). The fibres stiffen in tension and in
  /// compression.
  struct LeeSacksEnergy
  {
    double c0; ///< [dyn/cm^2]
    double c1; ///< [dyn/cm^2]
    double c2; ///< dimensionless
    double c3; ///< dimensionless
    double w;  ///< isotropic share, 0 <= w <= 1

    EnergyDerivatives derivatives(const ThicknessPoint &p) const
    {
      const Symmetric &M = p.fibre_dyad;
      const double excess = p.I1_minus_3(), excess4 = 2. * contract(M, p.strain); // I1 - 3, I4 - 1
      const double exponent = c2 * excess * excess, exponent4 = c3 * excess4 * excess4;
      const double exponential = share_exp(w, exponent),
                   exponential4 = share_exp(1. - w, exponent4);
      const double stiffness = c1 * c2 * exponential, stiffness4 = c1 * c3 * exponential4;

      EnergyDerivatives psi =
          energy_of_I1(0.5 * (c0 * excess + c1 * (exponential + exponential4 - 1.)),
                       0.5 * c0 + stiffness * excess, stiffness * (1. + 2. * exponent), p);
      const SymmetricMap MM = outer_product(M);
      for (unsigned int i = 0; i < 3; ++i)
        psi.dC[i] += stiffness4 * excess4 * M[i];
      for (unsigned int i = 0; i < 6; ++i)
        psi.dC_dC[i] += stiffness4 * (1. + 2. * exponent4) * MM[i];
      return psi;
    }

  private:
    /// A term without a share must not overflow: 0 times infinity is not zero.
    static double share_exp(const double share, const double exponent)
    {
      return share > 0. ? share * std::exp(exponent) : 0.;
    }
  };

  using LeeSacks = Incompressible<LeeSacksEnergy>;
} // namespace semilunar::shell

#endif
