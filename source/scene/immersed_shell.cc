// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/scene/flow_simulation.h>
#include <semilunar/scene/immersed_shell.h>
#include <semilunar/scene/shell_companion.h>

namespace semilunar::scene
{
  void ImmersedShellParameters::add_parameters(dealii::ParameterHandler &prm)
  {
    namespace Patterns = dealii::Patterns;
    flow.add_parameters(prm);
    source.add_parameters(prm);
    section.add_parameters(prm);
    supports.may_move_rigidly = true;
    supports.add_parameters(prm);
    contact.add_parameters(prm);
    coupling.add_parameters(prm);
    prm.enter_subsection("Shell");
    prm.add_parameter("Rigid", rigid,
                      "Whether the surface does not move; then supports, material and loads do not "
                      "count");
    prm.add_parameter("Foundation", foundation,
                      "Stiffness per undeformed area of springs that hold the shell where it is "
                      "undeformed [dyn/cm^3]",
                      Patterns::Double(0.));
    prm.add_parameter("Load", load,
                      "Force per undeformed area, '(u, v, w)', expressions in the undeformed x, y, "
                      "z and t [dyn/cm^2]");
    prm.leave_subsection();
    prm.enter_subsection("Initial state");
    prm.add_parameter("Multiplier", initial_multiplier,
                      "Of the coupling, everywhere: the pressure on the side that the normal "
                      "points away from minus that on the other [dyn/cm^2]");
    prm.leave_subsection();
    prm.enter_subsection("Exact solution");
    prm.add_parameter("Displacement", exact_displacement,
                      "Of the shell, '(u, v, w)', expressions in the undeformed x, y, z and t "
                      "[cm]; it starts so, and errors of the last state are reported");
    prm.add_parameter("Shell velocity", exact_velocity,
                      "Its time derivative, if the displacement is given [cm/s]");
    prm.leave_subsection();
    prm.enter_subsection("Output");
    prm.enter_subsection("Shell");
    prm.add_parameter("Probes", probes,
                      "Points whose displacement is recorded, 'NAME: (x, y, z)', separated by "
                      "semicolons; the nearest point of the undeformed surface is taken");
    vtu.add_parameters(prm);
    prm.leave_subsection();
    prm.leave_subsection();
  }

  void ImmersedShellParameters::check() const
  {
    flow.check();
    if (flow.dimension != 3)
      throw InputError("Dimension", std::to_string(flow.dimension), "a surface is in space",
                       "write 3; a mesh of one cell between slip boundaries is as good as a plane");
    if (exact_displacement.empty() != exact_velocity.empty())
      throw InputError("Exact solution/Shell velocity", exact_velocity,
                       "displacement and velocity belong together", "give both or none");
  }

  void ImmersedShell::run(RunContext &context)
  {
    const MakeCompanion<3> make = [&](flow::FlowSolver<3> &flow, const mesh::Mesh<3> &mesh)
    { return std::make_unique<ShellCompanion>(parameters, flow, mesh, context); };
    FlowSimulation<3>(parameters.flow, context, make).run();
  }
} // namespace semilunar::scene
