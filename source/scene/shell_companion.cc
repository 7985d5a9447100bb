// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/archive.h>
#include <semilunar/core/exceptions.h>
#include <semilunar/scene/flow_checkpoint.h>
#include <semilunar/scene/shell_companion.h>

#include <algorithm>
#include <cmath>

namespace semilunar::scene
{
  namespace
  {
    /// Width of the smallest cell. Collective.
    double smallest_width(const mesh::Mesh<3> &mesh)
    {
      double smallest = std::numeric_limits<double>::max();
      for (const auto &cell : mesh.triangulation.active_cell_iterators())
        if (cell->is_locally_owned())
          smallest = std::min(smallest, std::cbrt(cell->measure()));
      return dealii::Utilities::MPI::min(smallest, MPI_COMM_WORLD);
    }

    ShellParameters shell_parameters(const ImmersedShellParameters &prm)
    {
      ShellParameters shell;
      shell.section = prm.section;
      shell.supports = prm.supports;
      shell.contact = prm.contact;
      return shell;
    }
  } // namespace

  ShellCompanion::Moving::Moving(const ImmersedShellParameters &prm, const spline::Surface &surface,
                                 const shell::QuadraturePoints &points, Timers &timers)
      : model(surface, shell_parameters(prm), timers),
        mass(model.surface, model.points, prm.section.mass_per_area()),
        motion(model.surface, points, model.equations, model.equilibrium, mass),
        probes(prm.probes, model.surface, "Output/Shell/Probes")
  {
    motion.set_foundation(prm.foundation);
  }

  ShellCompanion::ShellCompanion(const ImmersedShellParameters &parameters,
                                 flow::FlowSolver<3> &flow, const mesh::Mesh<3> &mesh,
                                 RunContext &context)
      : prm(parameters), context(context), flow(flow), surface(prm.source.build()),
        points(surface, coupling::n_points_per_direction(
                            surface, smallest_width(mesh) / prm.coupling.points_per_cell)),
        shell(prm.rigid ? nullptr : std::make_unique<Moving>(prm, surface, points, context.timers)),
        load(vector_field<3>(prm.load, prm.flow.constants, "Shell/Load")),
        displacement(field_if_given<3>(prm.exact_displacement, prm.flow.constants,
                                       "Exact solution/Displacement")),
        velocity(field_if_given<3>(prm.exact_velocity, prm.flow.constants,
                                   "Exact solution/Shell velocity")),
        coupled(flow,
                {shell ? &shell->motion : nullptr, surface, points, prm.section.mass_per_area()},
                shell ? coupling::SurfacePoints()
                      : coupling::surface_points(surface, points, spline::positions(surface)),
                prm.flow.flow, prm.coupling, context.timers),
        files(shell ? std::make_unique<ShellOutput>(context.folder, shell->model, prm.vtu)
                    : nullptr)
  {
    const auto *inside = shell ? coupled.shell_points() : coupled.rigid_points();
    if (inside->n_inside() == 0)
      throw InputError("Surface", "", "it lies outside of the mesh", "move one of them");
    coupled.set_multipliers(prm.initial_multiplier);
    if (shell && displacement)
      initialise();
  }

  void ShellCompanion::initialise()
  {
    // As the flow does: as if there had been steps before.
    const double before = -prm.flow.step;
    shell->motion.set_state({project(displacement, 0.), project(displacement, before),
                             project(velocity, 0.), project(velocity, before)});
  }

  shell::NonlinearSystem::Vector ShellCompanion::project(const VectorField<3> &field,
                                                         const double time) const
  {
    const ShellModel &model = shell->model;
    const auto values = [&](const unsigned int q) { return field(undeformed(q), time); };
    shell::NonlinearSystem::Vector right_hand_side, result;
    model.equations.restrict(shell->mass.load(values), right_hand_side);
    shell->mass.solve(model.equations, right_hand_side, result);
    return result;
  }

  dealii::Point<3> ShellCompanion::undeformed(const unsigned int q) const
  {
    const ShellModel &model = shell->model;
    const spline::SurfacePoint point{model.points.element(q), model.points.xi(q)};
    return dealii::Point<3>(spline::evaluate(model.surface, point)[spline::value]);
  }

  shell::ControlVectors ShellCompanion::load_at(const double time) const
  {
    return shell->mass.load([&](const unsigned int q)
                            { return load(undeformed(q), time) / shell->mass.per_area(); });
  }

