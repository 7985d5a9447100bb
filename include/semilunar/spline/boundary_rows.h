// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_spline_boundary_rows_h
#define semilunar_spline_boundary_rows_h

#include <semilunar/spline/surface.h>

namespace semilunar::spline
{
  /// A side of an element: 0 is xi_1 = 0, 1 is xi_1 = 1, 2 is xi_2 = 0, 3 is xi_2 = 1.
  struct ElementSide
  {
    unsigned int element;
    unsigned int side;
  };

  /// The control points of an element whose functions do not vanish on the side (row 0), or vanish
  /// there while their derivative across the side does not (row 1): moving row 0 moves the edge,
  /// moving row 1 turns the surface about it.
  std::vector<unsigned int> control_row(const BezierElement &element, unsigned int side,
                                        unsigned int row);

  /// All sides that belong to one element only.
  std::vector<ElementSide> boundary_sides(const Surface &surface);

  /// The boundary sides whose row 0 lies wholly among the given control points.
  std::vector<ElementSide> boundary_sides(const Surface &surface,
                                          const std::vector<unsigned int> &control_points);

  /// The control points of row 0 or 1 of all these sides, sorted, each once; row 1 leaves out what
  /// is in row 0 of another side (corners).
  std::vector<unsigned int> control_row(const Surface &surface,
                                        const std::vector<ElementSide> &sides, unsigned int row);
} // namespace semilunar::spline

#endif
