// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/core/time_table.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>

namespace semilunar
{
  namespace
  {
    /// The first and last values of a periodic table may differ by so much of the largest.
    constexpr double rounding = 1e-12;

    bool parse(const std::string &text, double &number)
    {
      std::size_t end = 0;
      try
      {
        number = std::stod(text, &end);
      }
      catch (const std::exception &)
      {
        return false;
      }
      return end == text.size() && std::isfinite(number);
    }

    bool parse_pair(const std::string &item, const char separator, std::pair<double, double> &point)
    {
      const auto parts = dealii::Utilities::split_string_list(item, separator);
      return parts.size() == 2 && parse(parts[0], point.first) && parse(parts[1], point.second);
    }

    TimeTable::Points parse_list(const std::string &list, const std::string &entry)
    {
      TimeTable::Points points;
      for (const std::string &item : dealii::Utilities::split_string_list(list, ','))
      {
        points.emplace_back();
        if (!parse_pair(item, ':', points.back()))
          throw InputError(entry, item, "this is not a time and a value",
                           "write TIME: VALUE, TIME: VALUE, ... as in 0: 0, 0.02: 12");
      }
      return points;
    }

    /// Lines "time, value"; the first may be a title, # starts a comment.
    TimeTable::Points read_file(const std::string &filename, const std::string &entry)
    {
      std::ifstream file(filename);
      if (!file)
        throw InputError(entry, filename, "the file cannot be read",
                         "give the name of an existing file, relative to the scene file");
      TimeTable::Points points;
      std::string line;
      for (unsigned int number = 1; std::getline(file, line); ++number)
      {
        line = dealii::Utilities::trim(line.substr(0, line.find('#')));
        std::pair<double, double> point;
        if (parse_pair(line, ',', point))
          points.push_back(point);
        else if (!line.empty() && !(number == 1 && std::isdigit(line[0]) == 0))
          throw InputError(filename + ":" + std::to_string(number), line,
                           "this is not a time and a value", "write TIME, VALUE in each line");
      }
      return points;
    }

    /// Slope between an interval of length h with secant s and one of length k with secant t
    /// (Steffen, eqs. 8 and 11).
    double inner_slope(const double s, const double h, const double t, const double k)
    {
      if (s * t <= 0.)
        return 0.;
      const double parabola = (s * k + t * h) / (h + k);
      return std::copysign(2. * std::min({std::abs(s), std::abs(t), 0.5 * std::abs(parabola)}), s);
    }

    /// Slope at an end, where the outermost interval has length h and secant s and the next one k
    /// and t (Steffen, eqs. 24 to 27).
    double end_slope(const double s, const double h, const double t, const double k)
    {
      const double parabola = s * (1. + h / (h + k)) - t * h / (h + k);
      if (parabola * s <= 0.)
        return 0.;
      return std::abs(parabola) > 2. * std::abs(s) ? 2. * s : parabola;
    }

    TimeTable::Points read_points(const TimeTableParameters &parameters, const std::string &section)
    {
      if (parameters.values.empty() == parameters.file.empty())
        throw InputError(section + "/Values", parameters.values,
                         parameters.file.empty() ? "the table is empty"
                                                 : "the table is given twice",
                         "give either Values or File");
      return parameters.file.empty() ? parse_list(parameters.values, section + "/Values")
                                     : read_file(parameters.file, section + "/File");
    }

    void check_points(const TimeTable::Points &points, const bool periodic,
                      const std::string &place)
    {
      if (points.size() < (periodic ? 2 : 1))
        throw InputError(place, "", "there are too few times in the table",
                         periodic ? "give at least two: their distance is the period"
                                  : "give at least one");
      double largest = 0.;
      for (std::size_t i = 0; i < points.size(); ++i)
      {
        if (!std::isfinite(points[i].first) || !std::isfinite(points[i].second))
          throw InputError(place, "", "a number of the table is not finite", "correct it");
        if (i > 0 && !(points[i].first > points[i - 1].first))
          throw InputError(place, dealii::Utilities::to_string(points[i].first),
                           "this time does not come after the one before it",
                           "sort the times in ascending order, each once");
        largest = std::max(largest, std::abs(points[i].second));
      }
      if (periodic && std::abs(points.back().second - points[0].second) > rounding * largest)
        throw InputError(place, dealii::Utilities::to_string(points.back().second),
                         "the last value of a periodic table is not its first one, " +
                             dealii::Utilities::to_string(points[0].second),
                         "make the two equal, or set Periodic = false");
    }
  } // namespace

