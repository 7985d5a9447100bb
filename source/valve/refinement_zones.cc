// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/valve/boundary_curves.h>
#include <semilunar/valve/refinement_zones.h>

#include <deal.II/base/parameter_handler.h>

#include <cmath>

namespace semilunar::valve
{
  namespace
  {
    namespace Patterns = dealii::Patterns;

    /// Elements smaller than a thousandth of the grid's serve nobody.
    constexpr unsigned int max_levels = 10;

    void add_zone(dealii::ParameterHandler &prm, const std::string &name, const std::string &place,
                  RefinementZone &zone)
    {
      prm.add_parameter(name + " levels", zone.levels,
                        "How often elements are halved in both directions " + place,
                        Patterns::Integer(0, max_levels));
      prm.add_parameter(name + " width", zone.width,
                        "How far from there elements are halved once [cm], half as far twice, and "
                        "so on; before expansion and ellipticity",
                        Patterns::Double(0.));
    }

    void check_zone(const std::string &entry, const RefinementZone &zone)
    {
      if (zone.levels > max_levels)
        throw InputError(entry + " levels", std::to_string(zone.levels), "too many",
                         "choose at most " + std::to_string(max_levels));
      if (zone.levels > 0 && !(zone.width > 0. && std::isfinite(zone.width)))
        throw InputError(entry + " width", std::to_string(zone.width), "leaves nothing to refine",
                         "choose a number > 0, or 0 levels");
    }
  } // namespace

  void RefinementZones::add_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("T-spline");
    prm.add_parameter("Elements along", n_elements_along,
                      "Elements of the unrefined grid from commissure to commissure, even, >= 8",
                      Patterns::Integer(n_base_elements));
    prm.add_parameter("Elements across", n_elements_across,
                      "Elements of the unrefined grid from attachment to free edge, >= 1",
                      Patterns::Integer(1));
    add_zone(prm, "Attachment", "along the attachment edge (posts and scallop)", attachment);
    add_zone(prm, "Commissure", "around the upper ends of the posts", commissures);
    add_zone(prm, "Free edge", "along the free edge, where leaflets coapt", free_edge);
    prm.add_parameter("Sizes file", sizes_file,
                      "The elements.csv of a run that refined leaflets by need (section Adaptivity "
                      "of valve statics): elements are halved until none is larger than those "
                      "there. None if empty",
                      Patterns::FileName());
    prm.leave_subsection();
  }

  void RefinementZones::check(const std::string &section) const
  {
    if (n_elements_along < n_base_elements || n_elements_along % 2 != 0)
      throw InputError(section + "/Elements along", std::to_string(n_elements_along),
                       n_elements_along % 2 != 0 ? "the mesh would not be symmetric"
                                                 : "too few to describe the shape",
                       "choose an even number, at least " + std::to_string(n_base_elements));
    if (n_elements_across < 1)
      throw InputError(section + "/Elements across", "0", "no elements", "choose at least 1");
    check_zone(section + "/Attachment", attachment);
    check_zone(section + "/Commissure", commissures);
    check_zone(section + "/Free edge", free_edge);
  }
} // namespace semilunar::valve
