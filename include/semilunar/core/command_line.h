// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_core_command_line_h
#define semilunar_core_command_line_h

#include <semilunar/core/parameters.h>

namespace semilunar
{
  /// The arguments of the program.
  struct CommandLine
  {
    enum class Action
    {
      run,
      help,
      version,
      list_scenes,
      print_parameters
    };

    Action action = Action::run;
    std::string scene_file;
    std::vector<std::string> overrides; ///< "Section/Entry=value"
    std::string output_folder;          ///< "" if not given
    unsigned int n_levels = 0;          ///< resolutions to compare; 0: a plain run
    bool study = false;                 ///< vary entries one at a time
    bool dry_run = false;
    bool restart = false; ///< go on from the checkpoint in the output folder
    bool quiet = false;
    std::string kind; ///< whose parameters to print
    ParameterFormat format = ParameterFormat::prm;

    /// @param arguments without the name of the program
    /// @throws InputError naming the argument, and the nearest option if it is unknown
    static CommandLine parse(const std::vector<std::string> &arguments);
  };

  /// The text of --help.
  std::string usage();
} // namespace semilunar

#endif
