// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_spline_iga_file_h
#define semilunar_spline_iga_file_h

#include <semilunar/spline/surface.h>

namespace semilunar::spline
{
  /// Read a surface from an .iga text file (Bezier extraction as written by spline modelling
  /// plug-ins), with all coordinates multiplied by @p scale.
  /// @throws InputError naming file and line for anything that is missing, out of range or not
  /// finite, and for elements whose functions do not sum to one.
  Surface read_iga(const std::string &filename, double scale = 1.);

  /// Write so that reading gives back every bit.
  void write_iga(const Surface &surface, const std::string &filename);
} // namespace semilunar::spline

#endif