  void TimeTableParameters::add_parameters(dealii::ParameterHandler &prm, const std::string &what)
  {
    using namespace dealii;
    prm.add_parameter("Values", values,
                      "Table of " + what + " over time, 'TIME: VALUE, TIME: VALUE, ...'.",
                      Patterns::Anything());
    prm.add_parameter("File", file,
                      "The same from a file of lines 'TIME, VALUE' (a first line of titles and "
                      "comments after # are skipped); give Values or this.",
                      Patterns::FileName(Patterns::FileName::input));
    prm.add_parameter("Interpolation", interpolation,
                      "Between the times: straight, or a cubic that is smooth and has no extrema "
                      "but those of the table.",
                      Patterns::Selection("linear|monotone cubic"));
    prm.add_parameter("Periodic", periodic,
                      "Repeat the table with the distance of its last time from its first as "
                      "period; otherwise the values stay constant outside of it.");
  }

  TimeTable::TimeTable(const double value) : table{{0., value}} {}

  TimeTable::TimeTable(const Points &points, const Interpolation interpolation, const bool periodic,
                       const std::string &place)
      : table(points), cubic(interpolation == Interpolation::monotone_cubic), periodic(periodic)
  {
    check_points(table, periodic, place);
    if (cubic)
      compute_slopes();
  }

  TimeTable::TimeTable(const TimeTableParameters &parameters, const std::string &section)
      : TimeTable(read_points(parameters, section),
                  parameters.interpolation == "linear" ? Interpolation::linear
                                                       : Interpolation::monotone_cubic,
                  parameters.periodic, section + (parameters.file.empty() ? "/Values" : "/File"))
  {
  }

  void TimeTable::compute_slopes()
  {
    const std::size_t n = table.size();
    slopes.assign(n, 0.);
    if (n < 2)
      return;
    std::vector<double> lengths, secants;
    for (std::size_t i = 0; i + 1 < n; ++i)
    {
      lengths.push_back(table[i + 1].first - table[i].first);
      secants.push_back((table[i + 1].second - table[i].second) / lengths[i]);
    }
    for (std::size_t i = 1; i + 1 < n; ++i)
      slopes[i] = inner_slope(secants[i - 1], lengths[i - 1], secants[i], lengths[i]);
    const std::size_t last = n - 2, second = std::min<std::size_t>(1, last),
                      second_last = last - second;
    if (periodic)
      slopes.front() = slopes.back() =
          inner_slope(secants[last], lengths[last], secants[0], lengths[0]);
    else
    {
      slopes.front() = end_slope(secants[0], lengths[0], secants[second], lengths[second]);
      slopes.back() =
          end_slope(secants[last], lengths[last], secants[second_last], lengths[second_last]);
    }
  }

  bool TimeTable::is_constant_at(const double time) const
  {
    return table.size() == 1 ||
           (!periodic && (time < table.front().first || time >= table.back().first));
  }

  double TimeTable::reduce(const double time) const
  {
    const double start = table.front().first, period = table.back().first - start;
    if (time >= start && time < start + period)
      return time;
    const double reduced = time - period * std::floor((time - start) / period);
    return std::clamp(reduced, start, std::nextafter(start + period, start));
  }

  TimeTable::Place TimeTable::locate(const double time) const
  {
    const double reduced = reduce(time);
    const auto after = std::upper_bound(table.begin(), table.end(), reduced,
                                        [](const double t, const auto &p) { return t < p.first; });
    const std::size_t interval = after - table.begin() - 1;
    return {interval, reduced - table[interval].first};
  }

  double TimeTable::value(const double time) const
  {
    if (is_constant_at(time))
      return time < table.front().first ? table.front().second : table.back().second;
    const auto [i, t] = locate(time);
    const double length = table[i + 1].first - table[i].first;
    const double secant = (table[i + 1].second - table[i].second) / length;
    if (!cubic)
      return table[i].second + secant * t;
    const double c = (3. * secant - 2. * slopes[i] - slopes[i + 1]) / length;
    const double d = (slopes[i] + slopes[i + 1] - 2. * secant) / (length * length);
    return table[i].second + t * (slopes[i] + t * (c + t * d));
  }

  double TimeTable::derivative(const double time) const
  {
    if (is_constant_at(time))
      return 0.;
    const auto [i, t] = locate(time);
    const double length = table[i + 1].first - table[i].first;
    const double secant = (table[i + 1].second - table[i].second) / length;
    if (!cubic)
      return secant;
    const double c = (3. * secant - 2. * slopes[i] - slopes[i + 1]) / length;
    const double d = (slopes[i] + slopes[i + 1] - 2. * secant) / (length * length);
    return slopes[i] + t * (2. * c + t * 3. * d);
  }

  double TimeTable::next_corner(const double time) const
  {
    if (cubic || table.size() == 1 || (!periodic && time >= table.back().first))
      return std::numeric_limits<double>::infinity();
    if (!periodic && time < table.front().first)
      return table.front().first;
    const auto [i, t] = locate(time);
    return time + (table[i + 1].first - table[i].first - t);
  }
} // namespace semilunar
