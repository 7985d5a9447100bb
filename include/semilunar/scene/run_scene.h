// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_scene_run_scene_h
#define semilunar_scene_run_scene_h

#include <semilunar/core/command_line.h>

namespace semilunar::scene
{
  /// Read the scene file, make the folder of the run, run the scene and write its summary.
  /// @throws InputError, NumericsError
  void run_scene(const CommandLine &command_line);

  /// Print each kind of scene with its description and the scene files that come with it.
  void list_scenes(std::ostream &out);

  /// Print all entries of a kind of scene. @throws InputError if there is no such kind
  void print_scene_parameters(const std::string &kind, ParameterFormat format, std::ostream &out);
} // namespace semilunar::scene

#endif
