// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_valve_orifice_h
#define semilunar_valve_orifice_h

#include <semilunar/spline/evaluation.h>

namespace semilunar::valve
{
  /// Area of the disc r < radius in the xy plane that no leaflet covers, seen along the flow axis:
  /// the geometric orifice area. Leaflets cover what lies within half a thickness of their
  /// projected midsurface. Measured on a raster of orifice_pixels x orifice_pixels over the disc's
  /// bounding square.
  /// @param control_vectors positions of all control points [cm]
  /// @return area [cm^2]
  double orifice_area(const spline::Surface &leaflets,
                      const std::vector<spline::Tensor<1, 3>> &control_vectors, double radius,
                      double thickness);

  constexpr unsigned int orifice_pixels = 1000;
} // namespace semilunar::valve

#endif
