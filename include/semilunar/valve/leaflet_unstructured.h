// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_valve_leaflet_unstructured_h
#define semilunar_valve_leaflet_unstructured_h

#include <semilunar/spline/surface.h>
#include <semilunar/valve/design.h>

namespace semilunar::valve
{
  /// The first leaflet on an unstructured mesh, (V11): layers of elements run along the whole
  /// attachment edge, post, scallop and post, around a core that ends at the free edge; where they
  /// turn are two extraordinary points of valence 3. Fitted to leaflet_patch(); only at the post
  /// feet, where the attachment has a corner, is the smooth edge a little off. Node sets as
  /// leaflets() but those of whole leaflets.
  /// @throws InputError from Design::check()
  spline::Surface leaflet_unstructured(const Design &design);
} // namespace semilunar::valve

#endif
