// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/checkpoint.h>
#include <semilunar/core/exceptions.h>
#include <semilunar/core/interrupt.h>
#include <semilunar/core/version.h>
#include <semilunar/output/run_folder.h>
#include <semilunar/output/summary.h>
#include <semilunar/scene/registry.h>
#include <semilunar/scene/run_once.h>

namespace semilunar::scene
{
  namespace
  {
    void check_restart(const Scene &scene, const std::filesystem::path &folder)
    {
      if (!scene.can_restart())
        throw InputError("--restart", "", "scenes of this kind write no checkpoints",
                         "run it without --restart");
      if (!has_checkpoint(folder))
        throw InputError("--restart", folder.string(), "the folder holds no checkpoint",
                         "give the folder of a run that wrote one with --output");
    }

    void run_in_folder(PreparedScene &prepared, RunContext &context)
    {
      const std::vector<Reference> references = parse_references(prepared.scene->levels.references);
      if (context.restart)
      {
        check_restart(*prepared.scene, context.folder);
        output::write_parameters(context.folder, prepared.prm, version());
      }
      else
        create_folder(context.folder, prepared.prm);
      prepared.scene->run(context);
      if (interrupted())
        throw NumericsError(
            has_checkpoint(context.folder) ? "the run was interrupted; --restart goes on with it"
                                           : "the run was interrupted",
            "step " + std::to_string(context.results.steps), context.folder.string());
      compare(context.results, references);
      output::write_summary(context.folder, {prepared.kind, context.results, context.timers.cost(),
                                             context.timers.seconds(), version()});
      check_references(context.results, references); // now that nothing can be lost
    }
  } // namespace

  PreparedScene::PreparedScene(const ParameterInput &input)
      : kind(input.find("Scene")->value), scene(declare_scene(kind, input.locate("Scene"), prm))
  {
    assign(input, prm, kinds_with_section);
  }

  void create_folder(const std::filesystem::path &folder, const dealii::ParameterHandler &prm)
  {
    output::create_run_folder(folder);
    output::write_parameters(folder, prm, version());
  }

  output::LevelRun run_once(const ParameterInput &input, const std::filesystem::path &folder,
                            const bool dry_run, Log &log, const bool restart)
  {
    PreparedScene prepared(input);
    Timers timers;
    RunContext context{folder, dry_run, log, timers, restart};
    try
    {
      prepared.scene->check();
      if (dry_run)
        prepared.scene->run(context);
      else
        run_in_folder(prepared, context);
    }
    catch (const InputError &error)
    {
      throw error.at(input.locate(error.where()));
    }
    return {0, 1., context.results, timers.cost()};
  }
} // namespace semilunar::scene
