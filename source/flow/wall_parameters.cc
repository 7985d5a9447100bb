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
    const auto add =
        [this, &prm](const std::string &name, auto &value, const char *text, const auto &pattern)
    {
      prm.add_parameter(name, value, text, pattern);
      prm.add_action(name,
                     [this, name, &value, preset = value](const std::string &)
                     {
                       given = true;
                       if (value != preset)
                         changed = name;
                     });
    };
    add("Material", material,
        "neo-Hookean with a dilatational penalty, or St.Venant-Kirchhoff (small strains only)",
        Patterns::Selection("neo-Hookean|St.Venant-Kirchhoff"));
    add("Young's modulus", youngs_modulus, "[dyn/cm^2]", positive_number());
    add("Poisson ratio", poisson_ratio, "[-]", Patterns::Double(0., 0.499));
    add("Density", density, "[g/cm^3]", not_negative);
    add("Damping", damping,
        "Force per mass that brakes the wall, proportional to its velocity [1/s]", not_negative);
    add("Acceleration", acceleration, "Of gravity [cm/s^2]",
        Patterns::List(Patterns::Double(), 2, 3));
    add("Prestress", prestress,
        "Pressure of the blood, above that around the wall, under which the wall is at rest in the "
        "shape of the mesh; 0: it is free of stress there [mmHg]",
        Patterns::Double());
    add("Support stiffness", support_stiffness,
        "Of the tissue around the wall: force per area at rest and displacement, in addition to "
        "the tractions given there [dyn/cm^3]",
        not_negative);
    add("Support damping", support_damping,
        "Of this tissue: force per area at rest and velocity [dyn s/cm^3]", not_negative);
    add("Supported boundaries", supported,
        "Names of the boundaries of the wall that this tissue surrounds",
        Patterns::List(Patterns::Anything()));
    add("Prediction", prediction,
        "What the mesh of a step supposes of the wall's velocity: extrapolated from two old ones, "
        "or the old one, less accurate, for thin walls that a high pressure has stretched: they "
        "become unstable when the extrapolation overshoots",
        Patterns::Selection("extrapolated|old velocity"));
    add("Geometry iterations", max_geometry_iterations,
        "How often a step is solved with the mesh moved to where the wall has been found, at most; "
        "1: on the predicted positions alone",
        Patterns::Integer(1));
    add("Geometry tolerance", geometry_tolerance,
        "Distance of the found wall from the mesh at which these iterations end [cm]",
        positive_number());
    prm.leave_subsection();
    given = false; // adding an action calls it
  }

  void WallParameters::check(const unsigned int dim) const
  {
    if (acceleration.size() < dim)
      throw InputError("Wall/Acceleration", "", "a component is missing",
                       "give as many numbers as there are dimensions");
  }
} // namespace semilunar::flow
