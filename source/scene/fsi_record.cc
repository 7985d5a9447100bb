// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/archive.h>
#include <semilunar/core/units.h>
#include <semilunar/scene/fsi_record.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace semilunar::scene
{
  namespace
  {
    std::vector<output::TimeSeries::Column> columns(const ValveMotion &motion,
                                                    const WallRecord<3> *wall)
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
                                                     {"force_of_leaflets_on_stent_z", "dyn"},
                                                     {"kinetic_energy", "erg"},
                                                     {"strain_energy", "erg"},
                                                     {"max_mipe", "-"},
                                                     {"largest_penetration", "cm"}};
      const auto more = motion.columns();
      all.insert(all.end(), more.begin(), more.end());
      if (!wall)
        return all;
      const auto of_wall = wall->columns();
      all.insert(all.end(), of_wall.begin(), of_wall.end());
      return all;
    }

    std::unique_ptr<WallRecord<3>> make_wall_record(const ValveFsiParameters &prm,
                                                    const ValveInBlood &valve)
    {
      if (!valve.has_elastic_wall())
        return nullptr;
      FlowRecordParameters parameters;
      parameters.wall_probes = prm.wall_probes;
      return std::make_unique<WallRecord<3>>(parameters, valve.artery(), prm.has_stent);
    }
  } // namespace

  FsiRecord::FsiRecord(const ValveFsiParameters &parameters, ValveInBlood &valve,
                       RunContext &context)
      : prm(parameters), valve(valve),
        context(context), sections{{{2, prm.sections[0]}, {2, prm.sections[1]}}},
        motion(prm.source, valve.leaflets(), context), wall(make_wall_record(prm, valve)),
        series(context.folder, columns(motion, wall.get()), "timeseries.csv", context.restart),
        shell_files(context.folder, valve.leaflets(), prm.shell_vtu),
        flow_files(context.folder, prm.flow_vtu, prm.boundaries.walls<3>(valve.artery()))
  {
    locate_sections();
  }

  void FsiRecord::locate_sections()
  {
    const Timers::Scope timer(context.timers, "output");
    for (auto &section : sections)
      section.reinit(valve.blood());
  }

  void FsiRecord::begin()
  {
    write();
    if (wall)
      counts.volume_at_start = valve.volume();
    add_row(valve.at_rest(), pressure_difference());
    counts.next_row = prm.series_interval;
  }

  void FsiRecord::write()
  {
    const Timers::Scope timer(context.timers, "output");
    write_shell();
    write_flow();
  }

  double FsiRecord::pressure_difference() const
  {
    return sections[0].evaluate(valve.blood()).pressure -
           sections[1].evaluate(valve.blood()).pressure;
  }

  void FsiRecord::balance_volumes(const coupling::CoupledReport &report)
  {
    double net = 0.;
    for (const char *const name : {"inlet", "outlet"})
      net -= report.flow.flow_rate.at(valve.artery().boundary_id(name, "Mesh"));
    // the first step is of first order: its flow rate is that of the whole step
    const double last = counts.steps == 1 ? net : counts.last_net_flow_rate;
    counts.net_inflow += 0.5 * report.flow.dt * (net + last);
    counts.last_net_flow_rate = net;
    counts.largest_volume_error =
        std::max(counts.largest_volume_error,
                 std::abs(valve.volume() - counts.volume_at_start - counts.net_inflow));
  }

  void FsiRecord::add(const coupling::CoupledReport &report)
  {
    const Timers::Scope timer(context.timers, "output");
    context.results.steps = ++counts.steps;
    counts.iterations += report.n_iterations;
    counts.largest_imbalance =
        std::max(counts.largest_imbalance,
                 std::abs(report.power.imbalance()) /
                     (std::abs(report.power.fluid) + std::abs(report.power.structure)));
    counts.largest_penetration =
        std::max(counts.largest_penetration, valve.leaflets().contact->largest_penetration());
    if (wall)
    {
      locate_sections();
      balance_volumes(report);
    }
    const double difference = pressure_difference();
    const double outflow = report.flow.flow_rate.at(valve.artery().boundary_id("outlet", "Mesh"));
    flow_through.add(valve.time(), outflow, difference);

    const double time = valve.time() + 0.5 * valve.last_step();
    if (time >= counts.next_row)
    {
      add_row(report, difference);
      counts.next_row += prm.series_interval;
    }
    if (prm.shell_interval > 0. && time >= counts.next_shell_file)
      write_shell();
    if (prm.flow_vtu.interval > 0. && time >= counts.next_flow_file)
      write_flow();
    describe(report, outflow);
  }

  void FsiRecord::describe(const coupling::CoupledReport &report, const double outflow) const
  {
    char text[200];
    std::snprintf(
        text, sizeof(text),
        "step %u, t = %.6g s, dt = %.3g s, flow %.4g cm^3/s, %u + %u iterations, residual "
        "%.1e, CFL %.2f",
        counts.steps, valve.time(), report.flow.dt, outflow, report.n_iterations,
        report.flow.n_linear, report.residual, report.flow.cfl);
    context.log.line(text);
    context.log.progress("valve", std::min(valve.time() / prm.end, 0.999));
  }

  void FsiRecord::add_row(const coupling::CoupledReport &report, const double difference)
  {
    const auto inlet = valve.artery().boundary_id("inlet", "Mesh"),
               outlet = valve.artery().boundary_id("outlet", "Mesh");
    const ShellModel &model = valve.leaflets();
    const shell::ControlVectors x = valve.positions();
    std::vector<double> all = {
        valve.time(),
        report.flow.dt,
        double(report.n_iterations),
        double(report.flow.n_linear),
        report.residual,
        report.flow.cfl,
        -report.flow.flow_rate.at(inlet),
        report.flow.flow_rate.at(outlet),
        report.flow.mean_pressure.at(inlet) / mmHg,
        report.flow.mean_pressure.at(outlet) / mmHg,
        difference / mmHg,
        report.largest_slip,
        report.power.fluid,
        report.power.structure,
        report.power.dissipation,
        report.force_on_shell[2],
        report.force_on_rigid[2],
        report.force_on_supports[2],
        valve.kinetic_energy(),
        model.equilibrium.strain_energy(),
        std::max(largest_strain(model, x, 1).value, largest_strain(model, x, -1).value),
        model.contact->largest_penetration()};
    const auto more = motion.row(valve.time(), x);
    all.insert(all.end(), more.begin(), more.end());
    if (wall)
    {
      const bool at_rest = report.flow.dt == 0.; // the first row
      const auto of_wall =
          at_rest ? wall->row_at_rest(valve.solver()) : wall->row(report.flow, valve.solver());
      all.insert(all.end(), of_wall.begin(), of_wall.end());
    }
    series.add_row(all);
  }

  void FsiRecord::write_shell()
  {
    counts.last_file = shell_files.write(valve.time(), valve.positions());
    counts.next_shell_file += prm.shell_interval;
  }

  void FsiRecord::write_flow()
  {
    flow_files.write(valve.blood());
    counts.next_flow_file += prm.flow_vtu.interval;
  }

  void FsiRecord::add_to(Checkpoints &checkpoints)
  {
    checkpoints.add_object("record", counts);
    checkpoints.add_object("flow-through", flow_through);
    checkpoints.add_object("shell-files", shell_files);
    checkpoints.add_object("flow-files", flow_files);
    motion.add_to(checkpoints);
  }

  void FsiRecord::go_on()
  {
    series.go_on_at(counts.series_size);
    context.results.steps = counts.steps;
    locate_sections();
  }

  void FsiRecord::add_quantities()
  {
    RunResults &results = context.results;
    results.newton_iterations = counts.iterations;
    motion.add_quantities(results);
    const auto closed =
        std::find_if(results.quantities.begin(), results.quantities.end(),
                     [](const Quantity &quantity) { return quantity.name == "closed"; });
    flow_through.add_quantities(closed->value, results);
    const double n_steps = counts.steps;
    results.quantities.insert(
        results.quantities.end(),
        {{"largest_penetration_of_thickness", counts.largest_penetration / prm.section.thickness,
          "-"},
         {"largest_power_imbalance", counts.largest_imbalance, "-"},
         {"iterations_per_step", counts.iterations / n_steps, "-"},
         {"rejected_steps", double(counts.rejected), "-"},
         {"cells", double(valve.artery().triangulation.n_global_active_cells()), "-"},
         {"immersed_points", double(valve.n_points()), "-"}});
    if (wall)
      results.quantities.push_back({"largest_volume_error", counts.largest_volume_error, "cm^3"});
  }
} // namespace semilunar::scene
