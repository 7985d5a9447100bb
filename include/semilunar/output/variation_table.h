// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_output_variation_table_h
#define semilunar_output_variation_table_h

#include <semilunar/core/parameters.h>
#include <semilunar/core/run_context.h>

#include <filesystem>
#include <string>
#include <vector>

namespace semilunar::output
{
  /// A run of a study, with one entry changed.
  struct VariedRun
  {
    std::string name;         ///< of its folder
    std::string entry, value; ///< empty: the base of the study
    RunResults results;
    Cost cost;
    std::string failure; ///< why it failed; empty: it did not
  };

  /// Write study.csv, a row for each run, and study.svg, the magnitude of the first quantity over
  /// each entry that is a positive number. On the first rank; collective.
  /// @param quantities which; empty: all of the first run
  /// @param entries    with the values of the base
  void write_variations(const std::filesystem::path &folder, const std::vector<VariedRun> &runs,
                        std::vector<std::string> quantities,
                        const std::vector<ParameterDescription> &entries);
} // namespace semilunar::output

#endif
