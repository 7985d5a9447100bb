// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/shell/contact.h>

#include <algorithm>

namespace semilunar::shell
{
  double Contact::largest_penetration() const
  {
    double largest = 0.;
    for (const unsigned int i : active)
      largest = std::max(largest, -near[i].gap);
    return largest;
  }

  std::vector<double> Contact::pressures() const
  {
    std::vector<double> result(points.n_points(), 0.);
    for (const unsigned int i : active)
      result[near[i].q] = std::max(result[near[i].q], near[i].pressure);
    return result;
  }

  std::vector<double> Contact::gaps() const
  {
    std::vector<double> result(points.n_points(), reach_distance - distance);
    for (const ContactPoint &point : near)
      result[point.q] = std::min(result[point.q], point.gap);
    return result;
  }

  std::vector<double> Contact::contact_areas() const
  {
    std::vector<double> areas(search.n_parts(), 0.);
    const std::vector<double> pressure = pressures();
    for (unsigned int q = 0; q < points.n_points(); ++q)
      if (pressure[q] > 0.)
        areas[search.part(points.element(q))] += points.weight(q);
    return areas;
  }
} // namespace semilunar::shell
