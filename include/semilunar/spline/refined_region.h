// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_spline_refined_region_h
#define semilunar_spline_refined_region_h

#include <semilunar/spline/quad_mesh.h>
#include <semilunar/spline/t_spline.h>

namespace semilunar::spline
{
  /// Faces of an unstructured mesh that form a grid, in which T-junctions may be.
  struct GridRegion
  {
    QuadMesh::TurnedFace origin;   ///< the face at the grid's (0,0)
    std::array<unsigned int, 2> n; ///< faces to the right and up from there
  };

  /// Refine a spline on an unstructured mesh inside of a region of regular faces as a T-mesh, (U9);
  /// the surface does not change.
  /// @param surface  to_surface() of the mesh, element f that of face f. Afterwards the elements of
  /// one face follow each other, in the order of the faces; control points keep their numbers, new
  /// ones follow. Named sets are dropped.
  /// @param wanted  asked for T-mesh elements with corners in units of faces from the grid's origin
  /// @throws InputError naming @p source if the region is no grid of regular faces, or if functions
  /// that refinement changes reach beyond it: keep about five faces away from those of its edges
  /// that are inside of the mesh
  void refine_region(const QuadMesh &mesh, const GridRegion &region, const TSpline::Wanted &wanted,
                     Surface &surface, const std::string &source = "refined region");
} // namespace semilunar::spline

#endif
