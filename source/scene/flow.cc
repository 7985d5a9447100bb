// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/scene/flow.h>
#include <semilunar/scene/flow_simulation.h>

namespace semilunar::scene
{
  void Flow::add_parameters(dealii::ParameterHandler &prm)
  {
    parameters.add_parameters(prm);
  }

  std::string Flow::finer() const
  {
    return "Mesh/Refinements + 1; Time/Step / 2";
  }

  void Flow::check() const
  {
    parameters.check();
  }

  void Flow::run(RunContext &context)
  {
    if (parameters.dimension == 2)
      FlowSimulation<2>(parameters, context).run();
    else
      FlowSimulation<3>(parameters, context).run();
  }
} // namespace semilunar::scene
