// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/coupling/fluid_structure.h>
#include <semilunar/shell/modified_newton.h>

#include <deal.II/base/mpi.h>

#include <cmath>

namespace semilunar::coupling
{
  using dealii::Tensor;
  using shell::ControlVectors;
  using Vector = shell::NonlinearSystem::Vector;

  namespace
  {
    /// One after the other.
    SurfacePoints concatenate(SurfacePoints first, const SurfacePoints &second)
    {
      const auto append = [](auto &to, const auto &from)
      { to.insert(to.end(), from.begin(), from.end()); };
      append(first.positions, second.positions);
      append(first.normals, second.normals);
      append(first.areas, second.areas);
      return first;
    }
  } // namespace

  FluidStructure::FluidStructure(flow::FlowSolver<3> &flow, const ImmersedShell &immersed,
                                 const SurfacePoints &rigid, const flow::Parameters &fluid,
                                 const Parameters &parameters, Timers &timers)
      : flow(flow), communicator(flow.spaces().communicator()), immersed(immersed),
        shell(immersed.motion), rigid(rigid), density(fluid.density), viscosity(fluid.viscosity),
        prm(parameters), timers(timers), gauss(&immersed.points), near(flow.spaces())
  {
    const Timers::Scope timer(timers, "coupling: points");
    if (shell)
    {
      y = shell->displacement();
      points = surface_points(immersed.surface, *gauss, shell->positions(y));
      in_shell = std::make_unique<ImmersedPoints>(flow, points.positions);
    }
    points = concatenate(std::move(points), rigid);
    if (!rigid.positions.empty())
      in_rigid = std::make_unique<ImmersedPoints>(flow, rigid.positions);
    lambda.assign(points.positions.size(), 0.);
    penalties.resize(points.positions.size());
    adapt_points();
  }

  SurfacePoints FluidStructure::all_points() const
  {
    return shell ? concatenate(surface_points(immersed.surface, *gauss, shell->positions(y)), rigid)
                 : rigid;
  }

  void FluidStructure::forget_history()
  {
    const Timers::Scope timer(timers, "coupling: points");
    if (shell)
    {
      y = shell->displacement();
      points = all_points();
      in_shell->search_again(points.positions);
    }
    if (in_rigid) // which of its points lie in the wall depends on the cells there
      in_rigid = std::make_unique<ImmersedPoints>(flow, rigid.positions);
    weighted_dt = 0.; // marks the cells anew
  }

  void FluidStructure::place_points()
  {
    const Timers::Scope timer(timers, "coupling: points");
    local.clear();
    if (shell)
    {
      points = all_points();
      in_shell->move(points.positions);
      local = in_shell->local();
    }
    if (in_rigid && flow.wall())
      in_rigid->follow_mesh(rigid.positions);
    if (in_rigid)
      for (ImmersedPoints::Local point : in_rigid->local())
      {
        point.q += n_shell_points();
        local.push_back(point);
      }
  }

  void FluidStructure::make_penalties()
  {
    const auto unit = dealii::unit_symmetric_tensor<3>();
    for (unsigned int q = 0; q < penalties.size(); ++q)
    {
      const bool takes_part = q < n_shell_points() ? in_shell->takes_part(q)
                                                   : in_rigid->takes_part(q - n_shell_points());
      penalties[q] =
          takes_part ? points.areas[q] * (prm.beta_tangential * unit +
                                          (prm.beta_normal - prm.beta_tangential) *
                                              outer_product(points.normals[q], points.normals[q]))
                     : Stiffness();
    }
    if (shell)
      shell->set_penalties({penalties.begin(), penalties.begin() + n_shell_points()});
  }

  void FluidStructure::mark_cells(const double dt)
  {
    constexpr double viscous_share = 16.; // k of (I7)
    if (prm.incompressibility == 0.)
      return;
    const Timers::Scope timer(timers, "coupling: marked cells");
    std::vector<unsigned int> cut;
    for (const ImmersedPoints::Local &point : local)
      cut.push_back(point.active_cell_index);
    const bool changed = near.mark(cut);
    if (!changed && dt == weighted_dt)
      return;
    weighted_dt = dt;
    flow.cells().set_accumulated_grad_div(near.weights(
        prm.incompressibility * density / dt, prm.incompressibility * viscous_share * viscosity));
    flow.preconditioner().invalidate_momentum();
  }

