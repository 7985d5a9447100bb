// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_spline_unstructured_spline_h
#define semilunar_spline_unstructured_spline_h

#include <semilunar/spline/unstructured_functions.h>

namespace semilunar::spline
{
  /// Bezier elements of the spline, one for each face in their order: C2 bicubic, and where a
  /// corner is extraordinary biquintic and G1, (U2) to (U7).
  /// @param own_functions  make all coefficients that the smoothness conditions leave free control
  /// points, (U8). This does not change the surface but makes analysis more accurate; the new
  /// control points follow those of the vertices.
  Surface to_surface(const QuadMesh &mesh, std::vector<ControlPoint> control_points,
                     bool own_functions = true);
} // namespace semilunar::spline

#endif
