// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/scene/surface_report.h>
#include <semilunar/spline/closest_point.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <sstream>

namespace semilunar::scene
{
  namespace
  {
    void include(const spline::Tensor<1, 3> &x, SurfaceReport &report)
    {
      for (unsigned int d = 0; d < 3; ++d)
      {
        report.low[d] = std::min(report.low[d], x[d]);
        report.high[d] = std::max(report.high[d], x[d]);
      }
    }

    void measure_element(const spline::Surface &surface, const unsigned int element,
                         SurfaceReport &report)
    {
      const std::array<unsigned int, 2> &degree = surface.elements[element].degree;
      const dealii::QGauss<2> gauss(std::max(degree[0], degree[1]) + 2);
      double area = 0.;
      double smallest = std::numeric_limits<double>::max();
      for (unsigned int q = 0; q < gauss.size(); ++q)
      {
        const spline::SurfaceJet jet = spline::evaluate(surface, {element, gauss.point(q)});
        const double jacobian = cross_product_3d(jet[spline::d1], jet[spline::d2]).norm();
        const double sine = jacobian / (jet[spline::d1].norm() * jet[spline::d2].norm());
        report.min_angle =
            std::min(report.min_angle, std::asin(std::min(1., sine)) * 180. / dealii::numbers::PI);
        area += gauss.weight(q) * jacobian;
        smallest = std::min(smallest, jacobian);
      }
      report.area += area;
      report.min_relative_jacobian =
          std::min(report.min_relative_jacobian, area > 0. ? smallest / area : 0.);

      constexpr unsigned int n = 4; // intervals per direction
      for (unsigned int j = 0; j <= n; ++j)
        for (unsigned int i = 0; i <= n; ++i)
          include(spline::evaluate(surface, {element, spline::Point<2>(1. * i / n, 1. * j / n)})[0],
                  report);
    }

    spline::Tensor<1, 3> middle(const spline::Surface &surface, const spline::ElementSide &side)
    {
      spline::Point<2> xi(0.5, 0.5);
      xi[side.side / 2] = side.side % 2;
      return spline::evaluate(surface, {side.element, xi})[spline::value];
    }

    /// Pairs of boundary edges whose middles coincide.
    unsigned int count_seams(const spline::Surface &surface,
                             const std::vector<spline::ElementSide> &boundary, const double extent)
    {
      constexpr double coincident = 1e-6; // of the extent
      using Cell = std::array<long, 3>;
      std::multimap<Cell, spline::Tensor<1, 3>> seen;
      const double size = coincident * extent;
      unsigned int n = 0;
      for (const spline::ElementSide &side : boundary)
      {
        const spline::Tensor<1, 3> x = middle(surface, side);
        const Cell cell{
            {std::lround(x[0] / size), std::lround(x[1] / size), std::lround(x[2] / size)}};
        for (long i = -1; i <= 1; ++i)
          for (long j = -1; j <= 1; ++j)
            for (long k = -1; k <= 1; ++k)
            {
              const auto [begin, end] = seen.equal_range({{cell[0] + i, cell[1] + j, cell[2] + k}});
              n += std::count_if(
                  begin, end, [&](const auto &other) { return (other.second - x).norm() <= size; });
            }
        seen.emplace(cell, x);
      }
      return n;
    }

    /// How far the leaflets' attachment edges lie from wall and posts.
    double attachment_gap(const spline::Surface &surface,
                          const std::vector<spline::ElementSide> &boundary)
    {
      const auto *attachment = surface.find_set(spline::SetKind::node, "attachment");
      const auto *wall = surface.find_set(spline::SetKind::element, "wall");
      const auto *posts = surface.find_set(spline::SetKind::element, "posts");
      if (attachment == nullptr || wall == nullptr || posts == nullptr)
        return std::numeric_limits<double>::quiet_NaN();
      spline::Surface stent;
      stent.control_points = surface.control_points;
      for (const auto *set : {wall, posts})
        for (const unsigned int e : set->members)
          stent.elements.push_back(surface.elements[e]);
      const std::set<unsigned int> attached(attachment->members.begin(), attachment->members.end());
      const auto vectors = spline::positions(stent);
      double gap = 0.;
      for (const spline::ElementSide &side : boundary)
      {
        const auto row = spline::control_row(surface.elements[side.element], side.side, 0);
        if (std::all_of(row.begin(), row.end(),
                        [&](const unsigned int c) { return attached.count(c) > 0; }))
          gap =
              std::max(gap, spline::closest_point(stent, vectors, middle(surface, side)).distance);
      }
      return gap;
    }

