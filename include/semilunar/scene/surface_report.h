// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_scene_surface_report_h
#define semilunar_scene_surface_report_h

#include <semilunar/core/run_context.h>
#include <semilunar/spline/surface.h>

namespace semilunar::scene
{
  /// What a user wants to know about a surface before computing with it.
  struct SurfaceReport
  {
    unsigned int n_elements = 0, n_control_points = 0, n_parts = 0;
    double area = 0.;
    /// Smallest ratio of the area element |a1 x a2| to its mean over the element: 1 for
    /// parallelograms, 0 where the parametrisation degenerates.
    double min_relative_jacobian = 0.;
    spline::Point<3> low, high; ///< corners of the bounding box (of the points looked at)
  };

  /// Measure with Gauss points (area, Jacobian) and a grid with element boundaries (box).
  SurfaceReport report(const spline::Surface &surface);

  void print(const SurfaceReport &report, Log &log);
  void add_quantities(const SurfaceReport &report, RunResults &results);
} // namespace semilunar::scene

#endif
