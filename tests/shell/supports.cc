// SPDX-License-Identifier: LGPL-2.1-or-later
// Supports in the words of a scene file: which components they hold and tie, which rigid motions
// they leave free, and what is said about supports that make no sense.

#include <semilunar/core/exceptions.h>
#include <semilunar/shell/supports.h>

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
  void check_true(const std::string &what, const bool holds)
  {
    check(what, holds ? 0. : 1., 0.);
  }

  /// 3 x 2 elements, 6 x 4 control points.
  Surface small_plate(const double height = 0.)
  {
    return plate(3., 2., {{3, 2}}, {{3, 2}}, height);
  }

  /// A list of supports, and enough besides to hold the plate.
  Equations held(const std::string &supports)
  {
    return make_equations(small_plate(), {supports + "; fix right xyz; fix nextRight xyz"});
  }

  using Components = std::vector<std::pair<unsigned int, unsigned int>>;

  /// The prescribed components of the left half (the right one is held).
  Components prescribed(const Equations &equations)
  {
    Components result;
    for (unsigned int c = 0; c < 24; ++c)
      for (unsigned int i = 0; i < 3; ++i)
        if (c % 6 < 3 && equations.is_prescribed(c, i))
          result.emplace_back(c, i);
    return result;
  }

  Components all(const std::vector<unsigned int> &points, const std::vector<unsigned int> &axes)
  {
    Components result;
    for (const unsigned int c : points)
      for (const unsigned int i : axes)
        result.emplace_back(c, i);
    return result;
  }

  void check_verbs()
  {
    check_true("fix", prescribed(held("fix left xz")) == all({0, 6, 12, 18}, {0, 2}));
    check_true("pin", prescribed(held("pin x=0")) == all({0, 6, 12, 18}, {0, 1, 2}));
    check_true("pin a point", prescribed(held("pin (0, 1.9, 0.1)")) == all({18}, {0, 1, 2}));
    check_true("clamp",
               prescribed(held("clamp left")) == all({0, 1, 6, 7, 12, 13, 18, 19}, {0, 1, 2}));
    check_true("clamp a plane", prescribed(held("clamp x=0")) == prescribed(held("clamp left")));
    check_true("several, and blanks",
               prescribed(held(" fix (0,0,0)   x ;; fix (0,0,0) z; ")) == all({0}, {0, 2}));

    const Equations moving = held("move left yz -0.25");
    std::vector<Tensor<1, 3>> u;
    moving.expand(dealii::Vector<double>(moving.n_equations()), 2., u);
    double error = std::abs(dot(u, u) - 4 * 0.5);
    for (const unsigned int c : {0, 6, 12, 18})
      error += (u[c] - Tensor<1, 3>({0., -0.5, -0.5})).norm();
    check("move, at twice the load", error, 0.);
  }

  void check_symmetry_and_ties()
  {
    for (const std::string place : {"x=0", "left x"})
    {
      const Equations e = held("symmetry " + place);
      check_true("symmetry " + place + ", normal", prescribed(e) == all({0, 6, 12, 18}, {0}));
      bool tied = true, others = false;
      for (const unsigned int c : {0, 6, 12, 18})
      {
        tied = tied && e(c, 1) == e(c + 1, 1) && e(c, 2) == e(c + 1, 2);
        others = others || e(c + 1, 1) == e(c + 2, 1) || e(c + 1, 0) == Equations::none;
      }
      check_true("symmetry " + place + ", second row", tied && !others);
    }
    // in the plane of symmetry the rows of a curved edge lie above each other, not next to each
    // other
    const double pi = dealii::numbers::PI;
    const Surface roof = refined(cylinder(2., pi / 6., pi / 2., 0., 0.3), {{3, 3}}, {{8, 2}});
    const Equations e = make_equations(roof, {"symmetry z=0; clamp left"});
    bool above = true;
    for (unsigned int i = 2; i < 11; ++i) // control points along the arc
      above = above && e(i, 0) == e(11 + i, 0) && e(i, 1) == e(11 + i, 1) && e(i, 0) != e(i + 1, 0);
    check_true("symmetry of a curved edge", above);

    const Equations tie = held("tie left (0, 0, 0) z");
    check_true("tie", tie(6, 2) == tie(0, 2) && tie(18, 2) == tie(0, 2) && tie(6, 1) != tie(0, 1) &&
                          tie(1, 2) != tie(0, 2));
    const Equations closed = held("tie top bottom xy");
    check_true("tie edges", closed(18, 0) == closed(0, 0) && closed(20, 1) == closed(2, 1) &&
                                closed(20, 2) != closed(2, 2));
  }

  /// Free rigid motions with exactly these supports, some of which make_equations would refuse.
  std::vector<unsigned int> free_motions(const Surface &surface, const std::string &supports)
  {
    try
    {
      return free_rigid_motions(surface, make_equations(surface, {supports}));
    }
    catch (const InputError &error)
    {
      // "piece 1 of 2 of the surface can still move rigidly in 3 independent ways"
      const std::string what = error.what();
      const std::size_t piece = what.find("piece "), count = what.find("rigidly in ");
      if (piece == std::string::npos || count == std::string::npos)
        return {99};
      std::vector<unsigned int> result(std::stoul(what.substr(piece + 11)), 0);
      result[std::stoul(what.substr(piece + 6)) - 1] = std::stoul(what.substr(count + 11));
      return result;
    }
  }

  void check_free(const std::string &what, const Surface &surface, const std::string &supports,
                  const std::vector<unsigned int> &expected)
  {
    std::string counts;
    for (const unsigned int count : expected)
      counts += " " + std::to_string(count);
    check_true(what + " '" + supports + "' leaves" + counts,
               free_motions(surface, supports) == expected);
  }

  void check_rigid_motions()
  {
    const Surface s = small_plate();
    check_free("plate", s, "", {6});
    check_free("plate", s, "tie right (3, 0, 0) z", {5});
    check_free("plate", s, "fix left z", {4});
    check_free("plate", s, "pin (0, 0, 0)", {3});
    check_free("plate", s, "fix left z; fix right z; fix bottom z; fix top z", {3});
    check_free("plate", s, "symmetry x=0", {3});
    check_free("plate", s, "pin left", {1});
    check_free("plate", s, "symmetry x=0; symmetry y=0", {1});
    check_free("plate", s, "clamp left", {0});
    check_free("plate", s, "pin left; fix right z", {0});
    check_free("plate", s, "pin left; move right z 1", {0});
    check_free("plate", s, "pin (0,0,0); fix (3,0,0) yz; fix (0,2,0) z", {0});

    const double pi = dealii::numbers::PI;
    const Surface panel =
        refined(cylinder(25., 5. / 18. * pi, 13. / 18. * pi, 0., 50.), {{3, 3}}, {{4, 4}});
    check_free("roof", panel, "pin left", {1});                  // a straight edge
    check_free("roof", panel, "pin bottom", {0});                // a curved one
    check_free("roof", panel, "fix bottom xy; fix top xy", {1}); // diaphragms
    check_free("roof", panel, "fix bottom xy; fix top xy; fix (0, 25, 0) z", {0});
    check_free("roof", panel, "fix bottom z", {3});

    const Surface octant = refined(sphere(10., 0., pi / 2., 0., pi / 3.), {{3, 3}}, {{3, 3}});
    check_free("octant", octant, "symmetry x=0; symmetry y=0", {1});
    check_free("octant", octant, "symmetry x=0; symmetry y=0; fix (10, 0, 0) z", {0});

    Surface two = small_plate();
    append(two, small_plate(1.), -1.);
    check_free("two plates", two, "clamp z=0", {0, 6});
    check_free("two plates", two, "clamp x=0; fix z=0 xyz", {0, 0});
    check_free("two plates", two, "pin z=1", {6, 0});
    check_free("two plates", two, "clamp x=0", {0, 0});
    check_free("two plates", two, "pin x=0; fix z=1 xyz", {1, 0});
    check_free("two plates", two, "fix z=0 xyz; tie z=1 z=0 xyz", {0, 0});
  }

  /// Two plates end to end, a gap between them, the right edge of one tied to the left of the
  /// other: a hinge. And both tied all over.
  void check_tied_pieces()
  {
    Surface surface = small_plate(), second = small_plate();
    for (ControlPoint &point : second.control_points)
      point.position[0] += 3.5;
    append(surface, second, -1.);
    check_free("hinged plates", surface, "pin x=0; tie x=3.5 x=3 xyz; fix x=3 z; fix x=6.5 z",
               {0, 0});

    const auto count = [&](const std::vector<unsigned int> &pinned, const unsigned int every)
    {
      Equations equations(48);
      for (unsigned int c = every - 1; c < 24; c += every)
        for (unsigned int i = 0; i < 3; ++i)
          equations.tie(c, every == 1 ? 24 + c : 24 + c - 5, i);
      for (const unsigned int c : pinned)
        for (unsigned int i = 0; i < 3; ++i)
          equations.prescribe(c, i, 0.);
      equations.close();
      return free_rigid_motions(surface, equations);
    };
    using Counts = std::vector<unsigned int>;
    check_true("hinge, free", count({}, 6) == Counts({6, 6}));
    // the first turns about its pinned edge, the second about the hinge, too
    check_true("hinge, pinned edge", count({0, 6, 12, 18}, 6) == Counts({1, 2}));
    check_true("hinge, far edge pinned", count({29, 35, 41, 47}, 6) == Counts({2, 1}));
    // a flat toggle
    check_true("hinge, both ends pinned", count({0, 6, 12, 18, 47}, 6) == Counts({1, 1}));
    check_true("hinge, pinned at itself", count({0, 6, 12, 18, 5, 47}, 6) == Counts({0, 0}));
    check_true("tied all over, free", count({}, 1) == Counts({6, 6}));
    check_true("tied all over, pinned point", count({0}, 1) == Counts({3, 3}));
    check_true("tied all over, pinned edge of the other",
               count({24, 30, 36, 42}, 1) == Counts({1, 1}));
  }

  /// Every message names the entry, holds the value and ends with a remedy.
  void check_message(const std::string &supports, const std::vector<std::string> &parts)
  {
    std::string message = "no message";
    try
    {
      make_equations(small_plate(), {supports});
    }
    catch (const InputError &error)
    {
      message = error.what();
    }
    bool complete = message.find("Supports/Supports = \"") == 0;
    for (const std::string &part : parts)
      complete = complete && message.find(part) != std::string::npos;
    if (!complete)
      std::fprintf(stderr, "%s\n", message.c_str());
    check_true("message for '" + supports + "'", complete);
  }

  void check_messages()
  {
    check_message("hold left", {"hold left", "not understood", "the verbs are: fix PLACE xyz"});
    check_message("clamp", {"clamp", "not understood", "clamp PLACE"});
    check_message("pin left x", {"pin left x", "not understood", "pin PLACE"});
    check_message("fix left xq", {"\"xq\"", "not components", "write some of xyz"});
    check_message("clamp lefft", {"\"lefft\"", "no such node set", "left, right, bottom, top"});
    check_message("pin y=9", {"\"y=9\"", "no control point lies in this plane", "name a plane"});
    check_message("clamp (0, 0, 0)", {"\"(0, 0, 0)\"", "no edge", "whole edge"});
    check_message("symmetry left", {"\"left\"", "normal", "symmetry SET x"});
    check_message("symmetry left q", {"\"q\"", "not components", "xyz"});
    check_message("symmetry x=1.5", {"\"x=1.5\"", "no control point", "plane"});
    check_message("move left x one", {"\"one\"", "not a number", "1.5e-3"});
    check_message("tie left (0, 0) x", {"\"(0, 0)\"", "not a vector", "three numbers"});
    check_message("pin left", {"\"pin left\"", "piece 1 of 1", "move rigidly in 1", "hold it"});
  }
} // namespace

int main()
{
  check_verbs();
  check_symmetry_and_ties();
  check_rigid_motions();
  check_tied_pieces();
  check_messages();
}
