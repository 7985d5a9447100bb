// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_shell_contact_pressure_h
#define semilunar_shell_contact_pressure_h

namespace semilunar::shell
{
  /// The pressure by which midsurfaces repel each other as a function of the penetration, which is
  /// the negative gap: zero when apart, quadratic onset, then linear; (C3) of
  /// doc/theory/contact.md.
  struct ContactPressure
  {
    double stiffness; ///< pressure per length, > 0
    double smoothing; ///< length of the onset, >= 0

    /// Pressure p.
    double value(const double penetration) const
    {
      if (penetration <= 0.)
        return 0.;
      if (penetration < smoothing)
        return stiffness * penetration * penetration / (2. * smoothing);
      return stiffness * (penetration - 0.5 * smoothing);
    }

    /// dp / d penetration.
    double slope(const double penetration) const
    {
      if (penetration <= 0.)
        return 0.;
      return penetration < smoothing ? stiffness * penetration / smoothing : stiffness;
    }

    /// Energy per area: the integral of p from zero.
    double energy(const double penetration) const
    {
      if (penetration <= 0.)
        return 0.;
      if (penetration < smoothing)
        return stiffness * penetration * penetration * penetration / (6. * smoothing);
      return stiffness *
             (penetration * (penetration - smoothing) / 2. + smoothing * smoothing / 6.);
    }
  };
} // namespace semilunar::shell

#endif
