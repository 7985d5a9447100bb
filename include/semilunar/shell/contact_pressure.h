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

    /// Mean of the pressure while the penetration goes from one value to another, (D18) of
    /// doc/theory/dynamics.md: times the way it is exactly the change of energy.
    double mean(const double from, const double to) const
    {
      if (is_short(from, to)) // Simpson's rule: exact, and free of cancellation
        return (value(from) + 4. * value(0.5 * (from + to)) + value(to)) / 6.;
      return (energy(to) - energy(from)) / (to - from);
    }

    /// d mean / d to.
    double mean_slope(const double from, const double to) const
    {
      if (is_short(from, to))
        return (2. * slope(0.5 * (from + to)) + slope(to)) / 6.;
      return (value(to) - mean(from, to)) / (to - from);
    }

  private:
    bool is_short(const double from, const double to) const
    {
      constexpr double negligible = 1e-5;
      const double way = to > from ? to - from : from - to;
      return way <= negligible * (smoothing + (from < 0. ? -from : from));
    }
  };
} // namespace semilunar::shell

#endif