  void FluidStructure::set_terms()
  {
    // A shell gives way: what is left of the penalty is in series with its inertia, (I5).
    std::vector<flow::PointTerm<3>> terms;
    for (const ImmersedPoints::Local &point : local)
    {
      double isotropic = trace(penalties[point.q]) / 3.;
      if (point.q < n_shell_points() && prm.scheme == "quasi-direct")
      {
        const double inertia = immersed.mass_per_area * points.areas[point.q] * shell->rate();
        isotropic *= inertia / (inertia + isotropic);
      }
      terms.push_back(
          {point.active_cell_index, point.unit_point, penalties[point.q], {}, isotropic});
    }
    flow.points().set(terms);
  }

  void FluidStructure::set_term_forces(const std::vector<Force> &structure_velocities)
  {
    std::vector<Force> forces;
    for (unsigned int i = 0; i < local.size(); ++i)
    {
      const unsigned int q = local[i].q;
      forces.push_back(penalties[q] * structure_velocities[i] -
                       points.areas[q] * lambda[q] * points.normals[q]);
    }
    flow.points().set_forces(forces);
  }

  void FluidStructure::sum_over_ranks(ControlVectors &forces) const
  {
    if (dealii::Utilities::MPI::n_mpi_processes(communicator) == 1)
      return;
    const auto view = dealii::ArrayView<double>(forces.front().begin_raw(), 3 * forces.size());
    dealii::Utilities::MPI::sum(dealii::ArrayView<const double>(view), communicator, view);
  }

  ControlVectors FluidStructure::forces_on_shell(const std::vector<Force> &velocities,
                                                 const bool with_multiplier) const
  {
    ControlVectors forces(immersed.surface.control_points.size());
    for (unsigned int i = 0; i < local.size() && local[i].q < n_shell_points(); ++i)
    {
      const unsigned int q = local[i].q;
      Force force = penalties[q] * velocities[i];
      if (with_multiplier)
        force += points.areas[q] * lambda[q] * points.normals[q];
      shell->add_force(q, force, forces);
    }
    sum_over_ranks(forces);
    return forces;
  }

  std::vector<Tensor<1, 3>> FluidStructure::at_local_points(const Vector &vector) const
  {
    std::vector<Force> result(local.size());
    const ControlVectors control_vectors = shell->expand(vector);
    for (unsigned int i = 0; i < local.size() && local[i].q < n_shell_points(); ++i)
      result[i] = shell->at_point(local[i].q, control_vectors);
    return result;
  }

  Vector FluidStructure::displacement_response(const std::vector<Force> &velocities) const
  {
    Vector response;
    shell->restrict(forces_on_shell(velocities, false), response);
    shell->solve(response);
    return response;
  }

  std::vector<Tensor<1, 3>>
  FluidStructure::velocity_response(const std::vector<Force> &velocities) const
  {
    Vector response = displacement_response(velocities);
    response *= shell->rate();
    return at_local_points(response);
  }

  double FluidStructure::shell_residual(Vector &r)
  {
    shell->set_forces(forces_on_shell(u, true));
    const double scale = shell->residual(y, 0., r);
    const double size = r.l2_norm() / scale;
    if (!std::isfinite(size))
      throw NumericsError("the shell in the flow has no finite forces",
                          "t = " + std::to_string(flow.time()), "");
    return size;
  }

  void FluidStructure::check_iteration(const CoupledReport &report, const Vector &start) const
  {
    Vector change = y;
    change -= start;
    if (change.linfty_norm() > shell->largest_change())
      throw NumericsError("the shell moves too far in one step",
                          "t = " + std::to_string(flow.time()), "");
    if (report.n_iterations >= prm.max_iterations)
      throw NumericsError("the coupling of fluid and structure did not converge, residual " +
                              std::to_string(report.residual),
                          "t = " + std::to_string(flow.time()), "");
  }

  void FluidStructure::quasi_direct(CoupledReport &report)
  {
    const Vector start = shell->displacement();
    Vector r;
    flow.points().set_response([this](const std::vector<Force> &velocities)
                               { return velocity_response(velocities); });
    for (;; ++report.n_iterations)
    {
      report.residual = shell_residual(r);
      if (report.n_iterations > 0 && report.residual <= prm.tolerance)
        return;
      check_iteration(report, start);
      shell->linearize(y, 0., 0.);
      // y(u') = y - S^-1 r + S^-1 N^T K (u' - u), (I5), of which the fluid knows all but u'
      shell->solve(r);
      y -= r;
      y -= displacement_response(u);
      set_term_forces(at_local_points(shell->velocity(y)));
      if (report.n_iterations == 0)
        flow.solve_step();
      else
        flow.correct_step();
      u = flow.points().velocities(flow.velocity());
      y += displacement_response(u);
    }
  }

