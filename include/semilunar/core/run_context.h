// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_core_run_context_h
#define semilunar_core_run_context_h

#include <semilunar/core/log.h>
#include <semilunar/core/timers.h>

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace semilunar
{
  /// A number that a user reads off a run.
  struct Quantity
  {
    std::string name; ///< as in max_mipe
    double value;     ///< NaN: does not exist
    std::string unit; ///< as in cm^2; "-" for pure numbers
    double reference = std::numeric_limits<double>::quiet_NaN(); ///< exact or published, if known
    double error = std::numeric_limits<double>::quiet_NaN();     ///< known or estimated, absolute
    double order = std::numeric_limits<double>::quiet_NaN();     ///< of convergence, as observed
  };

  /// What a run reports in its summary.
  struct RunResults
  {
    std::vector<Quantity> quantities;
    unsigned long long unknowns = 0; ///< degrees of freedom of the systems solved
    unsigned int steps = 0;          ///< accepted load or time steps
    unsigned int newton_iterations = 0;
  };

  /// What a scene gets to run.
  struct RunContext
  {
    std::filesystem::path folder; ///< exists, unless this is a dry run
    bool dry_run = false;         ///< build and check everything, report, compute and write nothing
    Log &log;
    Timers &timers;
    bool restart = false; ///< go on from the last checkpoint in the folder
    RunResults results{};
  };
} // namespace semilunar

#endif
