// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/archive.h>
#include <semilunar/core/exceptions.h>
#include <semilunar/core/units.h>
#include <semilunar/mesh/quality.h>
#include <semilunar/scene/elastic_wall.h>
#include <semilunar/scene/flow_checkpoint.h>
#include <semilunar/scene/valve_in_blood.h>
#include <semilunar/valve/stent.h>

#include <algorithm>
#include <cmath>

namespace semilunar::scene
{
  namespace
  {
    /// Immersed points of an element in each direction, before any element asks for more.
    constexpr unsigned int fewest_points = 2;

    std::unique_ptr<ShellModel> make_model(const ValveFsiParameters &prm, Timers &timers)
    {
      const Timers::Scope timer(timers, "set-up");
      ShellParameters shell;
      shell.section = prm.section;
      shell.supports = prm.supports;
      shell.contact = prm.contact;
      return std::make_unique<ShellModel>(prm.source.build(), shell, timers);
    }

    /// Of the blood, and of an elastic wall where the suture ring cuts it.
    flow::BoundaryConditions<3> make_conditions(const ValveFsiParameters &prm,
                                                const mesh::Mesh<3> &mesh)
    {
      auto conditions = prm.boundaries.conditions<3>(mesh, {}, {});
      support_wall(prm.wall, mesh, conditions);
      if (prm.has_stent)
        conditions.hold_wall(
            [radius = prm.source.design.stent.ring_outer_radius,
             width = prm.held_wall](const auto &x)
            { return std::abs(x[2]) <= width && std::hypot(x[0], x[1]) <= radius; });
      return conditions;
    }
  } // namespace

  ValveInBlood::ValveInBlood(const ValveFsiParameters &parameters, Log &log, Timers &timers)
      : prm(parameters), log(log), timers(timers), model(make_model(prm, timers)),
        mass(model->surface, model->points, prm.section.mass_per_area()),
        mesh(mesh::make_mesh<3>(prm.mesh, MPI_COMM_WORLD)),
        refinement(mesh->triangulation, prm.refinement,
                   coupling::surface_points(model->surface, model->points,
                                            spline::positions(model->surface))
                       .positions),
        points(model->surface, fewest_points),
        shell(model->surface, points, model->equations, model->equilibrium, mass),
        mapping(prm.flow.degree), conditions(make_conditions(prm, *mesh)),
        flow(prm.flow, mesh->triangulation, mapping, conditions, timers, &prm.wall),
        velocity_dofs(std::make_unique<output::VelocityDofs<3>>(flow.spaces().velocity_dofs()))
  {
    check_wall_exists(prm.wall, has_elastic_wall(), log);
    const Timers::Scope timer(timers, "set-up");
    flow.initialise(
        0., [](const auto &, double) { return dealii::Tensor<1, 3>(); },
        [this](const auto &, double) { return mmHg * prm.initial_pressure; });
    coupled = std::make_unique<coupling::FluidStructure>(
        flow, coupling::ImmersedShell{&shell, model->surface, points, prm.section.mass_per_area()},
        stent_points(), prm.flow, prm.coupling, timers);
    if (coupled->shell_points()->n_inside() < n_points())
      throw InputError("Valve", "", "a part of the leaflets lies outside of the artery",
                       "make the artery wider than the valve");
  }

  double ValveInBlood::cell_width_at_valve() const
  {
    const double top = prm.source.design.commissure_height, radius = prm.source.design.radius;
    double smallest = std::numeric_limits<double>::max();
    for (const auto &cell : mesh->triangulation.active_cell_iterators())
    {
      const auto centre = cell->center();
      if (cell->is_locally_owned() && centre[2] > 0. && centre[2] < top &&
          std::hypot(centre[0], centre[1]) < radius)
        smallest = std::min(smallest, std::cbrt(cell->measure()));
    }
    return dealii::Utilities::MPI::min(smallest, MPI_COMM_WORLD);
  }

  unsigned int ValveInBlood::n_points_per_direction(const spline::Surface &surface) const
  {
    return coupling::n_points_per_direction(surface,
                                            cell_width_at_valve() / prm.coupling.points_per_cell);
  }

