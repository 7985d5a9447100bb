// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/core/first_rank.h>
#include <semilunar/core/interrupt.h>
#include <semilunar/core/parameters.h>
#include <semilunar/output/time_series.h>
#include <semilunar/scene/adaptivity.h>
#include <semilunar/shell/error_indicator.h>
#include <semilunar/valve/adaptive_leaflets.h>
#include <semilunar/valve/element_sizes.h>

#include <deal.II/base/patterns.h>

#include <cmath>
#include <numeric>
#include <sstream>

namespace semilunar::scene
{
  namespace
  {
    std::vector<double> indicators(ShellModel &model, const StaticAnalysis &analysis,
                                   const shell::ControlVectors &x)
    {
      if (model.contact)
        model.contact->update(x);
      const double mass = analysis.shell.section.density * analysis.shell.section.thickness;
      return error_indicators(model.surface, model.points, *model.section, model.assembly, x,
                              {analysis.shell.loads.follower_pressure(),
                               analysis.shell.loads.dead_area_load(mass), model.contact.get(),
                               model.symmetry});
    }

    /// Square root of the sum, relative to the energy norm of the solution: (A3).
    double relative_error(const std::vector<double> &indicators, const ShellModel &model)
    {
      const double sum = std::accumulate(indicators.begin(), indicators.end(), 0.);
      return std::sqrt(sum / (2. * model.equilibrium.strain_energy()));
    }

    /// adaptivity.csv: what each round has and finds.
    class Table
    {
    public:
      explicit Table(const std::filesystem::path &folder) : folder(folder) {}

      void add_row(const unsigned int round, const ShellModel &model, const RunResults &results)
      {
        std::vector<output::TimeSeries::Column> columns = {
            {"round", "-"}, {"elements", "-"}, {"control_points", "-"}, {"unknowns", "-"}};
        std::vector<double> row = {double(round), double(model.surface.elements.size()),
                                   double(model.surface.control_points.size()),
                                   double(results.unknowns)};
        for (const Quantity &quantity : results.quantities)
        {
          columns.push_back({quantity.name, quantity.unit});
          row.push_back(quantity.value);
        }
        if (!file)
          file = std::make_unique<output::TimeSeries>(folder, columns, "adaptivity.csv");
        file->add_row(row);
      }

    private:
      const std::filesystem::path folder;
      std::unique_ptr<output::TimeSeries> file;
    };

    /// The folder of a round, without what an earlier run left there.
    std::filesystem::path make_folder(const std::filesystem::path &run, const unsigned int round)
    {
      const std::filesystem::path folder = run / ("round-" + std::to_string(round));
      on_first_rank(
          [&]()
          {
            std::filesystem::remove_all(folder);
            std::filesystem::create_directory(folder);
          });
      return folder;
    }

    void report(const unsigned int round, const double error, const std::size_t n_marked, Log &log)
    {
      std::ostringstream text;
      text << "round " << round << ": estimated error " << error << " of the energy norm, "
           << n_marked << " elements marked";
      log.line(text.str());
    }
  } // namespace

  void AdaptivityParameters::add_parameters(dealii::ParameterHandler &prm)
  {
    namespace Patterns = dealii::Patterns;
    constexpr unsigned int most_rounds = 20;
    prm.enter_subsection("Adaptivity");
    prm.add_parameter(
        "Rounds", n_rounds,
        "How often elements of the leaflets are halved where the estimated error is "
        "large, after which the solution goes on from the same state; for Layout = "
        "T-spline. adaptivity.csv tells of each round, elements.csv is the last mesh, "
        "for Valve/T-spline/Sizes file of other scenes.",
        Patterns::Integer(0, most_rounds));
    prm.add_parameter("Share of error", share,
                      "The elements with the largest errors that have this share of the sum of "
                      "their squares are halved [-].",
                      Patterns::Double(0.01, 1.));
    prm.leave_subsection();
  }

  void AdaptivityParameters::check(const StaticAnalysis &analysis,
                                   const valve::Design &design) const
  {
    if (n_rounds == 0)
      return;
    const std::string entry = "Adaptivity/Rounds", value = std::to_string(n_rounds);
    if (design.layout != valve::LeafletLayout::t_spline)
      throw InputError(entry, value, "only T-splines are refined locally",
                       "set Valve/Layout = T-spline, or 0 rounds");
    const shell::StaticSolverParameters &solver = analysis.solver;
    if (solver.method == "arc length" || solver.method == "linear" || !analysis.stop_at.empty() ||
        solver.stop_after_steps > 0)
      throw InputError(entry, value, "refined meshes go on from equilibrium at the full load",
                       "choose another Solver/Method than arc length or linear, and no early stop");
  }

  void solve_adaptively(const ValveSource &source, const StaticAnalysis &analysis,
                        const AdaptivityParameters &parameters, const AddQuantities &add_quantities,
                        RunContext &context)
  {
    valve::AdaptiveLeaflets leaflets(source.design, source.n_modelled());
    Table table(context.folder);
    shell::ControlVectors x;
    for (unsigned int round = 0;; ++round)
    {
      const bool is_last = round == parameters.n_rounds || context.dry_run;
      ShellModel model(leaflets.surface(), analysis.shell, context.timers, source.n_sectors());
      RunContext part{is_last ? context.folder : make_folder(context.folder, round),
                      context.dry_run, context.log, context.timers};
      x = analysis.run(model, part, round == 0 ? nullptr : &x);
      if (context.dry_run)
        return;
      const Timers::Scope timer(context.timers, "adaptivity");
      const std::vector<double> errors = indicators(model, analysis, x);
      const double error = relative_error(errors, model);
      part.results.quantities.push_back({"estimated_error", error, "-"});
      add_quantities(model, x, part.results);
      table.add_row(round, model, part.results);
      part.results.newton_iterations += context.results.newton_iterations;
      context.results = part.results;
      const auto marked = shell::mark_elements(errors, parameters.share);
      report(round, error, is_last ? 0 : marked.size(), context.log);
      if (is_last || interrupted())
        break;
      const spline::RefinementMatrix matrix = leaflets.refine(marked);
      x = spline::refined(matrix, model.surface.control_points, x);
    }
    const auto write_sizes = [&]()
    { valve::ElementSizes(leaflets.leaflet()).write(context.folder / "elements.csv"); };
    on_first_rank(write_sizes);
  }
} // namespace semilunar::scene
