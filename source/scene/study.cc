// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/core/interrupt.h>
#include <semilunar/core/nearest_name.h>
#include <semilunar/output/variation_table.h>
#include <semilunar/scene/run_once.h>
#include <semilunar/scene/study.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cstdio>

namespace semilunar::scene
{
  namespace
  {
    const char *const variations_entry = "Study/Variations";

    std::string run_name(const std::size_t number)
    {
      char name[16];
      std::snprintf(name, sizeof(name), "run-%02zu", number);
      return name;
    }

    /// Run into the folder's subfolder of this number. A failure makes a row without quantities.
    output::VariedRun run_varied(const ParameterInput &input, const Variation &variation,
                                 const std::size_t number, const std::filesystem::path &folder,
                                 const bool dry_run, Log &log)
    {
      output::VariedRun run{run_name(number), variation.entry, variation.value, {}, {}, ""};
      const Timers timers;
      try
      {
        const output::LevelRun done = run_once(input, folder / run.name, dry_run, log);
        run.results = done.results;
        run.cost = done.cost;
      }
      catch (const NumericsError &error)
      {
        run.failure = error.what();
        run.cost = timers.cost();
        log.line("this run failed: " + run.failure);
      }
      return run;
    }
  } // namespace

  void StudyParameters::add_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Study");
    prm.add_parameter(
        "Variations", variations,
        "What --study changes, one entry and value in each run: 'Section/Entry: VALUE "
        "| VALUE; Section/Entry: VALUE'. The first run changes nothing.");
    prm.add_parameter("Quantities", quantities,
                      "Names of the quantities that --study reports, separated by commas; empty: "
                      "all. The plot shows the first.");
    prm.leave_subsection();
  }

  std::vector<Variation> parse_variations(const std::string &list,
                                          const std::vector<ParameterDescription> &declared)
  {
    using dealii::Utilities::split_string_list;
    std::vector<std::string> paths;
    for (const ParameterDescription &entry : declared)
      paths.push_back(entry.path);
    std::vector<Variation> result;
    for (const std::string &part : split_string_list(list, ';'))
    {
      const std::size_t colon = part.find(':');
      if (colon == std::string::npos)
        throw InputError(variations_entry, part, "this changes no entry",
                         "write 'Section/Entry: VALUE | VALUE'");
      const std::string path = dealii::Utilities::trim(part.substr(0, colon));
      if (std::count(paths.begin(), paths.end(), path) == 0)
        throw InputError(variations_entry, path, "there is no such entry", suggest(path, paths));
      for (const std::string &value : split_string_list(part.substr(colon + 1), '|'))
        result.push_back({path, value});
    }
    if (result.empty())
      throw InputError(variations_entry, "", "the scene does not say what to vary",
                       "write 'Section/Entry: VALUE | VALUE'");
    return result;
  }

  void run_study(const ParameterInput &input, const std::filesystem::path &folder,
                 const bool dry_run, Log &log)
  {
    const PreparedScene base(input);
    const std::vector<ParameterDescription> entries = list_parameters(base.prm);
    const StudyParameters &study = base.scene->study;
    std::vector<output::VariedRun> runs;
    try
    {
      const std::vector<Variation> variations = parse_variations(study.variations, entries);
      if (!dry_run)
        create_folder(folder, base.prm);
      for (std::size_t i = 0; i <= variations.size() && !interrupted(); ++i)
      {
        const Variation variation = i == 0 ? Variation() : variations[i - 1];
        log.line(run_name(i) + " of " + std::to_string(variations.size()) + ": " +
                 (i == 0 ? "as the scene is" : variation.entry + " = " + variation.value));
        ParameterInput varied = input;
        if (i > 0)
          varied.replace({variation.entry, variation.value, variations_entry, ""});
        runs.push_back(run_varied(varied, variation, i, folder, dry_run, log));
        // after each run: a study may be long
        if (!dry_run)
          output::write_variations(
              folder, runs, dealii::Utilities::split_string_list(study.quantities, ','), entries);
      }
    }
    catch (const InputError &error)
    {
      throw error.at(input.locate(error.where()));
    }
  }
} // namespace semilunar::scene