    void measure_edges(const spline::Surface &surface, SurfaceReport &report)
    {
      const spline::SurfaceEdges edges = spline::edges(surface);
      report.jumps = spline::jumps(surface, edges);
      report.n_boundary_edges = edges.boundary.size();
      report.n_extraordinary_points = spline::n_extraordinary_points(surface, edges);
      report.n_seams = count_seams(surface, edges.boundary, report.low.distance(report.high));
      report.attachment_gap = attachment_gap(surface, edges.boundary);
    }
  } // namespace

  SurfaceReport report(const spline::Surface &surface)
  {
    SurfaceReport report;
    report.n_elements = surface.elements.size();
    report.n_control_points = surface.control_points.size();
    const std::vector<unsigned int> parts = spline::connected_parts(surface);
    report.n_parts = std::set<unsigned int>(parts.begin(), parts.end()).size();
    report.min_relative_jacobian = std::numeric_limits<double>::max();
    report.min_angle = 90.;
    for (unsigned int d = 0; d < 3; ++d)
    {
      report.low[d] = std::numeric_limits<double>::max();
      report.high[d] = std::numeric_limits<double>::lowest();
    }
    for (unsigned int element = 0; element < report.n_elements; ++element)
      measure_element(surface, element, report);
    measure_edges(surface, report);
    for (const spline::NamedSet &set : surface.sets)
      if (set.kind == spline::SetKind::element)
        report.set_sizes.emplace_back(set.name, set.members.size());
    return report;
  }

  void print(const SurfaceReport &report, Log &log)
  {
    std::ostringstream text;
    text << "surface: " << report.n_elements << " elements, " << report.n_control_points
         << " control points, " << report.n_parts << (report.n_parts == 1 ? " part" : " parts")
         << ", area " << report.area << ", box (" << report.low << ") to (" << report.high
         << "), smallest relative Jacobian " << report.min_relative_jacobian << ", smallest angle "
         << report.min_angle << " degrees";
    log.line(text.str());
    text.str("");
    text << "edges: " << report.n_boundary_edges << " on the boundary, " << report.jumps.n_kinks
         << " kinks, elsewhere jumps of the normal up to " << report.jumps.normal
         << " rad, gaps up to " << report.jumps.position << " of the extent, " << report.n_seams
         << " open seams; " << report.n_extraordinary_points << " extraordinary points";
    if (!std::isnan(report.attachment_gap))
      text << "; leaflets at most " << report.attachment_gap << " off the stent";
    log.line(text.str());
  }

  void add_quantities(const SurfaceReport &report, RunResults &results)
  {
    results.quantities.insert(results.quantities.end(),
                              {{"elements", 1. * report.n_elements, "-"},
                               {"control_points", 1. * report.n_control_points, "-"},
                               {"parts", 1. * report.n_parts, "-"},
                               {"area", report.area, "length^2"},
                               {"min_relative_jacobian", report.min_relative_jacobian, "-"},
                               {"min_angle", report.min_angle, "degree"},
                               {"largest_normal_jump", report.jumps.normal, "rad"},
                               {"largest_position_jump", report.jumps.position, "of the extent"},
                               {"kinks", 1. * report.jumps.n_kinks, "edges"},
                               {"boundary_edges", 1. * report.n_boundary_edges, "edges"},
                               {"open_seams", 1. * report.n_seams, "edges"},
                               {"extraordinary_points", 1. * report.n_extraordinary_points, "-"}});
    if (!std::isnan(report.attachment_gap))
      results.quantities.push_back({"attachment_gap", report.attachment_gap, "length"});
    for (const auto &[name, n] : report.set_sizes)
      results.quantities.push_back({"elements_" + name, 1. * n, "-"});
    const char *const axes[] = {"x", "y", "z"};
    for (unsigned int d = 0; d < 3; ++d)
    {
      results.quantities.push_back({std::string("min_") + axes[d], report.low[d], "length"});
      results.quantities.push_back({std::string("max_") + axes[d], report.high[d], "length"});
    }
  }
} // namespace semilunar::scene
