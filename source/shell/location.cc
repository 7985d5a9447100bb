// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/shell/location.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>

namespace semilunar::shell
{
  namespace
  {
    std::string set_names(const spline::Surface &surface)
    {
      std::string names;
      for (const spline::NamedSet &set : surface.sets)
        if (set.kind == spline::SetKind::node)
          names += (names.empty() ? "" : ", ") + set.name;
      return names.empty() ? "this surface has no node sets" : "its node sets are " + names;
    }

    double extent(const spline::Surface &surface)
    {
      spline::Tensor<1, 3> low, high;
      for (unsigned int i = 0; i < 3; ++i)
      {
        const auto [min, max] = std::minmax_element(
            surface.control_points.begin(), surface.control_points.end(),
            [i](const auto &a, const auto &b) { return a.position[i] < b.position[i]; });
        low[i] = min->position[i];
        high[i] = max->position[i];
      }
      return (high - low).norm();
    }

    Location plane_location(const spline::Surface &surface, const std::string &text,
                            const std::string &entry)
    {
      const unsigned int axis = text[0] - 'x';
      const double level = parse_number(text.substr(2), entry);
      const double tolerance = plane_tolerance * extent(surface);
      Location location{text, {}, axis};
      for (unsigned int c = 0; c < surface.control_points.size(); ++c)
        if (std::abs(surface.control_points[c].position[axis] - level) <= tolerance)
          location.control_points.push_back(c);
      if (location.control_points.empty())
        throw InputError(entry, text, "no control point lies in this plane",
                         "name a plane that an edge of the surface lies in");
      return location;
    }

    Location nearest_point(const spline::Surface &surface, const std::string &text,
                           const std::string &entry)
    {
      const spline::Point<3> point(parse_vector(text, entry));
      const auto &points = surface.control_points;
      const auto nearest = std::min_element(
          points.begin(), points.end(),
          [&](const auto &a, const auto &b)
          { return a.position.distance_square(point) < b.position.distance_square(point); });
      return {text, {static_cast<unsigned int>(nearest - points.begin())}, {}};
    }
  } // namespace

  Location find_location(const spline::Surface &surface, const std::string &text,
                         const std::string &entry)
  {
    if (text.size() > 2 && text[0] >= 'x' && text[0] <= 'z' && text[1] == '=')
      return plane_location(surface, text, entry);
    if (!text.empty() && text[0] == '(')
      return nearest_point(surface, text, entry);
    const spline::NamedSet *set = surface.find_set(spline::SetKind::node, text);
    if (set == nullptr || set->members.empty())
      throw InputError(entry, text, "the surface has no such node set",
                       set_names(surface) + "; or name a plane (x=0) or a point ((0, 0, 1))");
    return {text, set->members, {}};
  }

  std::vector<spline::ElementSide>
  location_sides(const spline::Surface &surface, const Location &location, const std::string &entry)
  {
    const auto sides = boundary_sides(surface, location.control_points);
    if (sides.empty())
      throw InputError(entry, location.text, "no edge of the surface lies here",
                       "name a set or a plane that holds a whole edge");
    return sides;
  }

  std::vector<unsigned int> second_row(const spline::Surface &surface, const Location &location,
                                       const std::string &entry)
  {
    std::string next = "next" + location.text;
    next[4] = std::toupper(next[4]);
    if (const auto *set = surface.find_set(spline::SetKind::node, next))
      return set->members;
    return control_row(surface, location_sides(surface, location, entry), 1);
  }

  std::vector<std::string> split_words(const std::string &text)
  {
    std::vector<std::string> words;
    std::string word;
    int depth = 0;
    for (const char c : text)
    {
      depth += (c == '(') - (c == ')');
      if (depth == 0 && std::isspace(static_cast<unsigned char>(c)))
      {
        if (!word.empty())
          words.push_back(word);
        word.clear();
      }
      else
        word += c;
    }
    if (!word.empty())
      words.push_back(word);
    return words;
  }

  double parse_number(const std::string &word, const std::string &entry)
  {
    double number = 0.;
    try
    {
      number = dealii::Utilities::string_to_double(word);
    }
    catch (const dealii::ExceptionBase &)
    {
      throw InputError(entry, word, "this is not a number", "write a number such as 1.5e-3");
    }
    if (!std::isfinite(number))
      throw InputError(entry, word, "the number is not finite", "write a finite number");
    return number;
  }

  spline::Tensor<1, 3> parse_vector(const std::string &text, const std::string &entry)
  {
    std::string bare = text;
    std::replace_if(
        bare.begin(), bare.end(), [](const char c) { return c == '(' || c == ')' || c == ','; },
        ' ');
    const std::vector<std::string> words = split_words(bare);
    if (words.size() != 3)
      throw InputError(entry, text, "this is not a vector", "write three numbers: (1, 0, 0.5)");
    spline::Tensor<1, 3> vector;
    for (unsigned int i = 0; i < 3; ++i)
      vector[i] = parse_number(words[i], entry);
    return vector;
  }
} // namespace semilunar::shell
