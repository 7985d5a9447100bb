// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_spline_unstructured_functions_h
#define semilunar_spline_unstructured_functions_h

#include <semilunar/spline/quad_mesh.h>
#include <semilunar/spline/surface.h>

namespace semilunar::spline
{
  /// The functions of cubic splines on an unstructured mesh with uniform knots and clamped
  /// boundary: one for each inner vertex, two for a boundary vertex (the first vanishes on the
  /// boundary), four for a corner. (U1)
  class UnstructuredFunctions
  {
  public:
    explicit UnstructuredFunctions(const QuadMesh &mesh);

    unsigned int size() const { return n; }

    /// The function of a vertex that belongs to this corner of a face; @p shifts as in
    /// BlendingFunction, for the directions of the turned face that has the vertex at (0,0).
    unsigned int number(const QuadMesh::TurnedFace &corner,
                        const std::array<unsigned int, 2> &shifts) const;

    /// The functions of a vertex, those that vanish on the boundary first.
    std::vector<unsigned int> at(unsigned int vertex) const;

  private:
    const QuadMesh &mesh;
    std::vector<unsigned int> first;
    unsigned int n = 0;
  };

  /// A control net with the vertices at these places: as the abscissae of B-splines with clamped
  /// ends are, the control points next to the boundary lie a third of a face away from it. Weights
  /// are one.
  std::vector<ControlPoint> clamped_net(const QuadMesh &mesh, const std::vector<Point<3>> &places);
} // namespace semilunar::spline

#endif
