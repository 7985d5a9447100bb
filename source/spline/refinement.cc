// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/spline/nurbs_patch.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace semilunar::spline
{
  namespace
  {
    /// Widths closer than this (relative) count as equal: they differ by round-off.
    constexpr double equal_widths = 1e-9;

    using Counts = std::vector<unsigned int>;

    /// Into how many equal parts to divide each element so that there are n in all: the widest part
    /// is made narrower again and again; among equals, those that are spread evenly.
    Counts distribute(const std::vector<double> &widths, const unsigned int n)
    {
      Counts counts(widths.size(), 1);
      for (unsigned int left = n - widths.size(); left > 0;)
      {
        double widest = 0.;
        for (unsigned int e = 0; e < widths.size(); ++e)
          widest = std::max(widest, widths[e] / counts[e]);
        std::vector<unsigned int> group;
        for (unsigned int e = 0; e < widths.size(); ++e)
          if (widths[e] / counts[e] >= (1. - equal_widths) * widest)
            group.push_back(e);
        const unsigned int chosen = std::min<unsigned int>(left, group.size());
        for (unsigned int k = 0; k < chosen; ++k)
          ++counts[group[(2 * k + 1) * group.size() / (2 * chosen)]];
        left -= chosen;
      }
      return counts;
    }

    bool is_symmetric(const std::vector<double> &widths)
    {
      const double total = std::accumulate(widths.begin(), widths.end(), 0.);
      for (unsigned int e = 0; e < widths.size() / 2; ++e)
        if (std::abs(widths[e] - widths[widths.size() - 1 - e]) > equal_widths * total)
          return false;
      return true;
    }

    /// Whether the first distribution has the narrower widest part or, if those are equal, the
    /// smaller sum of squared widths.
    bool is_better(const std::vector<double> &widths, const Counts &first, const Counts &second)
    {
      const auto measures = [&widths](const Counts &counts)
      {
        std::array<double, 2> result{};
        for (unsigned int e = 0; e < widths.size(); ++e)
        {
          result[0] = std::max(result[0], widths[e] / counts[e]);
          result[1] += widths[e] * widths[e] / counts[e];
        }
        return result;
      };
      const auto a = measures(first), b = measures(second);
      if (std::abs(a[0] - b[0]) > equal_widths * b[0])
        return a[0] < b[0];
      return a[1] < b[1];
    }

    /// The best distribution that is its own mirror image; empty if there is none.
    Counts distribute_symmetrically(const std::vector<double> &widths, const unsigned int n)
    {
      const unsigned int n_pairs = widths.size() / 2, n_middle = widths.size() % 2;
      const std::vector<double> half(widths.begin(), widths.begin() + n_pairs);
      Counts best;
      for (unsigned int middle = n_middle; middle + 2 * n_pairs <= n; ++middle)
      {
        const bool fits = (n - middle) % 2 == 0 && (n_pairs > 0 || middle == n);
        if (fits)
        {
          const Counts one_side = distribute(half, (n - middle) / 2);
          Counts counts = one_side;
          if (n_middle == 1)
            counts.push_back(middle);
          counts.insert(counts.end(), one_side.rbegin(), one_side.rend());
          if (best.empty() || is_better(widths, counts, best))
            best = counts;
        }
        if (n_middle == 0)
          break;
      }
      return best;
    }
  } // namespace

  void NurbsPatch::refine_to(const unsigned int direction, const unsigned int n_elements)
  {
    const std::vector<double> points = knot_vectors[direction].breakpoints();
    if (points.size() - 1 > n_elements)
      throw InputError("number of elements", std::to_string(n_elements),
                       "the patch has more already",
                       "at least " + std::to_string(points.size() - 1) + " are needed");
    std::vector<double> widths;
    for (unsigned int e = 0; e + 1 < points.size(); ++e)
      widths.push_back(points[e + 1] - points[e]);

    Counts counts;
    if (is_symmetric(widths))
      counts = distribute_symmetrically(widths, n_elements);
    if (counts.empty())
      counts = distribute(widths, n_elements);

    std::vector<double> new_knots;
    for (unsigned int e = 0; e < widths.size(); ++e)
      for (unsigned int k = 1; k < counts[e]; ++k)
        new_knots.push_back(points[e] + widths[e] * k / counts[e]);
    insert_knots(direction, new_knots);
  }
} // namespace semilunar::spline
