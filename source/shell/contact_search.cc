// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/shell/contact_search.h>
#include <semilunar/shell/free_sides.h>

#include <algorithm>
#include <limits>
#include <tuple>

namespace semilunar::shell
{
  using namespace spline;

  namespace
  {
    std::vector<BezierPatch> bezier_patches(const Surface &surface,
                                            const std::vector<Tensor<1, 3>> &x)
    {
      std::vector<BezierPatch> patches;
      patches.reserve(surface.elements.size());
      for (unsigned int e = 0; e < surface.elements.size(); ++e)
        patches.push_back(bezier_patch(surface, e, x));
      return patches;
    }

    std::vector<Tensor<1, 3>> point_positions(const Surface &surface,
                                              const QuadraturePoints &points,
                                              const std::vector<Tensor<1, 3>> &x)
    {
      std::vector<Tensor<1, 3>> result(points.n_points());
      for (unsigned int q = 0; q < points.n_points(); ++q)
      {
        const BezierElement &element = surface.elements[points.element(q)];
        const double *basis = points.basis(q, spline::value);
        for (unsigned int a = 0; a < element.n_functions(); ++a)
          result[q] += basis[a] * x[element.control_points[a]];
      }
      return result;
    }
  } // namespace

  ContactSearch::ContactSearch(const Surface &surface, const QuadraturePoints &points,
                               const double reach, const double self_distance)
      : surface(surface), points(points), reach(reach), self_distance(self_distance),
        parts(connected_parts(surface)),
        number_of_parts(parts.empty() ? 0 : *std::max_element(parts.begin(), parts.end()) + 1)
  {
    const std::vector<Tensor<1, 3>> x = positions(surface);
    undeformed = bezier_patches(surface, x);
    undeformed_x_q = point_positions(surface, points, x);
    if (self_distance > 0.)
      free_sides = shell::free_sides(surface);
  }

  void ContactSearch::update(const std::vector<Tensor<1, 3>> &x)
  {
    x_q = point_positions(surface, points, x);
    patches = bezier_patches(surface, x);
    boxes.clear();
    std::vector<SpatialHash::Box> within_reach;
    Tensor<1, 3> margin;
    for (unsigned int d = 0; d < 3; ++d)
      margin[d] = reach;
    for (const BezierPatch &patch : patches)
    {
      boxes.emplace_back(patch);
      within_reach.push_back(
          {boxes.back().lower_corner() - margin, boxes.back().upper_corner() + margin});
    }
    hash.build(within_reach, reach);
  }

  Tensor<1, 3> ContactSearch::undeformed_position(const SurfacePoint &point) const
  {
    return evaluate(undeformed[point.element], point.xi)[spline::value];
  }

  bool ContactSearch::may_be_neighbors(const unsigned int q, const unsigned int element) const
  {
    if (parts[element] != parts[points.element(q)])
      return true;
    return self_distance > 0. && element != points.element(q);
  }

  void ContactSearch::gather(const unsigned int q, std::vector<Candidate> &candidates) const
  {
    candidates.clear();
    for (const unsigned int element : hash.near(x_q[q]))
      if (may_be_neighbors(q, element))
      {
        const double lower_bound = boxes[element].distance(x_q[q]);
        if (lower_bound < reach)
          candidates.push_back({parts[element], element, lower_bound});
      }
    // part by part, the most promising element first
    std::sort(candidates.begin(), candidates.end(),
              [](const Candidate &a, const Candidate &b)
              {
                return std::tie(a.part, a.lower_bound, a.element) <
                       std::tie(b.part, b.lower_bound, b.element);
              });
  }

  Point<2> ContactSearch::starting_point(const unsigned int element, const Tensor<1, 3> &x) const
  {
    if (!boxes[element].is_strongly_curved())
      return boxes[element].guess(x);

    constexpr unsigned int n_samples = 4; // per direction
    double smallest = std::numeric_limits<double>::max();
    Point<2> nearest;
    for (unsigned int j = 0; j < n_samples; ++j)
      for (unsigned int i = 0; i < n_samples; ++i)
      {
        const Point<2> xi((i + 0.5) / n_samples, (j + 0.5) / n_samples);
        const double square = (evaluate(patches[element], xi)[spline::value] - x).norm_square();
        if (square < smallest)
        {
          smallest = square;
          nearest = xi;
        }
      }
    return nearest;
  }

  bool ContactSearch::is_admissible(const unsigned int q, const SurfacePoint &point,
                                    const ContactFoot &foot) const
  {
    if (parts[point.element] != parts[points.element(q)])
      return true;
    // Next to the excluded surroundings of q, an element's side may hold a foot although the
    // surface goes on.
    for (unsigned int d = 0; d < 2; ++d)
      if (foot.is_held[d] && !free_sides[point.element][2 * d + (point.xi[d] > 0.5)])
        return false;
    return (undeformed_position(point) - undeformed_x_q[q]).norm() > self_distance;
  }

  unsigned int ContactSearch::find(const unsigned int q, std::vector<Neighbor> &neighbors) const
  {
    neighbors.clear();
    thread_local std::vector<Candidate> candidates;
    gather(q, candidates);
    unsigned int n_projections = 0;
    for (const Candidate &candidate : candidates)
    {
      const bool is_first = neighbors.empty() || neighbors.back().part != candidate.part;
      const double limit = is_first ? reach : neighbors.back().foot.distance;
      if (candidate.lower_bound >= limit)
        continue;
      const Projection projection =
          project(patches[candidate.element], x_q[q], starting_point(candidate.element, x_q[q]));
      ++n_projections;
      if (!(projection.distance < limit))
        continue;
      const SurfacePoint point{candidate.element, projection.xi};
      const ContactFoot foot(projection, x_q[q]);
      if (!is_admissible(q, point, foot))
        continue;
      if (is_first)
        neighbors.emplace_back();
      neighbors.back() = {candidate.part, point, foot};
    }
    return n_projections;
  }
} // namespace semilunar::shell
