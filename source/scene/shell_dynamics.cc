// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/scene/shell_dynamics.h>

namespace semilunar::scene
{
  void ShellDynamics::add_parameters(dealii::ParameterHandler &prm)
  {
    source.add_parameters(prm);
    analysis.add_parameters(prm);
    analysis.shell.loads.add_parameters(prm);
    prm.enter_subsection("Loads");
    prm.enter_subsection("Load factor");
    load_factor.add_parameters(prm, "the factor of all loads, 1 if there is none,");
    prm.leave_subsection();
    prm.leave_subsection();
  }

  TimeTable ShellDynamics::load_table() const
  {
    return load_factor.empty() ? TimeTable(1.) : TimeTable(load_factor, "Loads/Load factor");
  }

  void ShellDynamics::check() const
  {
    analysis.check();
    load_table();
  }

  void ShellDynamics::run(RunContext &context)
  {
    std::unique_ptr<ShellModel> model;
    {
      const Timers::Scope timer(context.timers, "set-up");
      model = std::make_unique<ShellModel>(source.build(), analysis.shell, context.timers);
    }
    MotionObserver nothing_else;
    analysis.run(*model, load_table(), context, nothing_else);
  }
} // namespace semilunar::scene
