// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/core/first_rank.h>
#include <semilunar/core/nearest_name.h>
#include <semilunar/output/atomic_file.h>
#include <semilunar/scene/reference_curve.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <set>
#include <sstream>

namespace semilunar::scene
{
  namespace
  {
    constexpr const char *header = "quantity,load_factor,value,source";
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    /// States and points count as at the same load factor within this.
    constexpr double same_load = 1e-9;
    /// Straight pieces of the curve between two states.
    constexpr unsigned int pieces = 32;
    constexpr double close = 0.01; // deviation of points that are counted

    double number(const std::string &text, const std::string &where)
    {
      std::size_t used = 0;
      double value = nan;
      try
      {
        value = std::stod(text, &used);
      }
      catch (const std::exception &)
      {
      }
      if (used != text.size() || !std::isfinite(value))
        throw InputError(where, text, "this is not a number", "write a number such as 1.5e-3");
      return value;
    }

    struct Point2
    {
      double load, value;
    };
    Point2 operator-(const Point2 &a, const Point2 &b)
    {
      return {a.load - b.load, a.value - b.value};
    }
    double length(const Point2 &a)
    {
      return std::hypot(a.load, a.value);
    }

    /// Slope of the path at the middle one of three points, by their distances.
    Point2 slope(const Point2 &before, const Point2 &here, const Point2 &after)
    {
      const double a = length(here - before), b = length(after - here);
      const Point2 left = here - before, right = after - here;
      const auto mean = [&](const double l, const double r)
      { return (l / a * b + r / b * a) / (a + b); };
      return {mean(left.load, right.load), mean(left.value, right.value)};
    }

    /// The curve of cubic pieces through the points, as a polygon.
    std::vector<Point2> refine(const std::vector<Point2> &points)
    {
      std::vector<Point2> curve = {points.front()};
      const unsigned int n = points.size();
      for (unsigned int k = 0; k + 1 < n; ++k)
      {
        const Point2 &p = points[k], &q = points[k + 1], chord = q - p;
        const double h = length(chord);
        const Point2 straight{chord.load / h, chord.value / h};
        const Point2 s = k > 0 ? slope(points[k - 1], p, q) : straight,
                     t = k + 2 < n ? slope(p, q, points[k + 2]) : straight;
        for (unsigned int i = 1; i <= pieces; ++i)
        {
          const double x = double(i) / pieces, y = 1. - x;
          const auto cubic = [&](const double a, const double b, const double c, const double d) {
            return y * y * (1. + 2. * x) * a + x * x * (1. + 2. * y) * b +
                   h * x * y * (y * c - x * d);
          };
          curve.push_back(
              {cubic(p.load, q.load, s.load, t.load), cubic(p.value, q.value, s.value, t.value)});
        }
      }
      return curve;
    }

    /// The nearest point of a polygon.
    Point2 nearest(const std::vector<Point2> &curve, const Point2 &point)
    {
      Point2 best{nan, nan};
      double smallest = std::numeric_limits<double>::infinity();
      for (unsigned int k = 0; k + 1 < curve.size(); ++k)
      {
        const Point2 along = curve[k + 1] - curve[k], to = point - curve[k];
        const double squared = along.load * along.load + along.value * along.value;
        const double t = std::clamp(
            squared > 0. ? (to.load * along.load + to.value * along.value) / squared : 0., 0., 1.);
        const Point2 foot{curve[k].load + t * along.load, curve[k].value + t * along.value};
        if (length(point - foot) < smallest)
        {
          smallest = length(point - foot);
          best = foot;
        }
      }
      return best;
    }

    /// The states of one quantity, from the unloaded one.
    std::vector<Point2> states(const LoadPath &path, const std::string &name, const double sign)
    {
      const auto column =
          std::find(path.names.begin(), path.names.end(), name) - path.names.begin();
      std::vector<Point2> points = {{0., 0.}};
      for (unsigned int k = 0; k < path.loads.size(); ++k)
        points.push_back({path.loads[k], sign * path.values[k][column]});
      return points;
    }

    /// The value at a load factor; NaN if there is no such state.
    double value_at(const std::vector<Point2> &points, const double load)
    {
      for (const Point2 &point : points)
        if (std::abs(point.load - load) <= same_load)
          return point.value;
      return nan;
    }
  } // namespace

