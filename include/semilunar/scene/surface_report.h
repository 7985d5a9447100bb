// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_scene_surface_report_h
#define semilunar_scene_surface_report_h

#include <semilunar/core/run_context.h>
#include <semilunar/spline/surface_edges.h>

#include <limits>

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
    double min_angle = 0.; ///< between the parameter lines, at most 90 [degree]
    spline::Jumps jumps;
    unsigned int n_boundary_edges = 0, n_extraordinary_points = 0;
    /// Edges of the boundary that lie on each other without sharing control points: open seams.
    unsigned int n_seams = 0;
    /// Largest distance of the node set attachment's edges from the stent; NaN without both.
    double attachment_gap = std::numeric_limits<double>::quiet_NaN();
    std::vector<std::pair<std::string, unsigned int>> set_sizes; ///< of element sets
    spline::Point<3> low, high; ///< corners of the bounding box (of the points looked at)
  };

  /// Measure with Gauss points (area, Jacobian, angle), a grid with element boundaries (box) and
  /// points of all edges (jumps, seams).
  SurfaceReport report(const spline::Surface &surface);

  void print(const SurfaceReport &report, Log &log);
  void add_quantities(const SurfaceReport &report, RunResults &results);
} // namespace semilunar::scene

#endif
