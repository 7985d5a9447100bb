// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_shell_materials_thickness_point_h
#define semilunar_shell_materials_thickness_point_h

#include <semilunar/shell/materials/symmetric_tensors.h>

namespace semilunar::shell
{
  /// What a material law needs to know at distance xi from the midsurface (M1)-(M4). Components
  /// refer to the convected basis whose undeformed metric is g0_ab = delta_ab - 2 xi b0_ab.
  struct ThicknessPoint
  {
    Symmetric reference;        ///< contravariant undeformed metric g0^ab
    Symmetric deformed;         ///< contravariant deformed metric g^ab
    Symmetric strain;           ///< Green-Lagrange strain E_ab
    double trace;               ///< x = 2 g0^ab E_ab
    double determinant;         ///< y = det(2 E_ab) / det(g0_ab)
    double C33;                 ///< thickness stretch squared, 1 / (1 + x + y) if incompressible
    Symmetric fibre_dyad;       ///< m^a m^b, m the fibre direction with g0_ab m^a m^b = 1
    bool undeformed_admissible; ///< whether g0_ab is positive definite
    bool deformed_admissible;   ///< whether g_ab is

    /// First invariant of C minus 3, free of cancellation at small strain (M5).
    double I1_minus_3() const { return (trace * trace + (trace - 1.) * determinant) * C33; }

    /// Second invariant of C minus 3, likewise (M5).
    double I2_minus_3() const
    {
      const double change = trace + determinant;
      return (change * change - determinant) * C33;
    }
  };

  inline ThicknessPoint thickness_point(const SectionStrain &section, const double xi)
  {
    ThicknessPoint p;
    const Symmetric &a = section.a, &b = section.b, &b0 = section.b0;
    const Symmetric g0{{1. - 2. * xi * b0[0], 1. - 2. * xi * b0[1], -2. * xi * b0[2]}};
    const Symmetric E{{0.5 * (a[0] - 1.) - xi * (b[0] - b0[0]),
                       0.5 * (a[1] - 1.) - xi * (b[1] - b0[1]), 0.5 * a[2] - xi * (b[2] - b0[2])}};
    const Symmetric C{{g0[0] + 2. * E[0], g0[1] + 2. * E[1], g0[2] + 2. * E[2]}};

    const double det0 = determinant(g0), factor0 = 1. / det0;
    p.reference = {{g0[1] * factor0, g0[0] * factor0, -g0[2] * factor0}};
    p.strain = E;
    p.trace = 2. * contract(p.reference, E);
    p.determinant = 4. * determinant(E) * factor0;
    const double area_squared = 1. + p.trace + p.determinant;
    p.C33 = 1. / area_squared;
    const double factor = p.C33 * factor0;
    p.deformed = {{C[1] * factor, C[0] * factor, -C[2] * factor}};

    const auto &m = section.fibre;
    const Symmetric dyad{{m[0] * m[0], m[1] * m[1], m[0] * m[1]}};
    const double length_squared = contract(dyad, g0);
    p.fibre_dyad = {{dyad[0] / length_squared, dyad[1] / length_squared, dyad[2] / length_squared}};
    p.undeformed_admissible = g0[0] > 0. && det0 > 0.;
    p.deformed_admissible = C[0] > 0. && area_squared > 0.;
    return p;
  }
} // namespace semilunar::shell

#endif
