// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_spline_t_junctions_h
#define semilunar_spline_t_junctions_h

#include <semilunar/spline/t_mesh.h>

namespace semilunar::spline
{
  /// All corners of active elements, each once, sorted by the second and then the first coordinate.
  std::vector<TMesh::Point> vertices(const TMesh &mesh);

  /// The coordinates of the next lines that a ray from the point along a direction meets, up to
  /// @p count, in the order in which it meets them; the boundary is repeated as often as asked for.
  std::vector<TMesh::Coordinate> next_lines(const TMesh &mesh, const TMesh::Point &point,
                                            unsigned int direction, int sign, unsigned int count);

  /// A vertex where an edge ends, and the extension of that edge, (T2).
  struct TJunction
  {
    TMesh::Point vertex;
    unsigned int direction; ///< of the edge that ends, and of its extension
    int sign;               ///< +1: an edge is missing on the side of larger coordinates
    /// Ends of the extension: across the faces ahead, and along the edge behind.
    TMesh::Coordinate ahead, behind;
  };

  std::vector<TJunction> t_junctions(const TMesh &mesh);

  /// Two T-junctions whose extensions meet, (T3).
  struct Crossing
  {
    TJunction first, second;
  };

  /// All pairs of a first and a second direction whose extensions meet, up to @p max_count: the
  /// mesh is analysis-suitable if there is none. Cost linear in the size of suitable meshes.
  std::vector<Crossing> crossings(const TMesh &mesh, unsigned int max_count = 1);

  /// @throws InputError naming @p source and the place of two extensions that meet, given in base
  /// elements counted from 0, unless the mesh is analysis-suitable
  void check_suitable(const TMesh &mesh, const std::string &source);
} // namespace semilunar::spline

#endif
