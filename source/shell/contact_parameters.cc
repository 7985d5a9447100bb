// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/parameters.h>
#include <semilunar/shell/contact.h>

namespace semilunar::shell
{
  void ContactParameters::add_parameters(dealii::ParameterHandler &prm)
  {
    const dealii::Patterns::Double not_negative(0.);
    prm.enter_subsection("Contact");
    prm.add_parameter("Enabled", enabled,
                      "Whether parts of the surface that share no control point repel each other");
    prm.add_parameter("Distance", distance,
                      "Midsurfaces repel each other below this distance; parts closer than that "
                      "before deformation do so below their undeformed distance [cm], > 0",
                      positive_number());
    prm.add_parameter("Stiffness", stiffness, "Pressure per penetration [dyn/cm^3], > 0",
                      positive_number());
    prm.add_parameter("Smoothing", smoothing,
                      "Penetration over which the stiffness sets in [cm], >= 0", not_negative);
    prm.add_parameter("Self distance", self_distance,
                      "Points of one part repel each other if they were farther apart than this "
                      "before deformation [cm], 0 (never) or at least the distance",
                      not_negative);
    prm.leave_subsection();
  }
} // namespace semilunar::shell
