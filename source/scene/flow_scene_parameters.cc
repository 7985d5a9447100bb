// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/core/parameters.h>
#include <semilunar/scene/flow_scene_parameters.h>

namespace semilunar::scene
{
  namespace Patterns = dealii::Patterns;

  void FlowRecordParameters::add_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Output");
    vtu.add_parameters(prm);
    prm.add_parameter("Section axis", section_axis, "Coordinate that is constant on the sections",
                      Patterns::Selection("x|y|z"));
    prm.add_parameter("Sections", sections,
                      "Coordinates of the cross-sections whose flow rate and mean pressure are "
                      "recorded [cm]",
                      Patterns::List(Patterns::Double()));
    prm.add_parameter("Forces", forces,
                      "Names of the boundaries on which the force of the fluid is recorded",
                      Patterns::List(Patterns::Anything()));
    prm.add_parameter(
        "Force scale", force_scale,
        "Forces are multiplied by this, as 2/(rho U^2 D) for coefficients of drag and "
        "lift",
        positive_number());
    prm.add_parameter(
        "Probes", probes,
        "Points where velocity and pressure are recorded, 'NAME: (x, y, z); ...' [cm]");
    prm.add_parameter("Wall probes", wall_probes,
                      "Points of an elastic wall at rest; the displacement of the node next to "
                      "each is recorded, 'NAME: (x, y, z); ...' [cm]");
    prm.add_parameter("Pressure differences", pressure_differences,
                      "Between two probes, 'NAME: (PROBE, PROBE); ...'");
    prm.add_parameter(
        "Peaks", peaks,
        "Columns of the time series whose largest and smallest values and their times "
        "are reported",
        Patterns::List(Patterns::Anything()));
    prm.add_parameter("Oscillations", oscillations,
                      "Columns of the time series of which mean ((max + min) / 2), amplitude and "
                      "frequency of the last two periods are reported",
                      Patterns::List(Patterns::Anything()));
    prm.leave_subsection();
  }

  void FlowSceneParameters::add_parameters(dealii::ParameterHandler &prm)
  {
    prm.add_parameter("Dimension", dimension, "Of space: 2 or 3", Patterns::Integer(2, 3));
    mesh.add_parameters(prm);
    prm.enter_subsection("Mesh");
    adaptivity.add_parameters(prm);
    prm.enter_subsection("Motion");
    prm.add_parameter("Displacement", displacement,
                      "Displacement of the mesh over time, '(u, v, w)', expressions in the "
                      "coordinates x, y, z before and t [cm]; empty: the mesh is at rest");
    prm.leave_subsection();
    prm.leave_subsection();
    flow.add_parameters(prm);
    wall.add_parameters(prm);
    boundaries.add_parameters(prm);

    prm.enter_subsection("Time");
    prm.add_parameter("End", end, "[s], > 0; the start is 0", positive_number());
    prm.add_parameter("Step", step, "Time step, or the first one if steps are controlled [s], > 0",
                      positive_number());
    prm.add_parameter("Steady tolerance", steady_tolerance,
                      "The run ends early once the velocity changes by less than this share of its "
                      "norm within a unit of time [1/s]; 0: never",
                      Patterns::Double(0.));
    prm.leave_subsection();

    prm.add_parameter("Constants", constants,
                      "Names for numbers in expressions, 'nu: 0.01, U: 1.5'",
                      Patterns::Map(Patterns::Anything(), Patterns::Double()));
    prm.enter_subsection("Initial state");
    prm.add_parameter(
        "Velocity", initial_velocity,
        "'(u, v, w)', expressions in x, y, z, t [cm/s]; empty: the exact solution, or "
        "at rest if there is none");
    prm.leave_subsection();
    prm.enter_subsection("Body force");
    prm.add_parameter("Force", body_force,
                      "Per volume, '(u, v, w)', expressions in x, y, z, t [dyn/cm^3]; empty: none");
    prm.leave_subsection();
    prm.enter_subsection("Exact solution");
    prm.add_parameter("Velocity", exact_velocity,
                      "'(u, v, w)', expressions in x, y, z, t [cm/s]; if given, errors of the last "
                      "state are reported");
    prm.add_parameter("Pressure", exact_pressure, "Expression in x, y, z, t [dyn/cm^2]");
    prm.leave_subsection();
    record.add_parameters(prm);
    checkpoints.add_parameters(prm);
  }

  void FlowSceneParameters::check() const
  {
    mesh.check(dimension);
    flow.check();
    if (record.section_axis == "z" && dimension == 2 && !record.sections.empty())
      throw InputError("Output/Section axis", "z", "the plane has no z axis", "choose x or y");
    wall.check(dimension);
    if (adaptivity.interval > 0 && !displacement.empty())
      throw InputError("Mesh/Adaptivity/Interval", std::to_string(adaptivity.interval),
                       "a mesh that moves does not adapt", "set it to 0");
  }
} // namespace semilunar::scene
