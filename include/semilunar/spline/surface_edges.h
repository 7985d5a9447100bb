// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_spline_surface_edges_h
#define semilunar_spline_surface_edges_h

#include <semilunar/spline/boundary_rows.h>

namespace semilunar::spline
{
  /// Two sides that lie on each other, wholly or where the shorter one is.
  struct SharedEdge
  {
    ElementSide first, second; ///< the first is not longer than the second
  };

  /// What bounds the elements of a surface: sides that elements share, and the boundary.
  struct SurfaceEdges
  {
    std::vector<SharedEdge> shared;
    std::vector<ElementSide> boundary;
  };

  /// From the functions that live on each side: elements on both sides of an edge see the same.
  SurfaceEdges edges(const Surface &surface);

  /// How smoothly a surface crosses the edges that elements share.
  struct Jumps
  {
    double position = 0.;     ///< largest distance, relative to the extent of the surface
    double normal = 0.;       ///< largest angle of normals where the surface is smooth [rad]
    unsigned int n_kinks = 0; ///< edges where the angle exceeds kink_angle
  };
  constexpr double kink_angle = 1e-6;

  Jumps jumps(const Surface &surface, const SurfaceEdges &edges);

  /// The number of inner vertices of the elements where other than four of them meet, counted with
  /// half circles of elements that do not end there as two.
  unsigned int n_extraordinary_points(const Surface &surface, const SurfaceEdges &edges);
} // namespace semilunar::spline

#endif
