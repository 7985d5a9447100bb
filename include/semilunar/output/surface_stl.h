// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_output_surface_stl_h
#define semilunar_output_surface_stl_h

#include <semilunar/spline/surface.h>

#include <string>

namespace semilunar::output
{
  /// Write a surface as a binary STL file: each element divided into n x n pairs of triangles,
  /// oriented as the surface is.
  /// @throws InputError if the file cannot be written
  void write_stl(const spline::Surface &surface, const std::string &filename, unsigned int n);
} // namespace semilunar::output

#endif
