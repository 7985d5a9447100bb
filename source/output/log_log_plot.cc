// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/output/log_log_plot.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>

namespace semilunar::output
{
  namespace
  {
    // Sizes in pixels.
    constexpr double width = 560., height = 420., left = 80., top = 50., legend_width = 260.,
                     margin = 60., line_height = 18.;

    // Colours that stay apart for the colour-blind (Okabe and Ito 2008); dashes after that.
    const std::array<const char *, 7> colours = {
        {"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000"}};
    const std::array<const char *, 3> dashes = {{"none", "6 3", "2 2"}};

    std::string escape(const std::string &text)
    {
      std::string result;
      for (const char c : text)
        if (c == '&')
          result += "&amp;";
        else if (c == '<')
          result += "&lt;";
        else
          result += c;
      return result;
    }

    bool can_be_drawn(const std::array<double, 2> &point)
    {
      return std::isfinite(point[0]) && std::isfinite(point[1]) && point[0] > 0. && point[1] > 0.;
    }

    /// Powers of ten around all values of a coordinate.
    struct Axis
    {
      int low = 0, high = 1;

      Axis(const std::vector<LogLogPlot::Curve> &curves, const unsigned int coordinate)
      {
        double smallest = std::numeric_limits<double>::infinity(), largest = 0.;
        for (const auto &curve : curves)
          for (const auto &point : curve.points)
          {
            smallest = std::min(smallest, point[coordinate]);
            largest = std::max(largest, point[coordinate]);
          }
        if (largest == 0.)
          return;
        low = std::floor(std::log10(smallest));
        high = std::max(low + 1, static_cast<int>(std::ceil(std::log10(largest))));
      }

      /// Where a value lies, 0 to 1.
      double operator()(const double value) const
      {
        return (std::log10(value) - low) / (high - low);
      }
    };

    void text(std::ostream &out, const double x, const double y, const std::string &anchor,
              const std::string &contents, const std::string &more = "")
    {
      out << "<text x=\"" << x << "\" y=\"" << y << "\" text-anchor=\"" << anchor << "\"" << more
          << ">" << escape(contents) << "</text>\n";
    }

    void line(std::ostream &out, const double x1, const double y1, const double x2, const double y2,
              const std::string &style)
    {
      out << "<line x1=\"" << x1 << "\" y1=\"" << y1 << "\" x2=\"" << x2 << "\" y2=\"" << y2
          << "\" " << style << "/>\n";
    }

    void draw_axes(std::ostream &out, const LogLogPlot &plot, const Axis &x_axis,
                   const Axis &y_axis)
    {
      const std::string grid = "stroke=\"#dddddd\"";
      const auto power = [](const int exponent) { return "1e" + std::to_string(exponent); };
      for (int exponent = x_axis.low; exponent <= x_axis.high; ++exponent)
      {
        const double x = left + width * x_axis(std::pow(10., exponent));
        line(out, x, top, x, top + height, grid);
        text(out, x, top + height + line_height, "middle", power(exponent));
      }
      for (int exponent = y_axis.low; exponent <= y_axis.high; ++exponent)
      {
        const double y = top + height * (1. - y_axis(std::pow(10., exponent)));
        line(out, left, y, left + width, y, grid);
        text(out, left - 6., y + 4., "end", power(exponent));
      }
      text(out, left + 0.5 * width, top - 20., "middle", plot.title, " font-weight=\"bold\"");
      text(out, left + 0.5 * width, top + height + 2.2 * line_height, "middle", plot.x_label);
      const double x = 0.25 * left, y = top + 0.5 * height;
      text(out, x, y, "middle", plot.y_label,
           " transform=\"rotate(-90 " + std::to_string(x) + " " + std::to_string(y) + ")\"");
    }

    void draw_curve(std::ostream &out, const LogLogPlot::Curve &curve, const unsigned int number,
                    const Axis &x_axis, const Axis &y_axis)
    {
      const std::string colour = colours[number % colours.size()];
      const std::string stroke = "stroke=\"" + colour +
                                 "\" stroke-width=\"1.5\" stroke-dasharray=\"" +
                                 dashes[number / colours.size() % dashes.size()] + "\"";
      out << "<polyline fill=\"none\" " << stroke << " points=\"";
      const auto x = [&](const auto &point) { return left + width * x_axis(point[0]); };
      const auto y = [&](const auto &point) { return top + height * (1. - y_axis(point[1])); };
      for (const auto &point : curve.points)
        out << x(point) << ',' << y(point) << ' ';
      out << "\"/>\n";
      for (const auto &point : curve.points)
        out << "<circle r=\"3\" fill=\"" << colour << "\" cx=\"" << x(point) << "\" cy=\""
            << y(point) << "\"/>\n";
      const double legend_x = left + width + 12., legend_y = top + (number + 0.5) * line_height;
      line(out, legend_x, legend_y, legend_x + 24., legend_y, stroke);
      text(out, legend_x + 30., legend_y + 4., "start", curve.name);
    }
  } // namespace

  void write_svg(std::ostream &out, const LogLogPlot &plot)
  {
    std::vector<LogLogPlot::Curve> curves;
    for (LogLogPlot::Curve curve : plot.curves)
    {
      const auto last = std::remove_if(curve.points.begin(), curve.points.end(),
                                       [](const auto &point) { return !can_be_drawn(point); });
      curve.points.erase(last, curve.points.end());
      if (!curve.points.empty())
        curves.push_back(curve);
    }
    const Axis x_axis(curves, 0), y_axis(curves, 1);
    const double full_width = left + width + legend_width;
    const double full_height = top + std::max(height, curves.size() * line_height) + margin;
    out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << full_width << "\" height=\""
        << full_height << "\" font-family=\"sans-serif\" font-size=\"12\">\n"
        << "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
    draw_axes(out, plot, x_axis, y_axis);
    for (unsigned int number = 0; number < curves.size(); ++number)
      draw_curve(out, curves[number], number, x_axis, y_axis);
    out << "</svg>\n";
  }
} // namespace semilunar::output
