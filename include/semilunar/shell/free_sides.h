// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_shell_free_sides_h
#define semilunar_shell_free_sides_h

#include <semilunar/spline/surface.h>

namespace semilunar::shell
{
  /// Which sides of each element are edges of the surface, in the order xi_1 = 0, xi_1 = 1, xi_2 =
  /// 0, xi_2 = 1: those whose midpoint is on no other element. Works from the geometry, as elements
  /// know no neighbors and may meet in T-junctions; a seam of coincident sides is no edge.
  std::vector<std::array<bool, 4>> free_sides(const spline::Surface &surface);
} // namespace semilunar::shell

#endif
