// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/valve/element_sizes.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <sstream>

namespace semilunar::valve
{
  using spline::Point;

  namespace
  {
    const char *const header = "u_low,v_low,u_high,v_high";

    /// @return whether the line is four numbers separated by commas
    bool parse(const std::string &line, Point<2> &low, Point<2> &high)
    {
      std::istringstream in(line);
      char comma[3] = {',', ',', ','};
      in >> low[0] >> comma[0] >> low[1] >> comma[1] >> high[0] >> comma[2] >> high[1];
      return in && std::all_of(comma, comma + 3, [](const char c) { return c == ','; }) &&
             (in >> std::ws).eof();
    }

    /// Smaller elements could ask for more halvings than a T-mesh has.
    constexpr double smallest = 1e-4;

    bool is_element(const Point<2> &low, const Point<2> &high)
    {
      for (unsigned int d = 0; d < 2; ++d)
        if (!(low[d] >= 0. && high[d] - low[d] >= smallest && high[d] <= 1.))
          return false;
      return true;
    }
  } // namespace

  ElementSizes::ElementSizes(const spline::TSpline &leaflet)
  {
    const auto corner = [&](const spline::TMesh::Point &x)
    { return Point<2>(leaflet.parameter(0, x[0]), leaflet.parameter(1, x[1])); };
    const spline::TMesh &mesh = leaflet.mesh();
    for (const unsigned int e : mesh.active_elements())
      boxes.push_back({corner(mesh.element(e).low), corner(mesh.element(e).high)});
  }

  ElementSizes::ElementSizes(const std::filesystem::path &file)
  {
    std::ifstream in(file);
    if (!in)
      throw InputError(file.string(), "", "cannot be read",
                       "name the elements.csv of a run that refined leaflets");
    std::string line;
    if (!std::getline(in, line) || line != header)
      throw InputError(file.string() + ", line 1", line, "this is no table of element sizes",
                       std::string("it begins with ") + header);
    for (unsigned int number = 2; std::getline(in, line); ++number)
    {
      Box box;
      if (!parse(line, box.low, box.high) || !is_element(box.low, box.high))
        throw InputError(file.string() + ", line " + std::to_string(number), line,
                         "this is no element of a leaflet",
                         "write four numbers from 0 to 1, the low ones first, at least 1e-4 apart");
      boxes.push_back(box);
    }
  }

  void ElementSizes::write(const std::filesystem::path &file) const
  {
    std::ofstream out(file);
    out.precision(std::numeric_limits<double>::max_digits10);
    out << header << "\n";
    for (const Box &box : boxes)
      out << box.low[0] << "," << box.low[1] << "," << box.high[0] << "," << box.high[1] << "\n";
    out.close();
    if (!out)
      throw InputError(file.string(), "", "cannot be written", "is the disk full?");
  }

  bool ElementSizes::is_too_large(const Point<2> &low, const Point<2> &high) const
  {
    constexpr double sqrt_2 = 1.4142135623730951;
    return std::any_of(boxes.begin(), boxes.end(),
                       [&](const Box &box)
                       {
                         bool larger = false;
                         for (unsigned int d = 0; d < 2; ++d)
                         {
                           const double middle = 0.5 * (box.low[d] + box.high[d]);
                           if (middle < low[d] || middle > high[d])
                             return false;
                           larger =
                               larger || high[d] - low[d] > sqrt_2 * (box.high[d] - box.low[d]);
                         }
                         return larger;
                       });
  }
} // namespace semilunar::valve
