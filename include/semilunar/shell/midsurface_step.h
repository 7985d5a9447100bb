// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_shell_midsurface_step_h
#define semilunar_shell_midsurface_step_h

#include <semilunar/shell/midsurface_point.h>

namespace semilunar::shell
{
  /// The energy-momentum method at a point of the midsurface, (D13) to (D17): a force on the jet
  /// whose work on the way from one jet to another is exactly the change of the strain energy, and
  /// which has no resultant and no moment about the middle of the two. As the ends approach each
  /// other it becomes the gradient of strain_response(), with an error of second order.
  /// @param gradient of the jet r, r_,1, r_,2, r_,11, r_,22, r_,12; per undeformed area
  void conserving_gradient(const Section &section, const spline::SurfaceJet &from,
                           const spline::SurfaceJet &to, const Symmetric &b0,
                           const std::array<double, 2> &fibre,
                           double (&gradient)[spline::n_derivatives][3]);
} // namespace semilunar::shell

#endif