  coupling::SurfacePoints ValveInBlood::stent_points() const
  {
    if (!prm.has_stent)
      return {};
    const spline::Surface stent = valve::stent(prm.source.design);
    const shell::QuadraturePoints stent_points(stent, n_points_per_direction(stent));
    return coupling::surface_points(stent, stent_points, spline::positions(stent));
  }

  coupling::CoupledReport ValveInBlood::advance(const double dt)
  {
    const coupling::CoupledReport report = coupled->advance(dt);
    last_dt = report.flow.dt;
    if (report.new_points)
      log.line("elements have got other points: " + std::to_string(n_points()) +
               " immersed points of the leaflets");
    return report;
  }

  bool ValveInBlood::adapt_mesh(const unsigned int step)
  {
    const Timers::Scope timer(timers, "adaptive refinement");
    std::vector<unsigned int> with_points;
    for (const auto &point : coupled->shell_points()->local())
      with_points.push_back(point.active_cell_index);
    if (!refinement.due(step, with_points) ||
        !refinement.flag(coupled->positions_of_shell_points()))
      return false;
    velocity_dofs.reset(); // its handler must not see the mesh change
    flow.refine();
    renew_dofs();
    coupled->forget_history();
    log.line("the mesh has followed the leaflets: " +
             std::to_string(mesh->triangulation.n_global_active_cells()) + " cells");
    return true;
  }

  void ValveInBlood::renew_dofs()
  {
    velocity_dofs = std::make_unique<output::VelocityDofs<3>>(flow.spaces().velocity_dofs());
  }

  coupling::CoupledReport ValveInBlood::at_rest() const
  {
    coupling::CoupledReport report;
    for (const auto &[id, condition] : conditions.all())
      if (condition.kind == flow::BoundaryConditions<3>::Kind::open)
      {
        report.flow.flow_rate[id] = flow.flow_rate(id);
        report.flow.mean_pressure[id] = flow.mean_pressure(id);
      }
    return report;
  }

  double ValveInBlood::volume()
  {
    return dealii::Utilities::MPI::sum(flow.cells().volume(), flow.spaces().communicator());
  }

  output::FlowState<3> ValveInBlood::blood() const
  {
    return {flow.mapping(),
            velocity_dofs->handler(),
            flow.spaces().pressure_dofs(),
            flow.velocity(),
            flow.pressure(),
            prm.flow.density,
            prm.flow.viscosity,
            flow.time(),
            last_dt};
  }

  unsigned long long ValveInBlood::n_unknowns() const
  {
    return velocity_dofs->handler().n_dofs() + flow.spaces().pressure_dofs().n_dofs() +
           model->equations.n_equations();
  }

  void ValveInBlood::report_size() const
  {
    scene::report_size(*model, log);
    const mesh::Quality quality = mesh::measure<3>(mesh->triangulation, mapping);
    log.line(mesh::describe(quality) + ", " + std::to_string(n_unknowns()) + " unknowns in all");
    std::string text = std::to_string(n_points()) + " immersed points of the leaflets";
    if (const auto *rigid = coupled->rigid_points())
      text += ", " + std::to_string(rigid->n_inside()) + " of the stent's " +
              std::to_string(rigid->n_points()) + " (the others lie in the wall)";
    log.line(text);
  }

  std::string ValveInBlood::fit() const
  {
    return "a valve of " + std::to_string(model->surface.elements.size()) + " elements and " +
           std::to_string(model->equations.n_equations()) + " equations in an artery of " +
           std::to_string(mesh->triangulation.n_cells(0)) + " coarse cells";
  }

  void ValveInBlood::add_to(Checkpoints &checkpoints)
  {
    add_structure(checkpoints, *coupled, &shell, model.get());
    checkpoints.add_object("last-step", last_dt);
    checkpoints.add_distributed(
        "flow", [this](const std::filesystem::path &folder) { save_flow(flow, *mesh, folder); },
        [this](const std::filesystem::path &folder)
        {
          velocity_dofs.reset(); // its handler must not see the mesh change
          load_flow(flow, *mesh, folder);
          renew_dofs();
        });
  }

  void ValveInBlood::forget_history()
  {
    model->equilibrium.forget_history();
    coupled->forget_history();
  }
} // namespace semilunar::scene