  ReferenceCurve::ReferenceCurve(const std::string &file)
  {
    std::ifstream stream(file);
    std::string line;
    if (!std::getline(stream, line))
      throw InputError(file, "", "the reference curve cannot be read", "name a file that is there");
    if (line != header)
      throw InputError(file + ":1", line, "this is no header of a reference curve",
                       std::string("write ") + header);
    for (unsigned int n = 2; std::getline(stream, line); ++n)
    {
      if (line.empty())
        continue;
      const std::string where = file + ":" + std::to_string(n);
      std::istringstream fields(line);
      std::string name, load, value, source;
      std::getline(fields, name, ',');
      std::getline(fields, load, ',');
      std::getline(fields, value, ',');
      std::getline(fields, source);
      if (name.empty() || source.empty())
        throw InputError(where, line, "a reference needs four fields, the source among them",
                         std::string("write ") + header);
      const bool negative = name[0] == '-';
      rows.push_back({negative ? name.substr(1) : name, negative ? -1. : 1., number(load, where),
                      number(value, where), where});
    }
    if (rows.empty())
      throw InputError(file, "", "the reference curve holds no points", "give some");
  }

  std::vector<double> ReferenceCurve::load_factors() const
  {
    std::set<double> factors;
    for (const Row &row : rows)
      if (row.load > 0. && row.load <= 1.)
        factors.insert(row.load);
    return {factors.begin(), factors.end()};
  }

  void ReferenceCurve::check(const std::vector<std::string> &names) const
  {
    for (const Row &row : rows)
      if (std::find(names.begin(), names.end(), row.quantity) == names.end())
        throw InputError(row.where, row.quantity, "the run records no such quantity",
                         suggest(row.quantity, names));
  }

  void ReferenceCurve::compare(const LoadPath &path, const Comparison comparison,
                               const std::filesystem::path &folder, RunResults &results) const
  {
    const Scales scales = largest();
    double worst = 0., sum = 0.;
    unsigned int n = 0, n_close = 0;
    std::ostringstream table;
    table.precision(10);
    table << "quantity,load_factor,reference,value,deviation,relative_deviation\n";
    for (const Row &row : rows)
    {
      const Found found = find(row, path, comparison, scales);
      if (!std::isfinite(found.deviation))
        continue; // the run did not come that far
      table << (row.sign < 0. ? "-" : "") << row.quantity << ',' << row.load << ',' << row.value
            << ',' << found.value << ',' << found.deviation << ','
            << std::abs(found.value / row.value - 1.) << '\n';
      worst = std::max(worst, found.deviation);
      sum += found.deviation;
      ++n;
      n_close += found.deviation <= close;
    }
    on_first_rank(
        [&]
        {
          output::write_atomically((folder / "deviation.csv").string(),
                                   [&](std::ostream &out) { out << table.str(); });
        });
    auto &quantities = results.quantities;
    quantities.push_back({"points_compared", double(n), "-"});
    quantities.push_back({"largest_deviation", n > 0 ? worst : nan, "-"});
    quantities.push_back({"mean_deviation", n > 0 ? sum / n : nan, "-"});
    quantities.push_back({"points_within_1_percent", n > 0 ? double(n_close) / n : nan, "-"});
  }

  ReferenceCurve::Scales ReferenceCurve::largest() const
  {
    Scales scales;
    for (const Row &row : rows)
    {
      double &value = scales.values[row.quantity];
      value = std::max(value, std::abs(row.value));
      scales.load = std::max(scales.load, std::abs(row.load));
    }
    return scales;
  }

  ReferenceCurve::Found ReferenceCurve::find(const Row &row, const LoadPath &path,
                                             const Comparison comparison,
                                             const Scales &scales) const
  {
    const double scale = scales.values.at(row.quantity);
    std::vector<Point2> points = states(path, row.quantity, row.sign);
    if (comparison == Comparison::at_load)
    {
      const double value = value_at(points, row.load);
      return {value, std::abs(value - row.value) / scale};
    }
    if (row.load > 1. || points.size() < 2)
      return {nan, nan};
    for (Point2 &point : points)
      point = {point.load / scales.load, point.value / scale};
    const Point2 point{row.load / scales.load, row.value / scale};
    const Point2 found = nearest(refine(points), point);
    return {scale * found.value, length(found - point)};
  }
} // namespace semilunar::scene
