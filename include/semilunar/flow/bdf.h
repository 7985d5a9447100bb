// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_flow_bdf_h
#define semilunar_flow_bdf_h

namespace semilunar::flow
{
  /// Backward differentiation of order 1 or 2 with variable step, equations (7) and (8) of
  /// doc/theory/flow.md: dy/dt at the new time is alpha[0] y_new + alpha[1] y_old +
  /// alpha[2] y_older.
  struct Bdf
  {
    double dt = 0.;            ///< s
    double alpha[3] = {};      ///< 1/s
    double extrapolation = 0.; ///< y at the new time is about y_old + this (y_old - y_older)

    static Bdf first_order(double dt);
    /// @param dt_old the step before
    static Bdf second_order(double dt, double dt_old);
  };

  inline Bdf Bdf::first_order(const double dt)
  {
    return {dt, {1. / dt, -1. / dt, 0.}, 0.};
  }

  inline Bdf Bdf::second_order(const double dt, const double dt_old)
  {
    const double ratio = dt / dt_old;
    return {dt,
            {(1. + 2. * ratio) / (1. + ratio) / dt, -(1. + ratio) / dt,
             ratio * ratio / (1. + ratio) / dt},
            ratio};
  }
} // namespace semilunar::flow

#endif
