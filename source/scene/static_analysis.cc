// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/core/interrupt.h>
#include <semilunar/output/time_series.h>
#include <semilunar/scene/displacement_limits.h>
#include <semilunar/scene/probes.h>
#include <semilunar/scene/shell_output.h>
#include <semilunar/scene/static_analysis.h>
#include <semilunar/scene/surface_report.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

namespace semilunar::scene
{
  namespace
  {
    std::vector<output::TimeSeries::Column> columns(const Probes &probes)
    {
      std::vector<output::TimeSeries::Column> all = {
          {"load_factor", "-"}, {"iterations", "-"},    {"residual", "-"},
          {"max_mipe", "-"},    {"max_mipe_back", "-"}, {"largest_penetration", "length"}};
      const auto more = probes.columns();
      all.insert(all.end(), more.begin(), more.end());
      return all;
    }

    std::vector<double> row(const shell::LoadStep &step, const ShellModel &model,
                            const shell::ControlVectors &x, const Probes &probes)
    {
      std::vector<double> all = {step.load,
                                 double(step.iterations),
                                 step.residual,
                                 largest_strain(model, x, 1).value,
                                 largest_strain(model, x, -1).value,
                                 model.contact ? model.contact->largest_penetration()
                                               : std::nan("")};
      const auto more = probes.displacements(x);
      all.insert(all.end(), more.begin(), more.end());
      return all;
    }

    /// The curve of a file, if there is one, whose load factors the solver is to end steps at.
    std::optional<ReferenceCurve> read_curve(const std::string &file,
                                             const std::vector<std::string> &names,
                                             shell::StaticSolverParameters &solver)
    {
      if (file.empty())
        return {};
      const ReferenceCurve curve(file);
      curve.check(names);
      const auto factors = curve.load_factors();
      solver.load_factors.insert(solver.load_factors.end(), factors.begin(), factors.end());
      return curve;
    }

    std::string describe(const shell::LoadStep &step)
    {
      std::ostringstream text;
      text << "step " << step.number << ": load factor " << step.load << ", " << step.iterations
           << " " << step.method << " iterations, residual " << step.residual;
      return text.str();
    }

    /// Make the positions of the control points the state of the model, at the full load.
    void go_on_from(shell::ControlVectors x, ShellModel &model, shell::Equilibrium::Vector &u)
    {
      for (unsigned int c = 0; c < x.size(); ++c)
        x[c] -= model.surface.control_points[c].position;
      model.equations.gather(x, u);
      model.equilibrium.accept(u, 1.);
    }

    void add_quantities(const ShellModel &model, const shell::ControlVectors &x,
                        const Probes &probes, RunResults &results)
    {
      const LargestStrain front = largest_strain(model, x, 1), back = largest_strain(model, x, -1);
      const LargestStrain &all = front.value > back.value ? front : back;
      const spline::SurfacePoint place{model.points.element(all.q), model.points.xi(all.q)};
      const auto position = spline::evaluate(model.surface, place)[spline::value];
      auto &quantities = results.quantities;
      quantities.insert(
          quantities.end(),
          {{"max_mipe", all.value, "-"},
           {"max_mipe_front", front.value, "-"},
           {"max_mipe_back", back.value, "-"},
           {"max_mipe_x", position[0], "length"},
           {"max_mipe_y", position[1], "length"},
           {"max_mipe_z", position[2], "length"},
           {"strain_energy", model.symmetry.n_sectors() * model.equilibrium.strain_energy(),
            "force*length"}});
      probes.add_quantities(x, results);
    }
  } // namespace

  void StaticAnalysis::add_parameters(dealii::ParameterHandler &prm)
  {
    shell.add_parameters(prm);
    solver.add_parameters(prm);
    prm.enter_subsection("Output");
    vtu.add_parameters(prm);
    prm.add_parameter("Probes", probes,
                      "Points whose displacement is recorded, 'NAME: (x, y, z)', separated by "
                      "semicolons; the nearest point of the undeformed surface is taken.");
    prm.add_parameter(
        "Reference curve", reference_curve,
        "A file of published values with the columns quantity, load_factor, value, "
        "source, where quantity is a probe's as in tip_uz, or -tip_uz for the other "
        "sign. Load steps end at its load factors; deviation.csv and the summary tell "
        "the deviations.",
        dealii::Patterns::FileName());
    prm.leave_subsection();
    prm.enter_subsection("Solver");
    prm.add_parameter("Stop at", stop_at,
                      "Displacements that end the run well before the full load, 'tip_uz: 3', "
                      "separated by semicolons: the first state where a probe's component is as "
                      "large in amount [length].");
    prm.leave_subsection();
  }

  shell::ControlVectors StaticAnalysis::run(ShellModel &model, RunContext &context,
                                            const shell::ControlVectors *const start) const
  {
    const Probes points(probes, model.surface, "Output/Probes");
    const DisplacementLimits limits(stop_at, points.names());
    LoadPath path{points.names(), {}, {}};
    shell::StaticSolverParameters solver = this->solver;
    const std::optional<ReferenceCurve> curve = read_curve(reference_curve, path.names, solver);
    report_size(model, context.log);
    context.results.unknowns = model.equations.n_equations();
    shell::Equilibrium::Vector u(model.equations.n_equations());
    if (start != nullptr)
    {
      go_on_from(*start, model, u);
      solver.n_load_steps = 1;
    }
    if (context.dry_run)
    {
      print(report(model.surface), context.log);
      return model.equilibrium.positions(u, 0.);
    }

    output::TimeSeries series(context.folder, columns(points));
    ShellOutput files(context.folder, model, vtu);
    std::string last_file = files.write(0., spline::positions(model.surface));
    shell::ControlVectors x = spline::positions(model.surface);
    double load = 0.; // of the last accepted state
    const auto accepted = [&](const shell::LoadStep &step, const shell::Equilibrium::Vector &state)
    {
      const Timers::Scope timer(context.timers, "output");
      x = model.equilibrium.positions(state, step.load);
      last_file = files.write(step.load, x);
      series.add_row(row(step, model, x, points));
      path.loads.push_back(step.load);
      path.values.push_back(points.displacements(x));
      context.results.steps = step.number;
      load = step.load;
      context.log.line(describe(step));
      context.log.progress("loading", step.load);
    };
    // Within a step, the decades that the residual has fallen tell how far the iteration is.
    const auto observe = [&](const double residual)
    {
      const double decades = std::log10(residual) / std::log10(solver.tolerance);
      const double step = std::min(1. / solver.n_load_steps, 1. - load);
      context.log.progress("loading", load + 0.99 * step * std::clamp(decades, 0., 1.));
    };
    const auto finished = [&] { return limits.reached(path.values.back()); };
    try
    {
      const Timers::Scope timer(context.timers, "solve");
      context.results.newton_iterations =
          solve_static(model.equilibrium, u, solver, {accepted, interrupted, observe, finished});
    }
    catch (const NumericsError &error)
    {
      throw error.after((context.folder / last_file).string());
    }
    add_quantities(model, x, points, context.results);
    context.results.quantities.push_back({"load_factor", load, "-"});
    if (curve)
      curve->compare(path,
                     solver.method == "arc length" ? Comparison::with_path : Comparison::at_load,
                     context.folder, context.results);
    return x;
  }
} // namespace semilunar::scene
