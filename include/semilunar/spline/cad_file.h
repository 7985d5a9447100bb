// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_spline_cad_file_h
#define semilunar_spline_cad_file_h

#include <semilunar/spline/nurbs_patch.h>

namespace semilunar::spline
{
  /// Whether the name ends as STEP (.step, .stp) or IGES files (.iges, .igs) do.
  bool is_cad_file(const std::string &filename);

  /// The faces of a STEP or IGES file as NURBS patches, converted to that where they are planes,
  /// cylinders and so on; normals point as the file's faces do. Lengths are converted from the
  /// file's unit to cm.
  /// @throws InputError naming the file for anything but faces that are bounded by parameter lines
  std::vector<NurbsPatch> read_cad(const std::string &filename);

  /// Write patches as faces of a STEP or IGES file; lengths in cm become the millimetres of the file.
  /// @throws InputError if the file cannot be written
  void write_cad(const std::vector<NurbsPatch> &patches, const std::string &filename);

  /// Patches as one surface: raised to a common degree of at least @p degree, and joined where
  /// control points of edges are not farther than the tolerance from each other. No named sets but
  /// the element sets patch1, patch2, ...
  Surface join(std::vector<NurbsPatch> patches, unsigned int degree, double tolerance);

  /// Each Bezier element as a patch of its own, for surfaces that are not made of patches.
  std::vector<NurbsPatch> bezier_patches(const Surface &surface);
} // namespace semilunar::spline

#endif
