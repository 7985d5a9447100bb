// SPDX-License-Identifier: LGPL-2.1-or-later
// Rows of control points along edges of tensor-product patches, where the answer is known; places
// as a user names them; messages for places that are not there.

#include <semilunar/core/exceptions.h>
#include <semilunar/shell/location.h>

#include <algorithm>
#include <functional>

#include "../tests.h"
#include "shell_cases.h"

using namespace semilunar;
using namespace semilunar::shell;
using namespace semilunar::spline;
using namespace semilunar::tests;

namespace
{
  using Numbers = std::vector<unsigned int>;

  void check_true(const std::string &what, const bool holds)
  {
    check(what, holds ? 0. : 1., 0.);
  }

  /// 3 x 2 elements, 6 x 4 control points.
  Surface small_plate()
  {
    return plate(3., 2., {{3, 2}}, {{3, 2}});
  }

  Numbers row_at(const Surface &surface, const Numbers &edge, const unsigned int row)
  {
    return control_row(surface, boundary_sides(surface, edge), row);
  }

  Numbers sorted(Numbers numbers)
  {
    std::sort(numbers.begin(), numbers.end());
    return numbers;
  }

  bool equal(const std::vector<ElementSide> &sides, const std::vector<Numbers> &expected)
  {
    std::vector<Numbers> pairs;
    for (const ElementSide &s : sides)
      pairs.push_back({s.element, s.side});
    return pairs == expected;
  }

  void check_rows()
  {
    const Surface s = small_plate();
    const Numbers left{0, 6, 12, 18}, right{5, 11, 17, 23}, bottom{0, 1, 2, 3, 4, 5},
        top{18, 19, 20, 21, 22, 23};
    check_true(
        "all sides of the edge",
        equal(boundary_sides(s),
              {{0, 0}, {0, 2}, {1, 2}, {2, 1}, {2, 2}, {3, 0}, {3, 3}, {4, 3}, {5, 1}, {5, 3}}));
    check_true("sides of the left and the top edge",
               equal(boundary_sides(s, left), {{0, 0}, {3, 0}}) &&
                   equal(boundary_sides(s, top), {{3, 3}, {4, 3}, {5, 3}}));
    check_true("no sides", boundary_sides(s, {0, 6, 12}).size() == 1 &&
                               boundary_sides(s, {1, 7, 13, 19}).empty() &&
                               boundary_sides(s, {}).empty());
    check_true("first rows", row_at(s, left, 0) == left && row_at(s, right, 0) == right &&
                                 row_at(s, bottom, 0) == bottom && row_at(s, top, 0) == top);
    check_true("second rows", row_at(s, left, 1) == Numbers({1, 7, 13, 19}) &&
                                  row_at(s, right, 1) == Numbers({4, 10, 16, 22}) &&
                                  row_at(s, bottom, 1) == Numbers({6, 7, 8, 9, 10, 11}) &&
                                  row_at(s, top, 1) == Numbers({12, 13, 14, 15, 16, 17}));
    Numbers corner = left;
    corner.insert(corner.end(), bottom.begin(), bottom.end());
    check_true("second row around a corner",
               row_at(s, corner, 1) == Numbers({7, 8, 9, 10, 11, 13, 19}));
    check_true("rows of an element",
               sorted(control_row(s.elements[4], 3, 0)) == Numbers({19, 20, 21, 22}) &&
                   sorted(control_row(s.elements[4], 3, 1)) == Numbers({13, 14, 15, 16}));
    // an inner edge of maximal smoothness: three cubics live there, the fourth begins with zero
    // slope
    check_true("rows of an inner side", sorted(control_row(s.elements[1], 0, 0)) ==
                                                Numbers({1, 2, 3, 7, 8, 9, 13, 14, 15}) &&
                                            control_row(s.elements[1], 0, 1).empty());
    const Surface linear = plate(1., 1., {{1, 3}}, {{1, 2}});
    check_true("second row across degree one",
               row_at(linear, {0, 2, 4, 6, 8}, 1) == Numbers({1, 3, 5, 7, 9}));
  }

  void check_other_surfaces()
  {
    const double pi = dealii::numbers::PI;
    Surface tube = refined(cylinder(1., 0., pi, 0., 2.), {{3, 3}}, {{4, 3}});
    append(tube, refined(cylinder(1., pi, 2. * pi, 0., 2.), {{3, 3}}, {{4, 3}}), 1e-9);
    const auto sides = boundary_sides(tube);
    check_true("a closed tube has edges at its ends only",
               sides.size() == 16 && std::all_of(sides.begin(), sides.end(),
                                                 [](const ElementSide &s) { return s.side >= 2; }));

    Surface two = small_plate();
    append(two, plate(1., 1., {{2, 2}}, {{1, 1}}, 5.), -1.);
    check_true("two pieces", boundary_sides(two).size() == 14 &&
                                 row_at(two, {24, 27, 30}, 1) == Numbers({25, 28, 31}));

    // a coefficient that is rounding noise of a file does not put a function on the edge
    Surface noisy = small_plate();
    BezierElement &element = noisy.elements[0];
    const auto inner = std::find(element.control_points.begin(), element.control_points.end(), 8u);
    double &coefficient =
        element.extraction[(inner - element.control_points.begin()) * element.n_bernstein()];
    coefficient += 1e-10;
    check_true("noise in the extraction", control_row(element, 0, 0).size() == 3);
    coefficient += 1e-6;
    check_true("a coefficient on the edge", control_row(element, 0, 0).size() == 4);
  }

