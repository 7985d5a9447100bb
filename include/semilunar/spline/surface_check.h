// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_spline_surface_check_h
#define semilunar_spline_surface_check_h

#include <semilunar/spline/surface.h>

#include <optional>

namespace semilunar::spline
{
  /// How far the functions N of an element may sum to something other than one. Exact T-splines of
  /// standard and semi-standard T-meshes need round-off only, but the plug-ins' files contain
  /// elements near crossing T-junctions and extraordinary points whose sums are off by up to 0.0200
  /// (measured over ten such files). Their rational functions R sum to one all the same (S4), so
  /// the surface is sound. A larger deviation means that a function is missing or a number is
  /// wrong.
  constexpr double partition_of_unity_tolerance = 0.05;

  /// What is wrong with a surface, and where.
  struct SurfaceDefect
  {
    enum Place
    {
      control_point,
      element,
      set
    } place;
    unsigned int index; ///< of the control point, element or set
    std::string value, problem, remedy;
  };

  /// The first thing that spline::check() would complain about. One pass over all numbers.
  std::optional<SurfaceDefect> first_defect(const Surface &surface);
} // namespace semilunar::spline

#endif
