// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/core/interrupt.h>
#include <semilunar/core/units.h>
#include <semilunar/mesh/quality.h>
#include <semilunar/scene/fsi_simulation.h>
#include <semilunar/valve/stent.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace semilunar::scene
{
  namespace
  {
    /// A step may be so much longer than asked for to end exactly at the end.
    constexpr double end_tolerance = 1e-6;
    constexpr double largest_growth = 1.2; // of steps, after one was halved

    std::unique_ptr<ShellModel> make_model(const ValveFsiParameters &prm, Timers &timers)
    {
      const Timers::Scope timer(timers, "set-up");
      ShellParameters shell;
      shell.section = prm.section;
      shell.supports = prm.supports;
      shell.contact = prm.contact;
      return std::make_unique<ShellModel>(prm.source.build(), shell, timers);
    }

    std::vector<output::TimeSeries::Column> columns(const ValveMotion &motion)
    {
      std::vector<output::TimeSeries::Column> all = {{"time", "s"},
                                                     {"step", "s"},
                                                     {"iterations", "-"},
                                                     {"krylov_iterations", "-"},
                                                     {"residual", "-"},
                                                     {"cfl", "-"},
                                                     {"flow_rate_inlet", "cm^3/s"},
                                                     {"flow_rate_outlet", "cm^3/s"},
                                                     {"pressure_inlet", "mmHg"},
                                                     {"pressure_outlet", "mmHg"},
                                                     {"pressure_difference", "mmHg"},
                                                     {"largest_slip", "cm/s"},
                                                     {"power_on_blood", "erg/s"},
                                                     {"power_on_leaflets", "erg/s"},
                                                     {"power_dissipated", "erg/s"},
                                                     {"force_on_leaflets_z", "dyn"},
                                                     {"force_on_stent_z", "dyn"},
                                                     {"kinetic_energy", "erg"},
                                                     {"strain_energy", "erg"},
                                                     {"max_mipe", "-"},
                                                     {"largest_penetration", "cm"}};
      const auto more = motion.columns();
      all.insert(all.end(), more.begin(), more.end());
      return all;
    }
  } // namespace

  FsiSimulation::FsiSimulation(const ValveFsiParameters &parameters, RunContext &context)
      : prm(parameters), context(context), model(make_model(prm, context.timers)),
        mass(model->surface, model->points, prm.section.mass_per_area()),
        mesh(mesh::make_mesh<3>(prm.mesh, MPI_COMM_WORLD)),
        points(model->surface, n_points_per_direction(model->surface)),
        shell(model->surface, points, model->equations, model->equilibrium, mass),
        mapping(prm.flow.degree), conditions(prm.boundaries.conditions<3>(*mesh, {}, {})),
        flow(prm.flow, mesh->triangulation, mapping, conditions, context.timers),
        velocity_dofs(flow.spaces().velocity_dofs()), sections{{{2, prm.sections[0]},
                                                                {2, prm.sections[1]}}},
        motion(prm.source, *model, context),
        series(context.folder, columns(motion), "timeseries.csv", context.dry_run)
  {
    const Timers::Scope timer(context.timers, "set-up");
    flow.initialise(
        0., [](const auto &, double) { return dealii::Tensor<1, 3>(); },
        [this](const auto &, double) { return mmHg * prm.initial_pressure; });
    coupled = std::make_unique<coupling::FluidStructure>(
        flow, coupling::ImmersedShell{&shell, model->surface, points, prm.section.mass_per_area()},
        stent_points(), prm.flow.density, prm.coupling, context.timers);
    if (coupled->shell_points()->n_inside() < points.n_points())
      throw InputError("Valve", "", "a part of the leaflets lies outside of the artery",
                       "make the artery wider than the valve");
    for (auto &section : sections)
      section.reinit(state());
  }

  double FsiSimulation::cell_width_at_valve() const
  {
    const double top = prm.source.design.commissure_height, radius = prm.source.design.radius;
    double smallest = std::numeric_limits<double>::max();
    for (const auto &cell : mesh->triangulation.active_cell_iterators())
    {
      const auto centre = cell->center();
      if (cell->is_locally_owned() && centre[2] > 0. && centre[2] < top &&
          std::hypot(centre[0], centre[1]) < radius)
        smallest = std::min(smallest, std::cbrt(cell->measure()));
    }
    return dealii::Utilities::MPI::min(smallest, MPI_COMM_WORLD);
  }

  unsigned int FsiSimulation::n_points_per_direction(const spline::Surface &surface) const
  {
    // Of the largest element: one side of a square of its area.
    const shell::QuadraturePoints gauss(surface);
    double largest = 0.;
    for (unsigned int e = 0; e < surface.elements.size(); ++e)
    {
      double area = 0.;
      for (unsigned int q = gauss.first_point(e); q < gauss.first_point(e + 1); ++q)
        area += gauss.weight(q);
      largest = std::max(largest, std::sqrt(area));
    }
    constexpr unsigned int fewest = 2;
    return std::max(fewest, static_cast<unsigned int>(std::ceil(
                                largest * prm.coupling.points_per_cell / cell_width_at_valve())));
  }

  coupling::SurfacePoints FsiSimulation::stent_points() const
  {
    if (!prm.has_stent)
      return {};
    const spline::Surface stent = valve::stent(prm.source.design);
    const shell::QuadraturePoints stent_points(stent, n_points_per_direction(stent));
    return coupling::surface_points(stent, stent_points, spline::positions(stent));
  }

  output::FlowState<3> FsiSimulation::state() const
  {
    return {flow.mapping(),
            velocity_dofs.handler(),
            flow.spaces().pressure_dofs(),
            flow.velocity(),
            flow.pressure(),
            prm.flow.density,
            prm.flow.viscosity,
            flow.time(),
            last_dt};
  }

  void FsiSimulation::report_size() const
  {
    scene::report_size(*model, context.log);
    const mesh::Quality quality = mesh::measure<3>(mesh->triangulation, mapping);
    context.log.line(mesh::describe(quality) + ", " + std::to_string(context.results.unknowns) +
                     " unknowns in all");
    std::string text = std::to_string(points.n_points()) + " immersed points of the leaflets";
    if (const auto *rigid = coupled->rigid_points())
      text += ", " + std::to_string(rigid->n_inside()) + " of the stent's " +
              std::to_string(rigid->n_points()) + " (the others lie in the wall)";
    context.log.line(text);
  }

  void FsiSimulation::run()
  {
    context.results.unknowns = velocity_dofs.handler().n_dofs() +
                               flow.spaces().pressure_dofs().n_dofs() +
                               model->equations.n_equations();
    report_size();
    if (context.dry_run)
      return;
    shell_files = std::make_unique<ShellOutput>(context.folder, *model, prm.shell_vtu);
    flow_files = std::make_unique<output::FlowVtu<3>>(context.folder, prm.flow_vtu,
                                                      prm.boundaries.walls<3>(*mesh));
    write_shell();
    write_flow();
    next_row = prm.series_interval;
    double dt = prm.step;
    try
    {
      while (flow.time() < prm.end * (1. - end_tolerance) && !interrupted())
        finish_step(step(dt));
    }
    catch (const NumericsError &error)
    {
      write_shell();
      write_flow();
      throw error.after((context.folder / last_file).string());
    }
    context.log.progress("valve", 1.);
    write_shell();
    write_flow();
    add_quantities();
  }

  coupling::CoupledReport FsiSimulation::step(double &dt)
  {
    const Timers::Scope timer(context.timers, "time steps");
    for (;;)
      try
      {
        const double left = prm.end - flow.time();
        const coupling::CoupledReport report =
            coupled->advance(left < dt * (1. + end_tolerance) ? left : dt);
        dt = std::min(prm.step, largest_growth * dt);
        return report;
      }
      catch (const NumericsError &error)
      {
        dt *= 0.5;
        ++n_rejected;
        if (dt < prm.smallest_step)
          throw;
        context.log.line(std::string(error.what()) + "; trying half the step");
      }
  }

  void FsiSimulation::finish_step(const coupling::CoupledReport &report)
  {
    const Timers::Scope timer(context.timers, "output");
    ++context.results.steps;
    n_iterations += report.n_iterations;
    context.results.newton_iterations = n_iterations;
    last_dt = report.flow.dt;
    largest_imbalance = std::max(
        largest_imbalance, std::abs(report.power.imbalance()) /
                               (std::abs(report.power.fluid) + std::abs(report.power.structure)));
    largest_penetration = std::max(largest_penetration, model->contact->largest_penetration());
    std::array<double, 2> pressures;
    for (unsigned int i = 0; i < 2; ++i)
      pressures[i] = sections[i].evaluate(state()).pressure;
    const double difference = pressures[0] - pressures[1];
    const double outflow = report.flow.flow_rate.at(mesh->boundary_id("outlet", "Mesh"));
    flow_through.add(flow.time(), outflow, difference);

    const double time = flow.time() + 0.5 * last_dt;
    if (time >= next_row)
    {
      add_row(report, difference);
      next_row += prm.series_interval;
    }
    if (prm.shell_interval > 0. && time >= next_shell_file)
      write_shell();
    if (prm.flow_vtu.interval > 0. && time >= next_flow_file)
      write_flow();

    char text[200];
    std::snprintf(
        text, sizeof(text),
        "step %u, t = %.6g s, dt = %.3g s, flow %.4g cm^3/s, %u + %u iterations, residual "
        "%.1e, CFL %.2f",
        context.results.steps, flow.time(), last_dt, outflow, report.n_iterations,
        report.flow.n_linear, report.residual, report.flow.cfl);
    context.log.line(text);
    context.log.progress("valve", std::min(flow.time() / prm.end, 0.999));
  }

  void FsiSimulation::add_row(const coupling::CoupledReport &report,
                              const double pressure_difference)
  {
    const auto inlet = mesh->boundary_id("inlet", "Mesh"),
               outlet = mesh->boundary_id("outlet", "Mesh");
    const shell::ControlVectors x = positions();
    std::vector<double> all = {
        flow.time(),
        report.flow.dt,
        double(report.n_iterations),
        double(report.flow.n_linear),
        report.residual,
        report.flow.cfl,
        -report.flow.flow_rate.at(inlet),
        report.flow.flow_rate.at(outlet),
        report.flow.mean_pressure.at(inlet) / mmHg,
        report.flow.mean_pressure.at(outlet) / mmHg,
        pressure_difference / mmHg,
        report.largest_slip,
        report.power.fluid,
        report.power.structure,
        report.power.dissipation,
        report.force_on_shell[2],
        report.force_on_rigid[2],
        shell.kinetic_energy(),
        model->equilibrium.strain_energy(),
        std::max(largest_strain(*model, x, 1).value, largest_strain(*model, x, -1).value),
        model->contact->largest_penetration()};
    const auto more = motion.row(flow.time(), x);
    all.insert(all.end(), more.begin(), more.end());
    series.add_row(all);
  }

  void FsiSimulation::write_shell()
  {
    last_file = shell_files->write(flow.time(), positions());
    next_shell_file += prm.shell_interval;
  }

  void FsiSimulation::write_flow()
  {
    flow_files->write(state());
    next_flow_file += prm.flow_vtu.interval;
  }

  void FsiSimulation::add_quantities()
  {
    RunResults &results = context.results;
    motion.add_quantities(results);
    const auto closed =
        std::find_if(results.quantities.begin(), results.quantities.end(),
                     [](const Quantity &quantity) { return quantity.name == "closed"; });
    flow_through.add_quantities(closed->value, results);
    const double n_steps = results.steps;
    results.quantities.insert(
        results.quantities.end(),
        {{"largest_penetration_of_thickness", largest_penetration / prm.section.thickness, "-"},
         {"largest_power_imbalance", largest_imbalance, "-"},
         {"iterations_per_step", n_iterations / n_steps, "-"},
         {"rejected_steps", double(n_rejected), "-"},
         {"cells", double(mesh->triangulation.n_global_active_cells()), "-"},
         {"immersed_points", double(points.n_points()), "-"}});
  }
} // namespace semilunar::scene
