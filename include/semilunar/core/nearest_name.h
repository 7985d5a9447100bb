// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_core_nearest_name_h
#define semilunar_core_nearest_name_h

#include <string>
#include <vector>

namespace semilunar
{
  /// The candidate with the smallest edit distance to the name (upper and lower case count as
  /// equal), or "" if even that one is too far away to be what was meant.
  std::string nearest_name(const std::string &name, const std::vector<std::string> &candidates);

  /// "did you mean 'x'?" for the nearest candidate, or else a list of all of them.
  std::string suggest(const std::string &name, const std::vector<std::string> &candidates);

  /// 'a', 'b', 'c'
  std::string quoted_list(const std::vector<std::string> &names);
} // namespace semilunar

#endif