  void check_places()
  {
    Surface s = small_plate();
    const Location left = find_location(s, "left", "E"), plane = find_location(s, "x=0", "E"),
                   right = find_location(s, "x=3.0000001", "E"),
                   corner = find_location(s, "(3.1, 2.2, -1)", "E");
    check_true("a set", sorted(left.control_points) == Numbers({0, 6, 12, 18}) && !left.axis);
    check_true("a plane", sorted(plane.control_points) == Numbers({0, 6, 12, 18}) && plane.axis &&
                              *plane.axis == 0);
    check_true("a plane within the tolerance",
               sorted(right.control_points) == Numbers({5, 11, 17, 23}));
    check_true("a point", corner.control_points == Numbers({23}) && !corner.axis);
    check_true("the plane of the plate",
               find_location(s, "z=0", "E").control_points.size() == 24 &&
                   location_sides(s, find_location(s, "z=0", "E"), "E").size() == 10);
    check_true("sides at a plane", equal(location_sides(s, plane, "E"), {{0, 0}, {3, 0}}));

    const Numbers second{1, 7, 13, 19};
    check_true("second row at a set and at a plane",
               sorted(second_row(s, left, "E")) == second && second_row(s, plane, "E") == second);
    s.sets.push_back({SetKind::node, "hinge", {0, 6, 12, 18}});
    check_true("second row at a set without one",
               second_row(s, find_location(s, "hinge", "E"), "E") == second);
    s.sets.push_back({SetKind::node, "nextHinge", {2, 8}});
    check_true("second row as a set says",
               second_row(s, find_location(s, "hinge", "E"), "E") == Numbers({2, 8}));
  }

  void check_words()
  {
    const std::vector<std::string> words = split_words("  tie (0, 0, 1)\t(1,0 , 0)  xy ");
    check_true("words", words == std::vector<std::string>({"tie", "(0, 0, 1)", "(1,0 , 0)", "xy"}));
    check_true("no words", split_words(" ").empty());
    const Tensor<1, 3> expected({1., -2.5, 3e-2});
    check("vectors",
          (parse_vector("(1, -2.5, 3e-2)", "E") - expected).norm() +
              (parse_vector("1 -2.5 0.03", "E") - expected).norm() + parse_number("-1.5", "E") +
              1.5,
          1e-15);
  }

  /// A message must name the entry and hold all of these.
  void check_message(const std::string &what, const std::function<void()> &action,
                     const std::vector<std::string> &parts)
  {
    std::string message = "no message";
    try
    {
      action();
    }
    catch (const InputError &error)
    {
      message = error.what();
    }
    bool complete = message.find("Loads/Test = \"") == 0;
    for (const std::string &part : parts)
      complete = complete && message.find(part) != std::string::npos;
    if (!complete)
      std::fprintf(stderr, "%s\n", message.c_str());
    check_true("message for " + what, complete);
  }

  void check_messages()
  {
    const Surface s = small_plate();
    const std::string E = "Loads/Test";
    check_message("an unknown set", [&] { find_location(s, "lefft", E); },
                  {"lefft", "no such node set", "left, right, bottom, top", "x=0"});
    check_message("an empty plane", [&] { find_location(s, "x=17", E); },
                  {"x=17", "no control point lies in this plane", "name a plane"});
    check_message("a plane that is none", [&] { find_location(s, "x=a", E); },
                  {"\"a\"", "not a number", "1.5e-3"});
    check_message("a place without an edge",
                  [&] { location_sides(s, find_location(s, "(0, 0, 0)", E), E); },
                  {"(0, 0, 0)", "no edge of the surface", "holds a whole edge"});
    check_message("too short a vector", [&] { parse_vector("(1, 2)", E); },
                  {"(1, 2)", "not a vector", "three numbers"});
    check_message("a number too large", [&] { parse_number("inf", E); },
                  {"inf", "not finite", "finite number"});
    check_message("a vector of letters", [&] { parse_vector("(1, two, 3)", E); },
                  {"two", "not a number"});
    Surface nameless = s;
    nameless.sets.clear();
    check_message("a set of a surface without sets", [&] { find_location(nameless, "left", E); },
                  {"no node sets", "x=0"});
  }
} // namespace

int main()
{
  check_rows();
  check_other_surfaces();
  check_places();
  check_words();
  check_messages();
}
