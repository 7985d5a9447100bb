// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/nearest_name.h>

#include <algorithm>
#include <cctype>
#include <numeric>

namespace semilunar
{
  namespace
  {
    std::string lower(std::string text)
    {
      std::transform(text.begin(), text.end(), text.begin(),
                     [](const unsigned char c) { return std::tolower(c); });
      return text;
    }

    /// Levenshtein distance: insertions, deletions and replacements of single characters.
    std::size_t edit_distance(const std::string &a, const std::string &b)
    {
      std::vector<std::size_t> row(b.size() + 1);
      std::iota(row.begin(), row.end(), 0);
      for (std::size_t i = 0; i < a.size(); ++i)
      {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j)
        {
          const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
          diagonal = row[j + 1];
          row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
        }
      }
      return row.back();
    }
  } // namespace

  std::string nearest_name(const std::string &name, const std::vector<std::string> &candidates)
  {
    std::string best;
    // One slip in three characters; beyond that a suggestion would only mislead.
    std::size_t best_distance = std::max<std::size_t>(2, name.size() / 3) + 1;
    for (const std::string &candidate : candidates)
    {
      const std::size_t distance = edit_distance(lower(name), lower(candidate));
      if (distance < best_distance && distance < candidate.size())
      {
        best = candidate;
        best_distance = distance;
      }
    }
    return best;
  }

  std::string suggest(const std::string &name, const std::vector<std::string> &candidates)
  {
    const std::string nearest = nearest_name(name, candidates);
    if (!nearest.empty())
      return "did you mean '" + nearest + "'?";
    return candidates.empty() ? "" : "known are " + quoted_list(candidates);
  }

  std::string quoted_list(const std::vector<std::string> &names)
  {
    std::string text;
    for (const std::string &name : names)
      text += (text.empty() ? "'" : ", '") + name + "'";
    return text;
  }
} // namespace semilunar
