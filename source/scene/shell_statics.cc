// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/scene/shell_statics.h>

namespace semilunar::scene
{
  void ShellStatics::add_parameters(dealii::ParameterHandler &prm)
  {
    source.add_parameters(prm);
    analysis.add_parameters(prm);
  }

  void ShellStatics::run(RunContext &context)
  {
    std::unique_ptr<ShellModel> model;
    {
      const Timers::Scope timer(context.timers, "set-up");
      model = std::make_unique<ShellModel>(source.build(), analysis.shell, context.timers);
    }
    analysis.run(*model, context);
  }
} // namespace semilunar::scene
