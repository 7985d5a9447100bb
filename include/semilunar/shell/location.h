// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_shell_location_h
#define semilunar_shell_location_h

#include <semilunar/spline/boundary_rows.h>

#include <optional>

namespace semilunar::shell
{
  /// A place on a surface as a user names it: a node set ("left"), a coordinate plane ("x=0"), or
  /// the control point nearest to a point ("(0, 25, 0)").
  struct Location
  {
    std::string text;
    std::vector<unsigned int> control_points; ///< never empty
    std::optional<unsigned int> axis;         ///< normal of the plane, if it is one
  };

  /// Control points count as lying in a plane within this fraction of the surface's extent.
  constexpr double plane_tolerance = 1e-6;

  /// @param entry the section/entry that the text comes from, for messages
  /// @throws InputError if there is no such set, or nothing lies in the plane
  Location find_location(const spline::Surface &surface, const std::string &text,
                         const std::string &entry);

  /// The boundary sides at the location. @throws InputError if there are none
  std::vector<spline::ElementSide> location_sides(const spline::Surface &surface,
                                                  const Location &location,
                                                  const std::string &entry);

  /// The second row of control points at the location: the node set nextXyz of a set xyz where
  /// there is one, otherwise what turns the surface about the boundary sides there.
  std::vector<unsigned int> second_row(const spline::Surface &surface, const Location &location,
                                       const std::string &entry);

  /// Split at blanks, keeping what stands in parentheses together.
  std::vector<std::string> split_words(const std::string &text);

  /// The number in a word. @throws InputError
  double parse_number(const std::string &word, const std::string &entry);

  /// "(x, y, z)" or "x y z" as a vector. @throws InputError
  spline::Tensor<1, 3> parse_vector(const std::string &text, const std::string &entry);
} // namespace semilunar::shell

#endif
