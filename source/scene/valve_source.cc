// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/scene/valve_source.h>
#include <semilunar/valve/leaflets.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

namespace semilunar::scene
{
  void ValveSource::add_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Valve");
    design.add_parameters(prm);
    prm.add_parameter("Modelled leaflets", leaflets,
                      "all, or one that stands for all: the others are its images, turned about "
                      "the axis. Same answers for less, unless the leaflets move differently.",
                      dealii::Patterns::Selection("all|one"));
    prm.leave_subsection();
  }

  spline::Surface ValveSource::build() const
  {
    check();
    return leaflets == "one" ? valve::leaflet(design) : valve::leaflets(design);
  }

  void ValveSource::check() const
  {
    design.check();
    // a half turn maps an ellipse onto itself, a third of a turn does not
    if (leaflets == "one" && design.ellipticity != 1. && design.n_leaflets != 2)
      throw InputError("Valve/Modelled leaflets", leaflets,
                       "the leaflets of an oval stent differ from each other",
                       "choose all, or Ellipticity = 1");
  }

  unsigned int ValveSource::n_modelled() const
  {
    return leaflets == "one" ? 1 : design.n_leaflets;
  }

  unsigned int ValveSource::n_sectors() const
  {
    return leaflets == "one" ? design.n_leaflets : 1;
  }
} // namespace semilunar::scene
