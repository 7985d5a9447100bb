// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/scene/fsi_simulation.h>
#include <semilunar/scene/valve_fsi.h>

#include <semilunar/core/exceptions.h>
#include <semilunar/core/parameters.h>

namespace semilunar::scene
{
  void ValveFsiParameters::add_parameters(dealii::ParameterHandler &prm)
  {
    namespace Patterns = dealii::Patterns;
    source.add_parameters(prm);
    prm.enter_subsection("Valve");
    prm.add_parameter(
        "Stent in the flow", has_stent,
        "Whether the stent with its suture ring stands in the blood. Without it, blood "
        "passes around the leaflets.");
    prm.leave_subsection();
    section.add_parameters(prm);
    supports.add_parameters(prm);
    contact.add_parameters(prm);
    mesh.shape = mesh::Shape::artery;
    mesh.add_parameters(prm);
    flow.add_parameters(prm);
    wall.add_parameters(prm);
    prm.enter_subsection("Wall");
    prm.add_parameter(
        "Held by the stent", held_wall,
        "An elastic wall stands still within this distance of the plane of the suture "
        "ring [cm]",
        Patterns::Double(0.));
    prm.leave_subsection();
    boundaries.add_parameters(prm);
    coupling.add_parameters(prm);
    refinement.add_parameters(prm);
    prm.enter_subsection("Initial state");
    prm.add_parameter("Pressure", initial_pressure,
                      "Of the blood at rest, everywhere [mmHg]. The leaflets begin undeformed.");
    prm.leave_subsection();
    prm.enter_subsection("Time");
    prm.add_parameter("End", end, "[s]; the start is 0", positive_number());
    prm.add_parameter("Step", step,
                      "Largest time step [s]; one that fails is halved, and grows back",
                      positive_number());
    prm.add_parameter("Smallest step", smallest_step, "Below this the run has failed [s]",
                      positive_number());
    prm.leave_subsection();
    checkpoints.add_parameters(prm);
    prm.enter_subsection("Output");
    prm.add_parameter("Series interval", series_interval,
                      "Time between rows of the time series [s]; 0: a row for each step",
                      Patterns::Double(0.));
    prm.add_parameter(
        "Wall probes", wall_probes,
        "Places of an elastic wall at rest whose displacement is recorded, 'NAME: (x, "
        "y, z)', separated by semicolons");
    prm.add_parameter("Sections", sections,
                      "z of the cross-sections before and behind the valve between which the "
                      "pressure difference is taken [cm]",
                      Patterns::List(Patterns::Double(), 2, 2));
    prm.enter_subsection("Leaflets");
    shell_vtu.add_parameters(prm);
    prm.add_parameter("Interval", shell_interval,
                      "Time between VTU files [s]; 0: the first and the last state only",
                      Patterns::Double(0.));
    prm.leave_subsection();
    prm.enter_subsection("Blood");
    flow_vtu.add_parameters(prm);
    prm.leave_subsection();
    prm.leave_subsection();
  }

  void ValveFsiParameters::check() const
  {
    source.check();
    mesh.check(3);
    flow.check();
    if (source.leaflets == "one")
      throw InputError("Valve/Modelled leaflets", "one", "blood needs all leaflets", "write all");
    if (refinement.levels > 0 && (mesh.refinement.n_boxes > 0 || mesh.refinement.n_boundaries > 0))
      throw InputError("Refinement/Levels", std::to_string(refinement.levels),
                       "a mesh that follows the leaflets becomes as coarse elsewhere as it is "
                       "anywhere",
                       "leave out Mesh/Box refinements and Boundary refinements, or write 0");
    if (!contact.enabled)
      throw InputError("Contact/Enabled", "false",
                       "leaflets in the flow would pass through each "
                       "other",
                       "write true");
  }

  void ValveFsi::run(RunContext &context)
  {
    FsiSimulation(parameters, context).run();
  }
} // namespace semilunar::scene
