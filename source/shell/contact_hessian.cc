// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/shell/contact.h>
#include <semilunar/shell/pair_block.h>

#include <algorithm>
#include <tuple>

namespace semilunar::shell
{
  using namespace spline;

  namespace
  {
    /// An active contact point and the two elements that meet there, in ascending order.
    struct Meeting
    {
      unsigned int lower, upper;
      unsigned int active; // index among the active points
      bool operator<(const Meeting &other) const
      {
        return std::tie(lower, upper, active) < std::tie(other.lower, other.upper, other.active);
      }
    };

    std::vector<unsigned int> control_points_of(const BezierElement &a, const BezierElement &b)
    {
      std::vector<unsigned int> result = a.control_points;
      result.insert(result.end(), b.control_points.begin(), b.control_points.end());
      return result;
    }
  } // namespace

  SecondVariation Contact::energy_variation(const unsigned int contact_point) const
  {
    const ContactPoint &point = near[contact_point];
    const double half_weight = 0.5 * points.weight(point.q);
    SecondVariation form =
        second_variation(details[contact_point].foot, details[contact_point].side);
    for (auto &row : form)
      for (auto &block : row)
        block *= -half_weight * point.pressure;
    form[0][0] += half_weight * law.slope(-point.gap) * outer_product(point.normal, point.normal);
    return form;
  }

  void Contact::add_hessian(const AddBlock &add) const
  {
    std::vector<Meeting> meetings;
    for (unsigned int k = 0; k < active.size(); ++k)
    {
      const ContactPoint &point = near[active[k]];
      const auto [lower, upper] = std::minmax({points.element(point.q), point.partner.element});
      meetings.push_back({lower, upper, k});
    }
    std::sort(meetings.begin(), meetings.end());

    PairBlock block;
    std::vector<double> matrix;
    for (std::size_t begin = 0, end = 0; begin < meetings.size(); begin = end)
    {
      const unsigned int lower = meetings[begin].lower, upper = meetings[begin].upper;
      const BezierElement &first = surface.elements[lower], &second = surface.elements[upper];
      block.reinit({{first.n_functions(), second.n_functions()}});
      for (; end < meetings.size() && meetings[end].lower == lower && meetings[end].upper == upper;
           ++end)
      {
        const unsigned int k = meetings[end].active, q = near[active[k]].q;
        block.add(points.element(q) == lower ? 0 : 1, points.basis(q, spline::value),
                  partner_bases.data() + partner_offsets[k], energy_variation(active[k]));
      }
      block.copy_to(matrix);
      add(control_points_of(first, second), matrix);
    }
  }
} // namespace semilunar::shell
