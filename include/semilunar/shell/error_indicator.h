// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_shell_error_indicator_h
#define semilunar_shell_error_indicator_h

#include <semilunar/shell/assembly.h>
#include <semilunar/shell/contact.h>

namespace semilunar::shell
{
  /// What acts on a shell in the state whose error is asked for.
  struct ActingLoads
  {
    double pressure = 0.;              ///< follower pressure
    spline::Tensor<1, 3> dead_load;    ///< on the undeformed area [force/area]
    const Contact *contact = nullptr;  ///< updated with the state
    spline::CyclicSymmetry symmetry{}; ///< that of the contact
  };

  /// The square of the error in the energy norm that each element has in an equilibrium with
  /// control points at x: the energy that bubble functions on the element would gain, times two,
  /// (A2) of doc/theory/adaptivity.md. For linear problems the sum is a lower bound of the
  /// square of the error, but for quadrature. Knows nothing of how the elements hang together.
  std::vector<double> error_indicators(const spline::Surface &surface,
                                       const QuadraturePoints &points, const Section &section,
                                       const Assembly &assembly, const ControlVectors &x,
                                       const ActingLoads &loads);

  /// The fewest elements whose indicators have this share of the sum, in ascending order; elements
  /// as bad as the last of them, but for rounding, belong to them: (A4).
  /// @param share in (0, 1]
  std::vector<unsigned int> mark_elements(const std::vector<double> &indicators, double share);
} // namespace semilunar::shell

#endif
