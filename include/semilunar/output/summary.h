// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_output_summary_h
#define semilunar_output_summary_h

#include <semilunar/core/run_context.h>

#include <filesystem>

namespace semilunar::output
{
  /// What a run says about itself in the end.
  struct Summary
  {
    std::string scene; ///< kind of scene
    RunResults results;
    Cost cost;
    std::map<std::string, double> phases; ///< seconds by name
    std::string version;
  };

  /// The summary as JSON; numbers that are not finite become null.
  std::string to_json(const Summary &summary);

  /// Write summary.json, last of all files: a folder that has it holds a complete run.
  /// On the first rank; collective.
  void write_summary(const std::filesystem::path &folder, const Summary &summary);
} // namespace semilunar::output

#endif
