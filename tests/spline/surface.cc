// SPDX-License-Identifier: LGPL-2.1-or-later
// Uniting surfaces, their connected parts, and what check() complains about.
#include "../tests.h"
#include <semilunar/core/exceptions.h>
#include <semilunar/spline/evaluation.h>
#include <semilunar/spline/primitives.h>

#include <functional>
#include <limits>

using namespace semilunar;
using spline::Surface;

namespace
{
  /// A cubic piece of a cylinder with 3 x 2 elements.
  Surface piece(const double begin, const double end)
  {
    spline::NurbsPatch patch = spline::cylinder(1., begin, end, 0., 1.);
    patch.elevate_degree(0, 1);
    patch.elevate_degree(1, 2);
    patch.refine_to(0, 3);
    patch.refine_to(1, 2);
    return to_surface(patch);
  }

  void log_parts(const std::string &what, const Surface &surface)
  {
    tests::log() << what << ": " << surface.control_points.size() << " control points, parts";
    for (const unsigned int part : connected_parts(surface))
      tests::log() << ' ' << part;
    tests::log() << std::endl;
  }

  double radius_error(const Surface &surface)
  {
    double error = 0.;
    for (unsigned int e = 0; e < surface.elements.size(); ++e)
    {
      const auto x = spline::evaluate(surface, {e, {0.3, 0.9}})[spline::value];
      error = std::max(error, std::abs(std::hypot(x[0], x[1]) - 1.));
    }
    return error;
  }

  void log_complaint(const std::function<void(Surface &)> &spoil)
  {
    Surface surface = piece(0., 1.);
    spoil(surface);
    try
    {
      check(surface, "shell.iga");
      tests::log() << "NO COMPLAINT" << std::endl;
    }
    catch (const InputError &error)
    {
      tests::log() << error.what() << std::endl;
    }
  }
} // namespace

int main()
{
  const Surface first = piece(0., 1.), second = piece(1., 2.), apart = piece(3., 4.);
  log_parts("one piece", first);

  Surface merged = first;
  append(merged, second, 1e-9);
  check(merged, "merged");
  log_parts("sharing an edge", merged);
  append(merged, apart, 1e-9);
  log_parts("and one apart", merged);
  tests::check("still a cylinder", radius_error(merged), 1e-14);

  Surface separate = first;
  append(separate, second, -1.);
  log_parts("nothing merged", separate);
  tests::check("still a cylinder", radius_error(separate), 1e-14);

  Surface weighted = second; // the common edge with another weight
  for (spline::ControlPoint &point : weighted.control_points)
    point.weight *= 1.5;
  append(weighted, first, 1e-9);
  log_parts("unequal weights", weighted);

  Surface moved = second;
  for (spline::ControlPoint &point : moved.control_points)
    point.position[2] += 1e-3;
  Surface near = first, far = first;
  append(near, moved, 1.0001e-3);
  append(far, moved, 0.9999e-3);
  tests::log() << "merged at a distance of 1e-3: " << near.control_points.size()
               << " left with the larger tolerance, " << far.control_points.size()
               << " with the smaller" << std::endl;

  Surface twice = first;
  twice.sets.push_back({spline::SetKind::side, "rim", {0, 2, 1, 2}});
  twice.sets.push_back({spline::SetKind::element, "corner", {5}});
  const Surface copy = twice;
  append(twice, copy, 0.);
  tests::log() << "appended to itself: " << twice.control_points.size() << " control points, left "
               << twice.find_set(spline::SetKind::node, "left")->members.size() << ", rim";
  for (const unsigned int member : twice.find_set(spline::SetKind::side, "rim")->members)
    tests::log() << ' ' << member;
  tests::log() << ", corner";
  for (const unsigned int member : twice.find_set(spline::SetKind::element, "corner")->members)
    tests::log() << ' ' << member;
  tests::log() << ", other kind "
               << (twice.find_set(spline::SetKind::node, "rim") == nullptr ? "absent" : "FOUND")
               << std::endl;

  log_complaint([](Surface &s) { s.elements.clear(); });
  log_complaint([](Surface &s) { s.control_points[7].weight = 0.; });
  log_complaint([](Surface &s)
                { s.control_points[3].position[1] = std::numeric_limits<double>::infinity(); });
  log_complaint([](Surface &s) { s.elements[2].control_points[5] = 30; });
  log_complaint([](Surface &s) { s.elements[2].degree[1] = 11; });
  log_complaint([](Surface &s) { s.elements[4].extraction.pop_back(); });
  log_complaint([](Surface &s) { s.elements[4].extraction[18] += 0.06; });
  log_complaint([](Surface &s) { s.elements[5].extraction[0] = std::nan(""); });
  log_complaint([](Surface &s) { s.sets[1].members[0] = 31; });
  log_complaint([](Surface &s) { s.sets.push_back({spline::SetKind::side, "rim", {0, 4}}); });
  log_complaint([](Surface &s) { s.sets.push_back({spline::SetKind::side, "rim", {0}}); });
}
