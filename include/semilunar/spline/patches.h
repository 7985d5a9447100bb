// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_spline_patches_h
#define semilunar_spline_patches_h

#include <semilunar/spline/nurbs_patch.h>

namespace semilunar::spline
{
  /// Patches as one surface: raised to a common degree of at least @p degree, and joined where
  /// control points of edges are not farther than the tolerance from each other. No named sets but
  /// the element sets patch1, patch2, ...
  Surface join(std::vector<NurbsPatch> patches, unsigned int degree, double tolerance);

  /// Each Bezier element as a patch of its own, for surfaces that are not made of patches.
  std::vector<NurbsPatch> bezier_patches(const Surface &surface);
} // namespace semilunar::spline

#endif
