// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/shell/contact_search.h>
#include <semilunar/shell/free_sides.h>

#include <deal.II/base/parallel.h>

#include <algorithm>
#include <limits>
#include <tuple>

namespace semilunar::shell
{
  using namespace spline;

  namespace
  {
    /// Call work(i) for all i below n, on all threads.
    template <typename Work>
    void for_each(const std::size_t n, const Work &work)
    {
      constexpr unsigned int grain = 64;
      dealii::parallel::apply_to_subranges(
          std::size_t(0), n,
          [&](const std::size_t begin, const std::size_t end)
          {
            for (std::size_t i = begin; i < end; ++i)
              work(i);
          },
          grain);
    }

    std::vector<BezierPatch> bezier_patches(const Surface &surface,
                                            const std::vector<Tensor<1, 3>> &x)
    {
      std::vector<BezierPatch> patches(surface.elements.size());
      for_each(patches.size(),
               [&](const std::size_t e) { patches[e] = bezier_patch(surface, e, x); });
      return patches;
    }

    BezierPatch turned(BezierPatch patch, const dealii::Tensor<2, 3> &turn)
    {
      for (auto &coefficient : patch.coefficients)
      {
        const auto x = turn * Tensor<1, 3>({coefficient[0], coefficient[1], coefficient[2]});
        std::copy(x.begin_raw(), x.end_raw(), coefficient.begin());
      }
      return patch;
    }

    std::vector<Tensor<1, 3>> point_positions(const Surface &surface,
                                              const QuadraturePoints &points,
                                              const std::vector<Tensor<1, 3>> &x)
    {
      std::vector<Tensor<1, 3>> result(points.n_points());
      for_each(result.size(),
               [&](const std::size_t q)
               {
                 const BezierElement &element = surface.elements[points.element(q)];
                 const double *basis = points.basis(q, spline::value);
                 for (unsigned int a = 0; a < element.n_functions(); ++a)
                   result[q] += basis[a] * x[element.control_points[a]];
               });
      return result;
    }
  } // namespace

  ContactSearch::ContactSearch(const Surface &surface, const QuadraturePoints &points,
                               const double reach, const double self_distance,
                               const CyclicSymmetry &symmetry)
      : surface(surface), points(points), reach(reach), self_distance(self_distance),
        symmetry(symmetry), parts(connected_parts(surface)),
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
    const std::size_t n_elements = patches.size();
    patches.resize(symmetry.n_sectors() * n_elements);
    boxes.resize(patches.size());
    std::vector<SpatialHash::Box> within_reach(patches.size());
    Tensor<1, 3> margin;
    for (unsigned int d = 0; d < 3; ++d)
      margin[d] = reach;
    for_each(
        patches.size(),
        [&](const std::size_t p)
        {
          if (p >= n_elements)
            patches[p] = turned(patches[p % n_elements], symmetry.turn(p / n_elements));
          boxes[p] = OrientedBox(patches[p]);
          within_reach[p] = {boxes[p].lower_corner() - margin, boxes[p].upper_corner() + margin};
        });
    hash.build(within_reach, reach);
  }

  Tensor<1, 3> ContactSearch::undeformed_position(const SurfacePoint &point) const
  {
    return evaluate(undeformed[point.element], point.xi)[spline::value];
  }

  bool ContactSearch::may_be_neighbors(const unsigned int q, const unsigned int patch) const
  {
    if (patch >= parts.size() || parts[patch] != parts[points.element(q)])
      return true;
    return self_distance > 0. && patch != points.element(q);
  }

  void ContactSearch::gather(const unsigned int q, std::vector<Candidate> &candidates) const
  {
    candidates.clear();
    for (const unsigned int patch : hash.near(x_q[q]))
      if (may_be_neighbors(q, patch))
      {
        const double lower_bound = boxes[patch].distance(x_q[q]);
        const unsigned int image = patch / parts.size();
        if (lower_bound < reach)
          candidates.push_back(
              {parts[patch % parts.size()] + image * number_of_parts, patch, lower_bound});
      }
    // part by part, the most promising element first
    std::sort(candidates.begin(), candidates.end(),
              [](const Candidate &a, const Candidate &b) {
                return std::tie(a.part, a.lower_bound, a.patch) <
                       std::tie(b.part, b.lower_bound, b.patch);
              });
  }

  Point<2> ContactSearch::starting_point(const unsigned int patch, const Tensor<1, 3> &x) const
  {
    if (!boxes[patch].is_strongly_curved())
      return boxes[patch].guess(x);

    constexpr unsigned int n_samples = 4; // per direction
    double smallest = std::numeric_limits<double>::max();
    Point<2> nearest;
    for (unsigned int j = 0; j < n_samples; ++j)
      for (unsigned int i = 0; i < n_samples; ++i)
      {
        const Point<2> xi((i + 0.5) / n_samples, (j + 0.5) / n_samples);
        const double square = (evaluate(patches[patch], xi)[spline::value] - x).norm_square();
        if (square < smallest)
        {
          smallest = square;
          nearest = xi;
        }
      }
    return nearest;
  }

  bool ContactSearch::is_admissible(const unsigned int q, const Neighbor &neighbor) const
  {
    const auto &[part, image, point, foot] = neighbor;
    if (part != parts[points.element(q)])
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
          project(patches[candidate.patch], x_q[q], starting_point(candidate.patch, x_q[q]));
      ++n_projections;
      if (!(projection.distance < limit))
        continue;
      const unsigned int n_elements = parts.size();
      const Neighbor neighbor{candidate.part,
                              candidate.patch / n_elements,
                              {candidate.patch % n_elements, projection.xi},
                              ContactFoot(projection, x_q[q])};
      if (!is_admissible(q, neighbor))
        continue;
      if (is_first)
        neighbors.emplace_back();
      neighbors.back() = neighbor;
    }
    return n_projections;
  }
} // namespace semilunar::shell
