// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/scene/surface_report.h>
#include <semilunar/spline/evaluation.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <limits>
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
  } // namespace

  SurfaceReport report(const spline::Surface &surface)
  {
    SurfaceReport report;
    report.n_elements = surface.elements.size();
    report.n_control_points = surface.control_points.size();
    const std::vector<unsigned int> parts = spline::connected_parts(surface);
    report.n_parts = std::set<unsigned int>(parts.begin(), parts.end()).size();
    report.min_relative_jacobian = std::numeric_limits<double>::max();
    for (unsigned int d = 0; d < 3; ++d)
    {
      report.low[d] = std::numeric_limits<double>::max();
      report.high[d] = std::numeric_limits<double>::lowest();
    }
    for (unsigned int element = 0; element < report.n_elements; ++element)
      measure_element(surface, element, report);
    return report;
  }

  void print(const SurfaceReport &report, Log &log)
  {
    std::ostringstream text;
    text << "surface: " << report.n_elements << " elements, " << report.n_control_points
         << " control points, " << report.n_parts << (report.n_parts == 1 ? " part" : " parts")
         << ", area " << report.area << ", box (" << report.low << ") to (" << report.high
         << "), smallest relative Jacobian " << report.min_relative_jacobian;
    log.line(text.str());
  }

  void add_quantities(const SurfaceReport &report, RunResults &results)
  {
    results.quantities.insert(results.quantities.end(),
                              {{"elements", 1. * report.n_elements, "-"},
                               {"control_points", 1. * report.n_control_points, "-"},
                               {"parts", 1. * report.n_parts, "-"},
                               {"area", report.area, "length^2"},
                               {"min_relative_jacobian", report.min_relative_jacobian, "-"}});
    const char *const axes[] = {"x", "y", "z"};
    for (unsigned int d = 0; d < 3; ++d)
    {
      results.quantities.push_back({std::string("min_") + axes[d], report.low[d], "length"});
      results.quantities.push_back({std::string("max_") + axes[d], report.high[d], "length"});
    }
  }
} // namespace semilunar::scene
