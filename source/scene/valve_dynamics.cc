// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/units.h>
#include <semilunar/scene/valve_dynamics.h>
#include <semilunar/scene/valve_motion.h>

namespace semilunar::scene
{
  void ValveDynamics::add_parameters(dealii::ParameterHandler &prm)
  {
    source.add_parameters(prm);
    analysis.add_parameters(prm);
    prm.enter_subsection("Loads");
    prm.enter_subsection("Transvalvular pressure");
    pressure.add_parameters(prm, "the pressure on the ventricular side of the leaflets minus that "
                                 "on the aortic side (positive opens) [s: mmHg]");
    prm.leave_subsection();
    prm.leave_subsection();
  }

  TimeTable ValveDynamics::pressure_table() const
  {
    return TimeTable(pressure, "Loads/Transvalvular pressure");
  }

  void ValveDynamics::check() const
  {
    source.check();
    analysis.check();
    pressure_table();
  }

  void ValveDynamics::run(RunContext &context)
  {
    // The pressure of one mmHg is the load that the table multiplies. Normals point to the aorta.
    analysis.shell.loads.pressure = -mmHg;
    std::unique_ptr<ShellModel> model;
    {
      const Timers::Scope timer(context.timers, "set-up");
      model = std::make_unique<ShellModel>(source.build(), analysis.shell, context.timers,
                                           source.n_sectors());
    }
    ValveMotion motion(source, *model, context);
    analysis.run(*model, pressure_table(), context, motion);
    if (!context.dry_run)
      motion.add_quantities(context.results);
  }
} // namespace semilunar::scene
