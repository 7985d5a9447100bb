// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/archive.h>
#include <semilunar/core/exceptions.h>
#include <semilunar/core/interrupt.h>
#include <semilunar/scene/fsi_simulation.h>
#include <semilunar/scene/surface_report.h>
#include <semilunar/valve/stent.h>

#include <algorithm>

namespace semilunar::scene
{
  namespace
  {
    /// A step may be so much longer than asked for to end exactly at the end.
    constexpr double end_tolerance = 1e-6;
    constexpr double largest_growth = 1.2; // of steps, after one was halved
  }                                        // namespace

  FsiSimulation::FsiSimulation(const ValveFsiParameters &parameters, RunContext &context)
      : prm(parameters), context(context), valve(prm, context.log, context.timers),
        next_dt(prm.step)
  {
    context.results.unknowns = valve.n_unknowns();
    valve.report_size();
    if (!context.dry_run)
      prepare_record();
  }

  void FsiSimulation::prepare_record()
  {
    record = std::make_unique<FsiRecord>(prm, valve, context);
    checkpoints = std::make_unique<Checkpoints>(context.folder, prm.checkpoints, valve.fit());
    checkpoints->add_object("next-step", next_dt);
    valve.add_to(*checkpoints);
    record->add_to(*checkpoints);
  }

  bool FsiSimulation::at_end() const
  {
    return valve.time() >= prm.end * (1. - end_tolerance);
  }

  void FsiSimulation::run()
  {
    if (context.dry_run)
    {
      spline::Surface surfaces = valve.leaflets().surface;
      const double merge_nothing = -1.;
      spline::append(surfaces, valve::stent(prm.source.design), merge_nothing);
      print(report(surfaces), context.log);
      return;
    }
    try
    {
      context.restart ? go_on() : record->begin();
      while (!at_end() && !interrupted())
      {
        record->add(step());
        if (valve.adapt_mesh(context.results.steps))
          record->locate_sections();
        save_if_due();
      }
    }
    catch (const NumericsError &error)
    {
      record->write();
      throw error.after((context.folder / record->last_file()).string());
    }
    if (interrupted())
      return;
    context.log.progress("valve", 1.);
    record->write();
    record->add_quantities();
  }

  void FsiSimulation::go_on()
  {
    checkpoints->restore();
    valve.forget_history();
    record->go_on();
    context.log.line("going on from step " + std::to_string(context.results.steps) + ", time " +
                     std::to_string(valve.time()));
  }

  void FsiSimulation::save_if_due()
  {
    if (!checkpoints->due(context.results.steps))
      return;
    const Timers::Scope timer(context.timers, "output");
    record->remember_sizes();
    checkpoints->write(context.results.steps, valve.time());
    valve.forget_history();
    context.log.line("checkpoint at time " + std::to_string(valve.time()));
  }

  coupling::CoupledReport FsiSimulation::step()
  {
    const Timers::Scope timer(context.timers, "time steps");
    for (;;)
      try
      {
        const double left = prm.end - valve.time();
        const coupling::CoupledReport report =
            valve.advance(left < next_dt * (1. + end_tolerance) ? left : next_dt);
        next_dt = std::min(prm.step, largest_growth * next_dt);
        return report;
      }
      catch (const NumericsError &error)
      {
        next_dt *= 0.5;
        record->count_rejected_step();
        if (next_dt < prm.smallest_step)
          throw;
        context.log.line(std::string(error.what()) + "; trying half the step");
      }
  }
} // namespace semilunar::scene
