// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/core/nearest_name.h>
#include <semilunar/scene/displacement_limits.h>
#include <semilunar/shell/location.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>

namespace semilunar::scene
{
  DisplacementLimits::DisplacementLimits(const std::string &list,
                                         const std::vector<std::string> &names)
  {
    const std::string entry = "Solver/Stop at";
    for (const std::string &item : dealii::Utilities::split_string_list(list, ';'))
      if (!item.empty())
      {
        const auto parts = dealii::Utilities::split_string_list(item, ':');
        if (parts.size() != 2)
          throw InputError(entry, item, "this is no displacement", "write NAME_ux: VALUE");
        const auto found = std::find(names.begin(), names.end(), parts[0]);
        if (found == names.end())
          throw InputError(entry, parts[0], "no probe records this",
                           "name a probe and its component: " + suggest(parts[0], names));
        limits.push_back({static_cast<unsigned int>(found - names.begin()),
                          std::abs(shell::parse_number(parts[1], entry))});
      }
  }

  bool DisplacementLimits::reached(const std::vector<double> &values) const
  {
    return std::any_of(limits.begin(), limits.end(),
                       [&](const Limit &limit)
                       { return std::abs(values[limit.component]) >= limit.value; });
  }
} // namespace semilunar::scene