  void ShellCompanion::report_size(Log &log) const
  {
    if (shell)
      scene::report_size(shell->model, log);
    const auto *inside = shell ? coupled.shell_points() : coupled.rigid_points();
    std::string text = std::to_string(inside->n_points()) + " immersed points";
    if (inside->n_inside() < inside->n_points())
      text += ", " + std::to_string(inside->n_inside()) + " of them in the mesh";
    log.line(text);
  }

  unsigned int ShellCompanion::n_unknowns() const
  {
    return shell ? shell->model.equations.n_equations() : 0;
  }

  flow::StepReport ShellCompanion::advance(const double dt)
  {
    if (shell)
      shell->motion.set_loads(load_at(flow.time() + dt));
    last = coupled.advance(dt);
    const double size = std::abs(last.power.fluid) + std::abs(last.power.structure);
    if (size > 0.)
      largest_imbalance = std::max(largest_imbalance, std::abs(last.power.imbalance()) / size);
    return last.flow;
  }

  std::vector<output::TimeSeries::Column> ShellCompanion::columns() const
  {
    std::vector<output::TimeSeries::Column> all = {
        {"coupling_iterations", "-"},  {"shell_residual", "-"},
        {"largest_slip", "cm/s"},      {"power_on_blood", "erg/s"},
        {"power_on_shell", "erg/s"},   {"power_dissipated", "erg/s"},
        {"force_on_surface_x", "dyn"}, {"force_on_surface_y", "dyn"},
        {"force_on_surface_z", "dyn"}};
    if (!shell)
      return all;
    all.insert(all.end(), {{"force_on_supports_x", "dyn"},
                           {"force_on_supports_y", "dyn"},
                           {"force_on_supports_z", "dyn"},
                           {"kinetic_energy", "erg"},
                           {"strain_energy", "erg"}});
    const auto more = shell->probes.columns();
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

  std::vector<double> ShellCompanion::row()
  {
    const auto force = last.force_on_shell + last.force_on_rigid;
    std::vector<double> all = {double(last.n_iterations),
                               last.residual,
                               last.largest_slip,
                               last.power.fluid,
                               last.power.structure,
                               last.power.dissipation,
                               force[0],
                               force[1],
                               force[2]};
    if (!shell)
      return all;
    dealii::Tensor<1, 3> on_supports = last.force_on_supports; // without what the shell bears else
    for (const auto &force : load_at(flow.time()))
      on_supports += force;
    all.insert(all.end(),
               {on_supports[0], on_supports[1], on_supports[2], shell->motion.kinetic_energy(),
                shell->model.equilibrium.strain_energy()});
    const auto more = shell->probes.displacements(positions());
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

  void ShellCompanion::write(const double time)
  {
    if (shell)
      files->write(time, positions());
  }

  double ShellCompanion::displacement_error() const
  {
    const shell::ControlVectors start = spline::positions(surface), now = positions();
    const shell::QuadraturePoints &points = coupled.gauss_points();
    double sum = 0.;
    for (unsigned int q = 0; q < points.n_points(); ++q)
    {
      const auto x = shell->motion.at_point(q, start);
      const auto exact = displacement(dealii::Point<3>(x), flow.time());
      sum += points.weight(q) * (shell->motion.at_point(q, now) - x - exact).norm_square();
    }
    return std::sqrt(sum);
  }

  void ShellCompanion::add_quantities(RunResults &results) const
  {
    results.quantities.push_back(
        {"immersed_points", double(coupled.gauss_points().n_points()), "-"});
    results.quantities.push_back({"largest_power_imbalance", largest_imbalance, "-"});
    if (shell && displacement)
      results.quantities.push_back({"displacement_error_l2", displacement_error(), "cm^2"});
  }

  std::string ShellCompanion::fit() const
  {
    return "a surface of " + std::to_string(surface.elements.size()) + " elements and " +
           std::to_string(n_unknowns()) + " equations";
  }

  void ShellCompanion::add_to(Checkpoints &checkpoints)
  {
    add_structure(checkpoints, coupled, shell ? &shell->motion : nullptr,
                  shell ? &shell->model : nullptr);
    checkpoints.add_object("largest-imbalance", largest_imbalance);
    if (shell)
      checkpoints.add_object("shell-files", *files);
  }

  void ShellCompanion::forget_history()
  {
    if (shell)
      shell->model.equilibrium.forget_history();
    coupled.forget_history();
  }
} // namespace semilunar::scene
