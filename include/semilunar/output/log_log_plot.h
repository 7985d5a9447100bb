// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_output_log_log_plot_h
#define semilunar_output_log_log_plot_h

#include <array>
#include <iosfwd>
#include <string>
#include <vector>

namespace semilunar::output
{
  /// Curves over logarithmic axes.
  struct LogLogPlot
  {
    struct Curve
    {
      std::string name;
      std::vector<std::array<double, 2>> points; ///< what is not finite and positive is left out
    };

    std::string title, x_label, y_label;
    std::vector<Curve> curves;
  };

  /// The plot as an SVG document. Curves without points are left out.
  void write_svg(std::ostream &out, const LogLogPlot &plot);
} // namespace semilunar::output

#endif
