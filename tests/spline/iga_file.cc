// SPDX-License-Identifier: LGPL-2.1-or-later
// .iga files: reading back what was written bit by bit, and one message for each kind of mistake.
#include "../tests.h"
#include <semilunar/core/exceptions.h>
#include <semilunar/spline/iga_file.h>
#include <semilunar/spline/primitives.h>

#include <cstring>

using namespace semilunar;
using spline::Surface;

namespace
{
  bool identical(const std::vector<double> &a, const std::vector<double> &b)
  {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
  }

  bool identical(const Surface &a, const Surface &b)
  {
    if (a.control_points.size() != b.control_points.size() ||
        a.elements.size() != b.elements.size() || a.sets.size() != b.sets.size())
      return false;
    for (unsigned int i = 0; i < a.control_points.size(); ++i)
      if (std::memcmp(&a.control_points[i], &b.control_points[i], sizeof(spline::ControlPoint)))
        return false;
    for (unsigned int e = 0; e < a.elements.size(); ++e)
      if (a.elements[e].degree != b.elements[e].degree ||
          a.elements[e].control_points != b.elements[e].control_points ||
          !identical(a.elements[e].extraction, b.elements[e].extraction))
        return false;
    for (unsigned int s = 0; s < a.sets.size(); ++s)
      if (a.sets[s].kind != b.sets[s].kind || a.sets[s].name != b.sets[s].name ||
          a.sets[s].members != b.sets[s].members)
        return false;
    return true;
  }

  /// Rational, two degrees, all kinds of sets, awkward numbers.
  Surface awkward_surface()
  {
    spline::NurbsPatch patch = spline::sphere(1. / 3., 0.1, 1.2, -0.7, 0.9);
    patch.elevate_degree(1);
    patch.refine_to(0, 3);
    Surface surface = to_surface(patch);
    surface.control_points[0].position = spline::Point<3>(-0., 4.9e-324, -1.7976931348623157e308);
    surface.control_points[1].position = spline::Point<3>(0.1, 1e22, 123456789.12345678);
    surface.sets.push_back({spline::SetKind::element, "middle", {1}});
    surface.sets.push_back({spline::SetKind::side, "rim", {0, 3, 2, 1}});
    surface.sets.push_back({spline::SetKind::node, "empty", {}});
    return surface;
  }

  /// A unit square: valid, with blanks, an extra blank line and all forms of numbers.
  const std::string good = "type plane  \n"
                           "nodeN 4\t\r\n"
                           "elemN 1\n"
                           "node 0 0 0 1\n"
                           "node +1.0e0 .0 0. 1\n"
                           "\n"
                           "node 0 10E-1 0 1\n"
                           "node 1. 1 -0 1\n"
                           "belem 4 1 1\n"
                           "0 1 2 3\n"
                           "1 0 0 0\n"
                           "0 1 0 0\n"
                           "0 0 1 0\n"
                           "0 0 0 1\n"
                           "set 2 node left 0 2\n"
                           "set 1 side rim 0 3";

  void write(const std::string &text)
  {
    std::ofstream("square.iga") << text;
  }

  void log_error(const std::string &filename, const double scale = 1.)
  {
    try
    {
      spline::read_iga(filename, scale);
      tests::log() << "NO ERROR" << std::endl;
    }
    catch (const InputError &error)
    {
      tests::log() << error.what() << std::endl;
    }
  }

  /// Read the good file after one replacement.
  void log_broken(const std::string &before, const std::string &after)
  {
    std::string text = good;
    text.replace(text.find(before), before.size(), after);
    write(text);
    log_error("square.iga");
  }

  void log_truncated(const std::string &last)
  {
    write(good.substr(0, good.find(last) + last.size()));
    log_error("square.iga");
  }
} // namespace

int main()
{
  const Surface surface = awkward_surface();
  write_iga(surface, "awkward.iga");
  tests::log() << "read back: "
               << (identical(surface, spline::read_iga("awkward.iga")) ? "" : "NOT ") << "identical"
               << std::endl;

  write(good);
  const Surface square = spline::read_iga("square.iga", 2.5);
  tests::log() << "square: " << square.control_points[3].position << ", weight "
               << square.control_points[3].weight << ", rim of "
               << square.sets[1].members.size() / 2 << std::endl;

  log_broken("type plane", "type volume");
  log_broken("nodeN", "nodes");
  log_broken("nodeN 4", "nodeN 5");
  log_broken("nodeN 4", "nodeN 3");
  log_broken("nodeN 4", "nodeN -4");
  log_broken("elemN 1", "elemN 0");
  log_broken("elemN 1", "elemN 2");
  log_broken("node 0 0 0 1", "node 0 0 1");
  log_broken("node 0 0 0 1", "node 0 0 0 1 1");
  log_broken("node 0 0 0 1", "node 0 0 0 -1");
  log_broken("node 0 10E-1", "node nan 1");
  log_broken("node 0 10E-1", "node 0 inf");
  log_broken("node 0 10E-1", "node 0 1e999");
  log_broken("node 0 10E-1", "node 0 1.5cm");
  log_broken("belem 4 1 1", "belem 4 0 3");
  log_broken("belem 4 1 1", "belem 4 11 1");
  log_broken("belem 4 1 1", "belem 3 1 1");
  log_broken("belem 4 1 1", "belem 5 1 1");
  log_broken("0 1 2 3", "0 1 2 4");
  log_broken("0 1 2 3", "0 1 2 3.");
  log_broken("0 0 1 0", "0 0 1");
  log_broken("0 0 1 0", "0 0 1 0 0");
  log_broken("0 0 1 0", "0 0 0.94 0");
  log_broken("set 2 node", "set 3 node");
  log_broken("set 2 node", "set 2 edge");
  log_broken("left 0 2", "left 0 4");
  log_broken("set 1 side rim 0 3", "set 1 node left 0");
  log_broken("set 2", "sets 2");
  log_truncated("node 0 10E-1 0 1\n");
  log_truncated("0 1 0 0\n0 0");
  log_truncated("0 1 0 0\n");
  log_truncated("set 2 node left 0");
  log_error("no-such-file.iga");
  log_error(".");
  log_error("square.iga", 0.);
  log_error("square.iga", std::nan(""));

  try
  {
    write_iga(square, "no-such-directory/square.iga");
  }
  catch (const InputError &error)
  {
    tests::log() << error.what() << std::endl;
  }
}
