// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_output_run_folder_h
#define semilunar_output_run_folder_h

#include <deal.II/base/parameter_handler.h>

#include <filesystem>

namespace semilunar::output
{
  /// Make the folder of a run. If it holds an earlier run, that run's parameters.prm, summary.json,
  /// tables (*.csv), *.pvd, *.vtu and checkpoints are removed, so that no file of it is taken for a
  /// new one. On the first rank; collective.
  /// @throws InputError if the folder cannot be made, or holds files but no run
  void create_run_folder(const std::filesystem::path &folder);

  /// Write parameters.prm: all entries as this run uses them, itself a valid scene file.
  /// On the first rank; collective.
  void write_parameters(const std::filesystem::path &folder,
                        const dealii::ParameterHandler &parameters, const std::string &version);
} // namespace semilunar::output

#endif