  void FluidStructure::block(CoupledReport &report)
  {
    const Vector start = shell->displacement();
    flow.points().set_response({});
    shell::ModifiedNewton newton;
    shell::IterationParameters iteration;
    iteration.tolerance = 0.1 * prm.tolerance;
    Vector r, change, last_change;
    double relaxation = 1.;
    for (;; ++report.n_iterations)
    {
      set_term_forces(at_local_points(shell->velocity(y)));
      if (report.n_iterations == 0)
        flow.solve_step();
      else
        flow.correct_step();
      u = flow.points().velocities(flow.velocity());
      report.residual = shell_residual(r);
      if (report.residual <= prm.tolerance)
        return;
      check_iteration(report, start);
      Vector solution = y;
      if (!newton.solve(*shell, start, solution, iteration).converged)
        throw NumericsError("the shell in the flow did not find its balance",
                            "t = " + std::to_string(flow.time()), "");
      change = solution;
      change -= y;
      if (report.n_iterations > 0)
      {
        // Aitken: relaxation that would have hit the fixed point of the last two changes
        Vector difference = change;
        difference -= last_change;
        relaxation *= -(last_change * difference) / difference.norm_sqr();
      }
      y.add(relaxation, change);
      last_change = change;
    }
  }

  CoupledReport FluidStructure::advance(const double dt)
  {
    CoupledReport report;
    report.new_points = adapt_points();
    try
    {
      flow.start_step(dt);
      if (shell)
      {
        shell->start_step(flow.time_derivative());
        y = shell->predict();
      }
      place_points();
      make_penalties();
      mark_cells(dt);
      set_terms();
      u = flow.points().velocities(flow.velocity());
      if (!shell)
      {
        set_term_forces(std::vector<Force>(local.size()));
        flow.solve_step();
        u = flow.points().velocities(flow.velocity());
      }
      else if (prm.scheme == "quasi-direct")
        quasi_direct(report);
      else
        block(report);
    }
    catch (const NumericsError &)
    {
      if (flow.step_under_way())
        flow.reject_step();
      if (shell)
        y = shell->displacement();
      throw;
    }
    finish(report);
    return report;
  }

  void FluidStructure::finish(CoupledReport &report)
  {
    const std::vector<Force> v =
        shell ? at_local_points(shell->velocity(y)) : std::vector<Force>(local.size());
    std::vector<double> new_lambda(lambda.size(), 0.);
    // of this rank: power on the fluid, dissipation, force on the shell, on the rigid surface
    std::vector<double> sums(8, 0.);
    for (unsigned int i = 0; i < local.size(); ++i)
    {
      const unsigned int q = local[i].q;
      const Force slip = u[i] - v[i];
      const Force force = penalties[q] * slip + points.areas[q] * lambda[q] * points.normals[q];
      const double normal_slip = slip * points.normals[q];
      report.largest_slip = std::max(report.largest_slip, std::abs(normal_slip));
      sums[1] += force * slip;
      for (unsigned int d = 0; d < 3; ++d)
        sums[(q < n_shell_points() ? 2 : 5) + d] += force[d];
      new_lambda[q] = (lambda[q] + prm.beta_normal * normal_slip) / (1. + prm.relaxation); // (I3)
    }
    sums[0] = -flow.points().power_at_nodes(flow.velocity());
    dealii::Utilities::MPI::sum(sums, communicator, sums);
    dealii::Utilities::MPI::sum(new_lambda, communicator, lambda);
    report.largest_slip = dealii::Utilities::MPI::max(report.largest_slip, communicator);
    report.power = {sums[0], shell ? shell->power(y) : 0., sums[1]};
    for (unsigned int d = 0; d < 3; ++d)
    {
      report.force_on_shell[d] = sums[2 + d];
      report.force_on_rigid[d] = sums[5 + d];
    }
    if (shell)
      report.force_on_supports = report.force_on_shell - shell->momentum_rate(y);
    if (prm.incompressibility > 0.)
      flow.cells().accumulate_divergence(flow.velocity());
    report.flow = flow.accept_step();
    if (shell)
      shell->accept_step(y);
  }
} // namespace semilunar::coupling
