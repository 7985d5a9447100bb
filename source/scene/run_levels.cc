// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/core/version.h>
#include <semilunar/output/summary.h>
#include <semilunar/scene/run_levels.h>
#include <semilunar/scene/run_once.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace semilunar::scene
{
  namespace fs = std::filesystem;

  namespace
  {
    /// The quantities of the finest run with their error estimates, and the cost of all runs.
    output::Summary summary_of_levels(const std::string &kind,
                                      const std::vector<output::LevelRun> &runs,
                                      const std::vector<output::QuantityStudy> &studies,
                                      const Timers &timers)
    {
      output::Summary summary{kind, runs.back().results, timers.cost(), {}, version()};
      summary.results.quantities.clear();
      for (const auto &study : studies)
        summary.results.quantities.push_back({study.name, study.values.back(), study.unit,
                                              study.reference, study.estimate.errors.back(),
                                              study.estimate.orders.back()});
      for (const auto &run : runs)
        summary.phases["level " + std::to_string(run.level)] = run.cost.wall_seconds;
      return summary;
    }

    void report_levels(const fs::path &folder, const PreparedScene &base,
                       const std::vector<output::LevelRun> &runs, const Timers &timers, Log &log)
    {
      std::vector<output::QuantityStudy> studies = output::study_quantities(runs);
      const auto last =
          std::remove_if(studies.begin(), studies.end(),
                         [&](const output::QuantityStudy &study)
                         { return !is_selected(base.scene->levels.quantities, study.name); });
      studies.erase(last, studies.end());
      output::write_speed_against_error(folder, runs, studies);
      output::write_summary(folder, summary_of_levels(base.kind, runs, studies, timers));
      for (const auto &study : studies)
      {
        std::ostringstream line;
        line << study.name << " = " << study.values.back() << " +- " << study.estimate.errors.back()
             << " " << study.unit << " (" << study.estimate.basis;
        if (std::isfinite(study.estimate.orders.back()))
          line << ", order " << study.estimate.orders.back();
        log.line(line.str() + ")");
      }
    }
  } // namespace

  void run_levels(const ParameterInput &input, const unsigned int n_levels, const fs::path &folder,
                  const bool dry_run, Log &log)
  {
    const PreparedScene base(input);
    const std::vector<ParameterDescription> entries = list_parameters(base.prm);
    const Timers timers;
    std::vector<output::LevelRun> runs;
    try
    {
      const std::vector<Refinement> refinements = parse_refinements(base.scene->levels.finer);
      if (!dry_run)
        create_folder(folder, base.prm);
      for (unsigned int level = 0; level < n_levels; ++level)
      {
        const ParameterInput level_input = input_of_level(input, entries, refinements, level);
        log.line("level " + std::to_string(level + 1) + " of " + std::to_string(n_levels));
        for (const Refinement &refinement : refinements)
          log.line("  " + refinement.entry + " = " + level_input.find(refinement.entry)->value);
        runs.push_back(
            run_once(level_input, folder / ("level-" + std::to_string(level)), dry_run, log));
        runs.back().level = level;
        runs.back().size = refinements.front().size(level);
      }
    }
    catch (const InputError &error)
    {
      throw error.at(input.locate(error.where()));
    }
    catch (const NumericsError &)
    {
      // The coarser levels are worth having.
      if (!runs.empty())
        report_levels(folder, base, runs, timers, log);
      throw;
    }
    if (!dry_run)
      report_levels(folder, base, runs, timers, log);
  }
} // namespace semilunar::scene
