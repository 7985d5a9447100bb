// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_scene_run_once_h
#define semilunar_scene_run_once_h

#include <semilunar/output/speed_against_error.h>
#include <semilunar/scene/scene.h>

#include <memory>

namespace semilunar::scene
{
  /// A scene with its entries, ready to run.
  struct PreparedScene
  {
    std::string kind;
    dealii::ParameterHandler prm; ///< bound to the scene's members
    std::unique_ptr<Scene> scene;

    /// @throws InputError for entries that the scene does not have or allow
    explicit PreparedScene(const ParameterInput &input);
  };

  /// Make the folder and write the entries as the run uses them.
  void create_folder(const std::filesystem::path &folder, const dealii::ParameterHandler &prm);

  /// Run a scene into a folder, or build and check it if this is a dry run. A restart goes on in
  /// the folder from its last checkpoint.
  /// @return what the run says about itself, as level 0
  /// @throws InputError with the place where the entry was written; NumericsError
  output::LevelRun run_once(const ParameterInput &input, const std::filesystem::path &folder,
                            bool dry_run, Log &log, bool restart = false);
} // namespace semilunar::scene

#endif
