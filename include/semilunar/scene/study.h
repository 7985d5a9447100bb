// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_scene_study_h
#define semilunar_scene_study_h

#include <semilunar/core/log.h>
#include <semilunar/core/parameter_input.h>
#include <semilunar/core/parameters.h>

#include <filesystem>
#include <string>
#include <vector>

namespace semilunar::scene
{
  /// What a scene wants to know about the influence of its entries: the section Study.
  struct StudyParameters
  {
    std::string variations;
    std::string quantities; ///< names separated by commas; "" for all

    void add_parameters(dealii::ParameterHandler &prm);
  };

  /// An entry and a value that it takes in one of the runs.
  struct Variation
  {
    std::string entry, value;
  };

  /// "Section/Entry: 1 | 2 | 3; Other/Entry: 0.1 | 0.2", one after the other.
  /// @throws InputError at Study/Variations for what cannot be read or is no entry
  std::vector<Variation> parse_variations(const std::string &list,
                                          const std::vector<ParameterDescription> &declared);

  /// Run a scene as it is into folder/run-00, then with one entry changed at a time into
  /// folder/run-01, ..., and write a table and a plot of its quantities. Runs that fail
  /// numerically are part of the result.
  /// @throws InputError
  void run_study(const ParameterInput &input, const std::filesystem::path &folder, bool dry_run,
                 Log &log);
} // namespace semilunar::scene

#endif
