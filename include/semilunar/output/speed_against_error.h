// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_output_speed_against_error_h
#define semilunar_output_speed_against_error_h

#include <semilunar/core/error_estimate.h>
#include <semilunar/core/run_context.h>

#include <filesystem>

namespace semilunar::output
{
  /// A run at one of several resolutions.
  struct LevelRun
  {
    unsigned int level; ///< 0 is the coarsest
    double size;        ///< mesh size or time step, only its ratio to other runs' matters
    RunResults results;
    Cost cost;
  };

  /// A quantity at all resolutions.
  struct QuantityStudy
  {
    std::string name, unit;
    double reference; ///< NaN if there is none
    std::vector<double> values;
    ErrorEstimate estimate;
  };

  /// The quantities that all runs have, with their errors.
  std::vector<QuantityStudy> study_quantities(const std::vector<LevelRun> &runs);

  /// Write speed_vs_error.csv, a row for each quantity and run, and speed_vs_error.svg, relative
  /// errors over processor seconds. On the first rank; collective.
  void write_speed_against_error(const std::filesystem::path &folder,
                                 const std::vector<LevelRun> &runs,
                                 const std::vector<QuantityStudy> &studies);
} // namespace semilunar::output

#endif
