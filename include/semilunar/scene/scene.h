// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_scene_scene_h
#define semilunar_scene_scene_h

#include <semilunar/scene/levels.h>
#include <semilunar/scene/study.h>

namespace semilunar::scene
{
  /// A kind of simulation: its parameters and how to run it. A scene builds only the rooms it
  /// needs.
  class Scene
  {
  public:
    virtual ~Scene() = default;

    LevelsParameters levels;
    StudyParameters study;

    /// Declare all entries but those of levels and studies, and bind them to the scene's members.
    virtual void add_parameters(dealii::ParameterHandler &prm) = 0;

    /// What "finer" means unless the scene file says so: the default of Levels/Finer.
    virtual std::string finer() const { return ""; }

    /// Whether the scene writes checkpoints and can go on from them.
    virtual bool can_restart() const { return false; }

    /// After all entries were read: what no single entry can tell.
    /// @throws InputError whose place is the "Section/Entry" to change
    virtual void check() const {}

    /// Compute, write into the folder of the context and fill its results. On a dry run: build and
    /// check, report sizes, then return. Stop at the next accepted state once interrupted().
    /// @throws InputError, NumericsError
    virtual void run(RunContext &context) = 0;
  };
} // namespace semilunar::scene

#endif
