// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/spline/bernstein.h>
#include <semilunar/spline/surface_check.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace semilunar::spline
{
  namespace
  {
    /// A defect without its place, which the caller knows.
    struct Complaint
    {
      std::string value, problem, remedy;
    };

    std::string to_string(const double x)
    {
      std::ostringstream out;
      out << x;
      return out.str();
    }

    std::optional<Complaint> complaint(const ControlPoint &point)
    {
      for (unsigned int d = 0; d < 3; ++d)
        if (!std::isfinite(point.position[d]))
          return Complaint{to_string(point.position[d]), "the coordinate is not finite", ""};
      if (!(point.weight > 0.) || !std::isfinite(point.weight))
        return Complaint{to_string(point.weight), "the weight is not positive and finite", ""};
      return {};
    }

    std::optional<Complaint> sizes_complaint(const BezierElement &element,
                                             const unsigned int n_control_points)
    {
      for (const unsigned int p : element.degree)
        if (p < 1 || p > max_degree)
          return Complaint{std::to_string(p), "the degree is not supported",
                           "degrees from 1 to " + std::to_string(max_degree) + " are"};
      if (element.n_functions() == 0)
        return Complaint{"0", "the element has no functions", ""};
      for (const unsigned int i : element.control_points)
        if (i >= n_control_points)
          return Complaint{std::to_string(i), "there is no such control point",
                           "there are " + std::to_string(n_control_points) + ", counted from 0"};
      const std::size_t expected = std::size_t(element.n_functions()) * element.n_bernstein();
      if (element.extraction.size() != expected)
        return Complaint{std::to_string(element.extraction.size()),
                         "wrong number of extraction coefficients",
                         std::to_string(expected) + " are needed"};
      return {};
    }

    /// Since the B_b sum to one, the N_a do if and only if every column of C does.
    std::optional<Complaint> partition_complaint(const BezierElement &element)
    {
      std::array<double, (max_degree + 1) * (max_degree + 1)> sums;
      const unsigned int m = element.n_bernstein();
      std::fill_n(sums.begin(), m, 0.);
      const double *c = element.extraction.data();
      for (unsigned int a = 0; a < element.n_functions(); ++a, c += m)
        for (unsigned int b = 0; b < m; ++b)
          sums[b] += c[b];
      for (unsigned int b = 0; b < m; ++b)
        if (!(std::abs(sums[b] - 1.) <= partition_of_unity_tolerance))
          return Complaint{to_string(sums[b]),
                           "the extraction coefficients of Bernstein polynomial " +
                               std::to_string(b) + " do not sum to one",
                           "within " + to_string(partition_of_unity_tolerance) + " is allowed"};
      return {};
    }

    std::optional<Complaint> complaint(const BezierElement &element,
                                       const unsigned int n_control_points)
    {
      if (const auto wrong = sizes_complaint(element, n_control_points))
        return wrong;
      for (const double c : element.extraction)
        if (!std::isfinite(c))
          return Complaint{to_string(c), "the extraction coefficient is not finite", ""};
      return partition_complaint(element);
    }

    std::optional<Complaint> complaint(const NamedSet &set, const Surface &surface)
    {
      if (set.kind == SetKind::side && set.members.size() % 2 != 0)
        return Complaint{set.name, "the side set has an odd number of entries",
                         "it lists pairs of element and side"};
      for (unsigned int k = 0; k < set.members.size(); ++k)
      {
        const bool is_side = set.kind == SetKind::side && k % 2 == 1;
        const std::size_t end = is_side                     ? 4
                                : set.kind == SetKind::node ? surface.control_points.size()
                                                            : surface.elements.size();
        if (set.members[k] >= end)
          return Complaint{std::to_string(set.members[k]),
                           "set " + set.name + " has no such member",
                           "there are " + std::to_string(end) + ", counted from 0"};
      }
      return {};
    }

    SurfaceDefect at(const SurfaceDefect::Place place, const unsigned int index,
                     const Complaint &complaint)
    {
      return {place, index, complaint.value, complaint.problem, complaint.remedy};
    }
  } // namespace

  std::optional<SurfaceDefect> first_defect(const Surface &surface)
  {
    for (unsigned int i = 0; i < surface.control_points.size(); ++i)
      if (const auto wrong = complaint(surface.control_points[i]))
        return at(SurfaceDefect::control_point, i, *wrong);
    for (unsigned int e = 0; e < surface.elements.size(); ++e)
      if (const auto wrong = complaint(surface.elements[e], surface.control_points.size()))
        return at(SurfaceDefect::element, e, *wrong);
    for (unsigned int s = 0; s < surface.sets.size(); ++s)
      if (const auto wrong = complaint(surface.sets[s], surface))
        return at(SurfaceDefect::set, s, *wrong);
    return {};
  }

  void check(const Surface &surface, const std::string &source)
  {
    if (surface.elements.empty())
      throw InputError(source, "", "the surface has no elements", "");
    const char *const places[] = {"control point", "element", "set"};
    if (const auto defect = first_defect(surface))
      throw InputError(source + ", " + places[defect->place] + " " + std::to_string(defect->index),
                       defect->value, defect->problem, defect->remedy);
  }
} // namespace semilunar::spline
