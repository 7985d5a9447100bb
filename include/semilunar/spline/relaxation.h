// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_spline_relaxation_h
#define semilunar_spline_relaxation_h

#include <semilunar/spline/quad_mesh.h>
#include <semilunar/spline/surface.h>

namespace semilunar::spline
{
  /// Move each inner vertex of a plane mesh to the mean of its neighbours, by relaxation; the
  /// boundary stays. Shapes then change slowly from face to face, which analysis needs: where a net
  /// has a kink, the surface has large second derivatives.
  void relax(const QuadMesh &mesh, std::vector<Point<2>> &places);
} // namespace semilunar::spline

#endif
