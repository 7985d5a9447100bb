// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/core/parameters.h>
#include <semilunar/flow/wall_parameters.h>

#include <deal.II/base/parameter_handler.h>

namespace semilunar::flow
{
  namespace Patterns = dealii::Patterns;

  void WallParameters::add_parameters(dealii::ParameterHandler &prm)
  {
    const Patterns::Double not_negative(0.);
    prm.enter_subsection("Wall");
    prm.add_parameter("Material", material,
                      "neo-Hookean with a dilatational penalty, or St.Venant-Kirchhoff (small "
                      "strains only)",
                      Patterns::Selection("neo-Hookean|St.Venant-Kirchhoff"));
    prm.add_parameter("Young's modulus", youngs_modulus, "[dyn/cm^2]", positive_number());
    prm.add_parameter("Poisson ratio", poisson_ratio, "[-]", Patterns::Double(0., 0.499));
    prm.add_parameter("Density", density, "[g/cm^3]", not_negative);
    prm.add_parameter("Damping", damping,
                      "Force per mass that brakes the wall, proportional to its velocity [1/s]",
                      not_negative);
    prm.add_parameter("Acceleration", acceleration, "Of gravity [cm/s^2]",
                      Patterns::List(Patterns::Double(), 2, 3));
    prm.add_parameter("Geometry iterations", max_geometry_iterations,
                      "How often a step is solved with the mesh moved to where the wall has been "
                      "found, at most; 1: on the predicted positions alone",
                      Patterns::Integer(1));
    prm.add_parameter("Geometry tolerance", geometry_tolerance,
                      "Distance of the found wall from the mesh at which these iterations end "
                      "[cm]",
                      positive_number());
    prm.leave_subsection();
  }

  void WallParameters::check(const unsigned int dim) const
  {
    if (acceleration.size() < dim)
      throw InputError("Wall/Acceleration", "", "a component is missing",
                       "give as many numbers as there are dimensions");
  }
} // namespace semilunar::flow
