// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_scene_valve_source_h
#define semilunar_scene_valve_source_h

#include <semilunar/spline/surface.h>
#include <semilunar/valve/design.h>

namespace semilunar::scene
{
  /// The leaflets of a valve design, all of them or one that stands for all.
  struct ValveSource
  {
    valve::Design design;
    std::string leaflets = "all";

    /// Declare the section Valve.
    void add_parameters(dealii::ParameterHandler &prm);

    /// @throws InputError for a design that no valve can have, or whose leaflets differ from the
    /// one that is to stand for all
    void check() const;
    spline::Surface build() const;
    /// Leaflets that the surface has.
    unsigned int n_modelled() const;
    /// Of the symmetry that one leaflet stands for; 1 if all are modelled.
    unsigned int n_sectors() const;
  };
} // namespace semilunar::scene

#endif
