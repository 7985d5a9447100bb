// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/archive.h>
#include <semilunar/core/exceptions.h>
#include <semilunar/core/interrupt.h>
#include <semilunar/mesh/quality.h>
#include <semilunar/output/cell_numbers.h>
#include <semilunar/output/flow_errors.h>
#include <semilunar/output/wall_shear_stress.h>
#include <semilunar/scene/elastic_wall.h>
#include <semilunar/scene/flow_checkpoint.h>
#include <semilunar/scene/flow_simulation.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace semilunar::scene
{
  namespace
  {
    /// How often a step that fails is tried again with half its size.
    constexpr unsigned int max_halvings = 6;
    /// A step may be longer than asked for by this share to end exactly at the end: what rounding
    /// of the step in a scene file leaves over is no step of its own.
    constexpr double stretch = 1e-3;
    constexpr double end_tolerance = 1e-6; // of the end time

    template <int dim>
    flow::BoundaryConditions<dim> make_conditions(const FlowSceneParameters &prm,
                                                  const mesh::Mesh<dim> &mesh,
                                                  const VectorField<dim> &exact_velocity)
    {
      auto conditions = prm.boundaries.conditions<dim>(mesh, prm.constants, exact_velocity);
      support_wall(prm.wall, mesh, conditions);
      return conditions;
    }
  } // namespace

  template <int dim>
  FlowSimulation<dim>::FlowSimulation(const FlowSceneParameters &parameters, RunContext &context,
                                      const MakeCompanion<dim> &make_companion)
      : prm(parameters), context(context),
        exact_velocity(
            field_if_given<dim>(prm.exact_velocity, prm.constants, "Exact solution/Velocity")),
        mesh(mesh::make_mesh<dim>(prm.mesh, MPI_COMM_WORLD)),
        conditions(make_conditions<dim>(prm, *mesh, exact_velocity)), mapping(prm.flow.degree),
        solver(make_solver()), companion(make_companion ? make_companion(*solver, *mesh) : nullptr),
        wall(solver->wall() ? std::make_unique<WallRecord<dim>>(prm.record, *mesh) : nullptr),
        velocity_dofs(
            std::make_unique<output::VelocityDofs<dim>>(solver->spaces().velocity_dofs())),
        record(context.dry_run ? std::filesystem::path() : context.folder, prm.record, *mesh,
               context.restart, more_columns()),
        files(context.folder, prm.record.vtu, prm.boundaries.walls<dim>(*mesh)), progress{prm.step}
  {
    check_wall_exists(prm.wall, wall != nullptr, context.log);
    if (context.dry_run)
      return;
    checkpoints = std::make_unique<Checkpoints>(
        context.folder, prm.checkpoints,
        "a flow on a coarse mesh of " + std::to_string(mesh->triangulation.n_cells(0)) + " cells" +
            (companion ? " with " + companion->fit() : ""));
    add_to(*checkpoints);
  }

  template <int dim>
  std::unique_ptr<flow::FlowSolver<dim>> FlowSimulation<dim>::make_solver()
  {
    auto result = std::make_unique<flow::FlowSolver<dim>>(prm.flow, mesh->triangulation, mapping,
                                                          conditions, context.timers, &prm.wall);
    if (!prm.body_force.empty())
      result->set_body_force(vector_field<dim>(prm.body_force, prm.constants, "Body force/Force"));
    if (!prm.displacement.empty())
    {
      const auto displacement =
          vector_field<dim>(prm.displacement, prm.constants, "Mesh/Motion/Displacement");
      result->set_mesh_motion([displacement](const dealii::Point<dim> &x, const double time)
                              { return x + displacement(x, time); });
    }
    return result;
  }

  template <int dim>
  std::vector<output::TimeSeries::Column> FlowSimulation<dim>::more_columns() const
  {
    std::vector<output::TimeSeries::Column> all;
    if (wall)
      all = wall->columns();
    if (companion)
      for (const auto &column : companion->columns())
        all.push_back(column);
    return all;
  }

  template <int dim>
  std::vector<double> FlowSimulation<dim>::more_values(const flow::StepReport &report)
  {
    std::vector<double> all;
    if (wall)
      all = wall->row(report, *solver);
    if (companion)
      for (const double value : companion->row())
        all.push_back(value);
    return all;
  }

  template <int dim>
  void FlowSimulation<dim>::initialise()
  {
    const VectorField<dim> given =
        field_if_given<dim>(prm.initial_velocity, prm.constants, "Initial state/Velocity");
    if (given)
      solver->initialise(0., given);
    else if (!exact_velocity)
      solver->initialise(0.);
    else if (prm.exact_pressure.empty())
      solver->initialise(0., exact_velocity, {}, prm.step);
    else
      solver->initialise(
          0., exact_velocity,
          scalar_field<dim>(prm.exact_pressure, prm.constants, "Exact solution/Pressure"),
          prm.step);
  }

  template <int dim>
  output::FlowState<dim> FlowSimulation<dim>::state() const
  {
    return {solver->mapping(),  velocity_dofs->handler(), solver->spaces().pressure_dofs(),
            solver->velocity(), solver->pressure(),       prm.flow.density,
            prm.flow.viscosity, solver->time(),           progress.last_dt};
  }

  template <int dim>
  mesh::Material FlowSimulation<dim>::measured() const
  {
    return solver->spaces().has_lumen() ? mesh::lumen : mesh::wall;
  }

  template <int dim>
  void FlowSimulation<dim>::report_size() const
  {
    const mesh::Quality quality = mesh::measure<dim>(mesh->triangulation, mapping, measured());
    context.log.line(mesh::describe(quality) + ", " + std::to_string(n_unknowns()) + " unknowns");
    if (companion)
      companion->report_size(context.log);
  }

  template <int dim>
  unsigned int FlowSimulation<dim>::n_unknowns() const
  {
    return velocity_dofs->handler().n_dofs() + solver->spaces().pressure_dofs().n_dofs() +
           (companion ? companion->n_unknowns() : 0);
  }

  template <int dim>
  void FlowSimulation<dim>::add_to(Checkpoints &checkpoints)
  {
    checkpoints.add_object("progress", progress);
    checkpoints.add_object("record", record);
    checkpoints.add_object("files", files);
    if (companion)
      companion->add_to(checkpoints);
    checkpoints.add_distributed(
        "flow", [this](const std::filesystem::path &folder) { save_flow(*solver, *mesh, folder); },
        [this](const std::filesystem::path &folder)
        {
          velocity_dofs.reset(); // its handler must not see the mesh change
          load_flow(*solver, *mesh, folder);
          renew_dofs();
        });
  }

  template <int dim>
  void FlowSimulation<dim>::renew_dofs()
  {
    velocity_dofs = std::make_unique<output::VelocityDofs<dim>>(solver->spaces().velocity_dofs());
    record.reinit(state());
    last_velocity = solver->velocity();
  }

  template <int dim>
  void FlowSimulation<dim>::begin()
  {
    record.reinit(state());
    const Timers::Scope timer(context.timers, "initial state");
    initialise();
    last_velocity = solver->velocity();
    write();
  }

  template <int dim>
  void FlowSimulation<dim>::go_on()
  {
    checkpoints->restore();
    if (companion)
      companion->forget_history();
    if (prm.flow.step_control == "fixed")
      progress.dt = prm.step; // a restart may change it
    record.go_on();
    context.results.steps = progress.n_steps;
    context.results.newton_iterations = progress.n_nonlinear;
    context.log.line("going on from step " + std::to_string(progress.n_steps) + ", time " +
                     std::to_string(solver->time()));
  }

  template <int dim>
  void FlowSimulation<dim>::save_if_due()
  {
    if (!checkpoints->due(context.results.steps))
      return;
    const Timers::Scope timer(context.timers, "output");
    progress.n_steps = context.results.steps;
    progress.n_nonlinear = context.results.newton_iterations;
    record.remember_size();
    checkpoints->write(context.results.steps, solver->time());
    if (companion)
      companion->forget_history();
    context.log.line("checkpoint at time " + std::to_string(solver->time()));
  }

  template <int dim>
  bool FlowSimulation<dim>::at_end() const
  {
    return solver->time() >= prm.end * (1. - end_tolerance);
  }

  template <int dim>
  void FlowSimulation<dim>::run()
  {
    report_size();
    if (context.dry_run)
      return record.reinit(state());
    try
    {
      context.restart ? go_on() : begin();
      while (!at_end() && !interrupted())
      {
        const double left = prm.end - solver->time();
        const flow::StepReport report =
            step(left < progress.dt * (1. + stretch) ? left : progress.dt);
        finish_step(report);
        progress.dt = next_dt(report.dt);
        if (prm.steady_tolerance > 0. && rate_of_change(report.dt) < prm.steady_tolerance)
          break;
        save_if_due();
      }
    }
    catch (const NumericsError &error)
    {
      write();
      throw error.after((context.folder / progress.last_file).string());
    }
    if (interrupted())
      return;
    context.log.progress("flow", 1.);
    write();
    add_quantities();
  }

  template <int dim>
  flow::StepReport FlowSimulation<dim>::step(double dt)
  {
    const Timers::Scope timer(context.timers, "time steps");
    // What moves far may turn cells over that it would not in smaller steps.
    const bool may_retry = prm.flow.step_control != "fixed" || wall;
    for (unsigned int n = 0;; ++n)
      try
      {
        return companion ? companion->advance(dt) : solver->advance(dt);
      }
      catch (const NumericsError &error)
      {
        if (!may_retry || n == max_halvings)
          throw;
        context.log.line(std::string(error.what()) + "; trying half the step");
        dt *= 0.5;
      }
  }

  template <int dim>
  double FlowSimulation<dim>::next_dt(const double dt) const
  {
    constexpr double largest_growth = 1.2; // of a step that was cut
    return prm.flow.step_control == "fixed" ? std::min(prm.step, largest_growth * dt)
                                            : solver->suggested_dt(dt);
  }

  template <int dim>
  std::string FlowSimulation<dim>::describe(const flow::StepReport &report) const
  {
    char text[160];
    std::snprintf(text, sizeof(text),
                  "step %u, t = %.6g s, dt = %.3g s, CFL %.2f, cell Re %.0f, %u Krylov iterations",
                  context.results.steps, report.time, report.dt, report.cfl, report.cell_reynolds,
                  report.n_linear);
    return text;
  }

  template <int dim>
  void FlowSimulation<dim>::finish_step(const flow::StepReport &report)
  {
    ++context.results.steps;
    context.results.newton_iterations += report.n_nonlinear;
    progress.last_dt = report.dt;
    {
      const Timers::Scope timer(context.timers, "output");
      if (!prm.displacement.empty() || wall)
        record.reinit(state());
      record.add(report, *solver, state(), more_values(report));
      context.log.line(describe(report));
      context.log.progress("flow", std::min(report.time / prm.end, 0.999));
    }
    if (prm.record.vtu.interval > 0. && report.time >= progress.next_output - 0.5 * report.dt &&
        !at_end())
      write();
    if (prm.adaptivity.interval > 0 && context.results.steps % prm.adaptivity.interval == 0)
      adapt_mesh();
  }

  template <int dim>
  void FlowSimulation<dim>::adapt_mesh()
  {
    const Timers::Scope timer(context.timers, "adaptive refinement");
    if (!mesh::flag_cells(*mesh, output::error_indicators(state(), prm.adaptivity.vorticity_weight),
                          prm.adaptivity))
      return;
    velocity_dofs.reset();
    solver->refine();
    renew_dofs();
    if (companion)
      companion->forget_history();
    report_size();
  }

  template <int dim>
  void FlowSimulation<dim>::write()
  {
    const Timers::Scope timer(context.timers, "output");
    progress.last_file = files.write(state());
    if (companion)
      companion->write(solver->time());
    progress.next_output = solver->time() + prm.record.vtu.interval;
  }

  template <int dim>
  double FlowSimulation<dim>::rate_of_change(const double dt)
  {
    last_velocity -= solver->velocity();
    const double change = last_velocity.l2_norm();
    last_velocity = solver->velocity();
    const double norm = last_velocity.l2_norm();
    return norm > 0. ? change / norm / dt : std::numeric_limits<double>::infinity();
  }

  template <int dim>
  void FlowSimulation<dim>::add_quantities()
  {
    auto &results = context.results;
    record.add_quantities(results);
    const auto stress = output::wall_shear_stress(state(), prm.boundaries.walls<dim>(*mesh));
    const mesh::Quality quality =
        mesh::measure<dim>(mesh->triangulation, solver->mapping(), measured());
    results.unknowns = n_unknowns();
    if (companion)
      companion->add_quantities(results);
    results.quantities.insert(results.quantities.end(),
                              {{"wall_shear_stress_min", stress.min, "dyn/cm^2"},
                               {"wall_shear_stress_max", stress.max, "dyn/cm^2"},
                               {"wall_shear_stress_mean", stress.mean, "dyn/cm^2"},
                               {"cells", double(quality.n_cells), "-"},
                               {"min_scaled_jacobian", quality.min_scaled_jacobian, "-"},
                               {"volume", quality.volume, dim == 3 ? "cm^3" : "cm^2"}});
    if (!exact_velocity)
      return;
    const double time = solver->time();
    std::function<double(const dealii::Point<dim> &)> pressure;
    if (!prm.exact_pressure.empty())
      pressure = [time, p = scalar_field<dim>(prm.exact_pressure, prm.constants,
                                              "Exact solution/Pressure")](
                     const dealii::Point<dim> &x) { return p(x, time); };
    const output::FlowErrors errors = output::flow_errors<dim>(
        state(), [this, time](const dealii::Point<dim> &x) { return exact_velocity(x, time); },
        pressure, conditions.closed());
    results.quantities.insert(results.quantities.end(),
                              {{"velocity_error_l2", errors.velocity_l2, "cm/s"},
                               {"velocity_error_h1", errors.velocity_h1, "1/s"},
                               {"velocity_error_max", errors.velocity_max, "cm/s"}});
    if (pressure)
      results.quantities.push_back({"pressure_error_l2", errors.pressure_l2, "dyn/cm^2"});
  }

  template class FlowSimulation<2>;
  template class FlowSimulation<3>;
} // namespace semilunar::scene
