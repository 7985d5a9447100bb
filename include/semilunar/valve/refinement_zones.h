// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_valve_refinement_zones_h
#define semilunar_valve_refinement_zones_h

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace semilunar::valve
{
  /// A part of a leaflet near an edge or a point of it, where elements are halved in both
  /// directions `levels` times: the first time within `width` of the edge, then within half of
  /// that, and so on.
  struct RefinementZone
  {
    unsigned int levels;
    double width; ///< [cm] in the design's configuration
  };

  /// The T-spline layout of a leaflet: a grid of elements and where it is refined.
  struct RefinementZones
  {
    unsigned int n_elements_along = 14;  ///< of the grid, from commissure to commissure
    unsigned int n_elements_across = 10; ///< of the grid, from attachment to free edge
    RefinementZone attachment{1, 0.1};   ///< posts and scallop
    RefinementZone commissures{2, 0.3};
    RefinementZone free_edge{0, 0.2};
    std::string sizes_file; ///< of ElementSizes to refine to as well; none if empty

    /// Declare and bind the entries in a section T-spline.
    void add_parameters(dealii::ParameterHandler &prm);

    /// @param section where the entries stand @throws InputError naming the entry
    void check(const std::string &section) const;
  };
} // namespace semilunar::valve

#endif
