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
} // namespace semilunar::spline

#endif
