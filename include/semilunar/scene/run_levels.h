// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_scene_run_levels_h
#define semilunar_scene_run_levels_h

#include <semilunar/core/log.h>
#include <semilunar/core/parameter_input.h>

#include <filesystem>

namespace semilunar::scene
{
  /// Run a scene at several resolutions into folder/level-0, level-1, ... and write speed against
  /// error and a summary with error estimates into the folder. If a level fails numerically, those
  /// before it are reported.
  /// @throws InputError, NumericsError
  void run_levels(const ParameterInput &input, unsigned int n_levels,
                  const std::filesystem::path &folder, bool dry_run, Log &log);
} // namespace semilunar::scene

#endif
