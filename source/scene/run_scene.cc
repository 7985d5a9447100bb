// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/core/interrupt.h>
#include <semilunar/core/nearest_name.h>
#include <semilunar/core/version.h>
#include <semilunar/scene/registry.h>
#include <semilunar/scene/run_levels.h>
#include <semilunar/scene/run_once.h>
#include <semilunar/scene/run_scene.h>
#include <semilunar/scene/study.h>

#include <algorithm>
#include <ostream>
#include <sstream>

namespace semilunar::scene
{
  namespace fs = std::filesystem;

  namespace
  {
    ParameterInput read_input(const CommandLine &command_line)
    {
      ParameterInput input = ParameterInput::read(command_line.scene_file);
      for (const std::string &argument : command_line.overrides)
        input.override_with(argument);
      if (input.find("Scene") == nullptr)
        throw InputError(command_line.scene_file, "", "the kind of scene is not set",
                         "write 'set Scene = KIND', known are " + quoted_list(scene_kind_names()));
      return input;
    }

    fs::path output_folder(const CommandLine &command_line)
    {
      if (!command_line.output_folder.empty())
        return command_line.output_folder;
      return fs::path("results") / fs::path(command_line.scene_file).stem();
    }

    /// The scene files of a kind, relative to the current directory if they lie below it.
    std::vector<std::string> scene_files(const std::string &kind)
    {
      std::vector<std::string> files;
      std::error_code no_such_folder;
      for (const auto &entry :
           fs::recursive_directory_iterator(scene_file_folder(), no_such_folder))
      {
        if (entry.path().extension() != ".prm")
          continue;
        const ParameterInput input = ParameterInput::read(entry.path().string());
        if (input.find("Scene") != nullptr && input.find("Scene")->value == kind)
          files.push_back(fs::proximate(entry.path()).string());
      }
      std::sort(files.begin(), files.end());
      return files;
    }
  } // namespace

  void run_scene(const CommandLine &command_line)
  {
    const ParameterInput input = read_input(command_line);
    const fs::path folder = output_folder(command_line);
    Log log(command_line.quiet);
    const Timers timers;
    log.line(version());
    catch_interrupts();
    if (command_line.n_levels > 0)
      run_levels(input, command_line.n_levels, folder, command_line.dry_run, log);
    else if (command_line.study)
      run_study(input, folder, command_line.dry_run, log);
    else
    {
      const output::LevelRun run =
          run_once(input, folder, command_line.dry_run, log, command_line.restart);
      if (!command_line.dry_run)
        for (const Quantity &quantity : run.results.quantities)
        {
          std::ostringstream line;
          line << "  " << quantity.name << " = " << quantity.value << " " << quantity.unit;
          log.line(line.str());
        }
    }
    log.line(command_line.dry_run ? "dry run: the scene can be built; nothing was written"
                                  : "done in " + duration(timers.cost().wall_seconds) +
                                        ", results in " + folder.string());
  }

  void list_scenes(std::ostream &out)
  {
    for (const auto &[name, kind] : scene_kinds())
    {
      out << name << ": " << kind.description << '\n';
      for (const std::string &file : scene_files(name))
        out << "  " << file << '\n';
    }
  }

  void print_scene_parameters(const std::string &kind, const ParameterFormat format,
                              std::ostream &out)
  {
    dealii::ParameterHandler prm;
    const std::unique_ptr<Scene> scene = declare_scene(kind, "--print-parameters", prm);
    print_parameters(prm, format, out);
  }
} // namespace semilunar::scene
