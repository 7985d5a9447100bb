// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_valve_refine_h
#define semilunar_valve_refine_h

#include <semilunar/spline/nurbs_patch.h>

namespace semilunar::valve
{
  /// Refine a patch to this many elements in a direction without changing the surface. From 16
  /// elements on, doubling their number halves each: the meshes are nested.
  void refine(spline::NurbsPatch &patch, unsigned int direction, unsigned int n_elements);
} // namespace semilunar::valve

#endif
