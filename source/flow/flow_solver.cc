// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/flow/flow_solver.h>
#include <semilunar/flow/nodal_values.h>

#include <algorithm>
#include <cmath>

namespace semilunar::flow
{
  using dealii::Tensor;

  template <int dim>
  FlowSolver<dim>::FlowSolver(const Parameters &parameters,
                              dealii::parallel::distributed::Triangulation<dim> &triangulation,
                              const dealii::Mapping<dim> &mapping,
                              const BoundaryConditions<dim> &conditions, Timers &timers,
                              const WallParameters *wall)
      : prm((parameters.check(), parameters)), timers(timers), conditions(conditions),
        triangulation(triangulation), space(triangulation, parameters.degree), transfer(space),
        nodes(space, mapping),
        equations(space, prm, this->conditions, space.has_wall() ? wall : nullptr),
        linear_solver(equations, prm, timers)
  {
    if (equations.wall() && space.has_lumen())
      motion = std::make_unique<MeshMotion<dim>>(space, equations.wall()->nodes(), conditions);
    reinit_vectors();
    equations.reinit(nodes.positions(), nodes.reference_positions());
    if (motion)
      motion->reinit(nodes.reference_positions(), equations.faces());
    linear_solver.reinit();
  }

  template <int dim>
  void FlowSolver<dim>::reinit_vectors()
  {
    for (FlowVector *vector : {&state, &old_state, &older_state, &residual, &change})
      vector->reinit(space);
    for (Vector *vector : {&history, &advecting})
      vector->reinit(space.velocities());
  }

  template <int dim>
  void FlowSolver<dim>::initialise(const double time)
  {
    initialise(time, [](const Point &, double) { return Tensor<1, dim>(); });
  }

  template <int dim>
  void FlowSolver<dim>::initialise(const double time, const VectorFunction<dim> &velocity,
                                   const std::function<double(const Point &, double)> &pressure,
                                   const double first_dt)
  {
    current_time = time;
    old_dt = first_dt;
    n_steps = first_dt > 0. ? 1 : 0;
    if (mesh_motion)
    {
      nodes.begin_motion(positions_at(time), positions_at(time - first_dt));
      evaluate_geometry();
    }
    state.velocity = nodal_velocities(space, velocity, nodes.positions(), time);
    old_state.velocity = nodal_velocities(space, velocity, nodes.old_positions(), time - first_dt);
    if (pressure)
      state.pressure = nodal_pressures(space, mapping(), pressure, time);
    else
      state.pressure = 0.;
    space.make_readable_pressure(state.pressure);
    old_state.pressure = state.pressure;
    older_state = old_state;
  }

  template <int dim>
  Vector FlowSolver<dim>::positions_at(const double time) const
  {
    return nodal_velocities(space, mesh_motion, nodes.reference_positions(), time);
  }

  template <int dim>
  void FlowSolver<dim>::start_step(const double dt)
  {
    Assert(!in_step, dealii::ExcMessage("A step is under way."));
    if (!(dt > 0.) || !std::isfinite(dt))
      throw NumericsError("the time step is not positive", "t = " + std::to_string(current_time),
                          "");
    in_step = true;
    const bool second = prm.time_scheme == "BDF2" && n_steps > 0;
    bdf = second ? Bdf::second_order(dt, old_dt) : Bdf::first_order(dt);
    // The states move on: what was at the end of the last step is the old one now.
    std::swap(older_state, old_state);
    old_state = state;
    nodes.start_step();

    history.equ(bdf.alpha[1], old_state.velocity);
    advecting = old_state.velocity;
    if (second)
    {
      history.add(bdf.alpha[2], older_state.velocity);
      advecting.sadd(1. + bdf.extrapolation, -bdf.extrapolation, older_state.velocity);
    }
    space.make_readable_velocity(history);
    space.make_readable_velocity(advecting);
    current = StepReport();
    current.time = current_time + dt;
    current.dt = dt;
    if (mesh_motion)
      move_mesh(positions_at(current.time));
    if (equations.wall())
    {
      equations.wall()->start_step(bdf, nodes.old_positions(), nodes.older_positions());
      const bool old = equations.wall()->parameters().prediction == "old velocity";
      move_with_wall(old ? old_state.velocity : advecting, nodes.extrapolated(bdf.extrapolation));
    }
  }

  template <int dim>
  void FlowSolver<dim>::move_mesh(const Vector &new_positions)
  {
    nodes.move(new_positions, bdf);
    evaluate_geometry();
  }

  template <int dim>
  void FlowSolver<dim>::evaluate_geometry()
  {
    Timers::Scope scope(timers, "flow: geometry");
    equations.update_geometry(nodes.positions());
  }

  template <int dim>
  void FlowSolver<dim>::first_guess()
  {
    // The extrapolated state or the old one: what has the smaller residual.
    equations.constraints().set_values(conditions, nodes.positions(), nodes.velocity_if_moving(),
                                       current.time);
    start_from_old_state();
    equations.residual(state, residual);
    const double old_norm = linear_solver.norm(residual);
    current.residual = old_norm;
    if (bdf.alpha[2] == 0.)
      return;
    std::swap(residual, change);
    state.velocity = advecting;
    state.pressure.sadd(1. + bdf.extrapolation, -bdf.extrapolation, older_state.pressure);
    equations.constraints().impose(state.velocity);
    equations.residual(state, residual);
    if (linear_solver.norm(residual) < old_norm)
      return;
    std::swap(residual, change);
    start_from_old_state();
  }

  template <int dim>
  double FlowSolver<dim>::prepare_solution()
  {
    // A length of the mesh, and with it what makes both residuals comparable.
    const double n_nodes = space.velocity_dofs().n_dofs();
    const double volume = dealii::Utilities::MPI::sum(
        space.has_lumen() ? equations.cells().volume()
                          : equations.wall()->solid().reference_volume(),
        space.communicator());
    const double h = std::pow(volume / n_nodes, 1. / dim);
    linear_solver.start_step();
    linear_solver.set_continuity_weight(prm.density * bdf.alpha[0] * h + prm.viscosity / h);

    equations.start_step({bdf, current.time, &history, nodes.velocity_if_moving()}, body_force);
    equations.linearise(advecting, prm.nonlinear == "Newton");
    first_guess();
    // Residuals below this are rounding of inertia, viscous forces and pressure.
    constexpr double rounding = 1e-12;
    // Strains of the wall are differences of positions, of which a hundredth of that is rounding.
    constexpr double of_positions = 1e-2;
    const double stiffness = equations.wall()
                                 ? equations.wall()->parameters().youngs_modulus *
                                       nodes.positions().l2_norm() * std::pow(h, dim - 2)
                                 : 0.;
    return rounding * (of_positions * stiffness +
                       (prm.density * bdf.alpha[0] + prm.viscosity / (h * h)) *
                           old_state.velocity.l2_norm() * volume / n_nodes +
                       old_state.pressure.l2_norm() * std::pow(h, dim - 1) +
                       equations.open_load(state.velocity));
  }

  template <int dim>
  void FlowSolver<dim>::solve_step()
  {
    Assert(in_step, dealii::ExcMessage("start_step() comes first."));
    Timers::Scope scope(timers, "flow");
    const double rounding = prepare_solution();
    linear_target = std::max(prm.linear_tolerance * current.residual, rounding);
    if (equations.wall() && prm.nonlinear == "linear-implicit")
      iterate_in_wall();
    else if (prm.nonlinear == "linear-implicit")
      add_linear_solution(linear_target);
    else
      iterate(std::max(prm.nonlinear_tolerance * current.residual, rounding));
  }

  template <int dim>
  void FlowSolver<dim>::iterate(const double target)
  {
    for (current.n_nonlinear = 0;;)
    {
      space.make_readable_velocity(state.velocity);
      equations.linearise(state.velocity, prm.nonlinear == "Newton");
      equations.residual(state, residual);
      current.residual = linear_solver.norm(residual);
      if (current.residual <= target)
        return;
      if (current.n_nonlinear == prm.max_nonlinear || !std::isfinite(current.residual))
        throw NumericsError("the nonlinear iteration of the flow did not converge",
                            "t = " + std::to_string(current.time), "");
      add_linear_solution(std::max(prm.linear_tolerance * current.residual, 0.3 * target));
    }
  }

  template <int dim>
  void FlowSolver<dim>::correct_step()
  {
    Assert(in_step, dealii::ExcMessage("solve_step() comes first."));
    Timers::Scope scope(timers, "flow");
    if (equations.wall())
    {
      iterate_in_wall();
      return;
    }
    equations.residual(state, residual);
    if (linear_solver.norm(residual) > linear_target)
      add_linear_solution(linear_target);
  }

  template <int dim>
  void FlowSolver<dim>::add_linear_solution(const double target)
  {
    residual.velocity *= -1.;
    residual.pressure *= -1.;
    current.n_linear += linear_solver.solve(change, residual, target);
    state.velocity.zero_out_ghost_values();
    state.pressure.zero_out_ghost_values();
    state.velocity.add(1., change.velocity);
    state.pressure.add(1., change.pressure);
    space.make_readable_velocity(state.velocity);
    space.make_readable_pressure(state.pressure);
    ++current.n_nonlinear;
  }

  template <int dim>
  StepReport FlowSolver<dim>::accept_step()
  {
    Assert(in_step, dealii::ExcMessage("start_step() comes first."));
    if (equations.wall())
      finish_wall();
    const auto rates = equations.cells().largest_rates();
    current.cfl = dealii::Utilities::MPI::max(rates.advection, space.communicator()) * bdf.dt;
    current.cell_reynolds = dealii::Utilities::MPI::max(rates.cell_reynolds, space.communicator());
    current.flow_rate = equations.open_flow_rates(state.velocity);
    for (const auto &[id, rate] : current.flow_rate)
    {
      current.mean_pressure[id] = mean_pressure(id);
      conditions.all().at(id).pressure->accept(bdf, current.time, rate);
    }
    if (bdf.alpha[2] != 0.)
    {
      advecting.zero_out_ghost_values();
      advecting.add(-1., state.velocity);
      const double largest = state.velocity.linfty_norm();
      if (largest > 0.)
        current.time_error =
            advecting.l2_norm() / (largest * std::sqrt(double(space.velocity_dofs().n_dofs())));
    }
    current_time = current.time;
    old_dt = bdf.dt;
    ++n_steps;
    in_step = false;
    return current;
  }

  template <int dim>
  void FlowSolver<dim>::reject_step()
  {
    state = old_state;
    std::swap(older_state, old_state);
    nodes.reject_step();
    in_step = false;
    if (nodes.moving())
      evaluate_geometry();
  }

  template <int dim>
  StepReport FlowSolver<dim>::advance(const double dt)
  {
    try
    {
      start_step(dt);
      solve_step();
      if (equations.wall())
        iterate_geometry();
    }
    catch (const NumericsError &)
    {
      if (in_step)
        reject_step();
      throw;
    }
    return accept_step();
  }

  template <int dim>
  double FlowSolver<dim>::suggested_dt(const double dt) const
  {
    // Steps grow by a fifth at most, for BDF2 with variable steps.
    constexpr double largest_growth = 1.2, smallest_growth = 0.3, safety = 0.9;
    double factor = 1.;
    if (prm.step_control == "CFL" && current.cfl > 0.)
      factor = prm.cfl / current.cfl;
    else if (prm.step_control == "error" && current.time_error > 0.)
      factor = safety * std::sqrt(prm.time_error / current.time_error);
    else
      return dt;
    factor = std::clamp(factor, smallest_growth, largest_growth);
    return std::clamp(factor * dt, prm.min_dt, prm.max_dt);
  }

  template <int dim>
  Vector FlowSolver<dim>::velocity_component(const unsigned int c) const
  {
    Vector component(space.nodes());
    for (unsigned int i = 0; i < component.locally_owned_size(); ++i)
      component.local_element(i) = state.velocity.local_element(dim * i + c);
    component.update_ghost_values();
    return component;
  }

  template <int dim>
  double FlowSolver<dim>::flow_rate(const Id id) const
  {
    return dealii::Utilities::MPI::sum(
        equations.faces().part(id).flow_rate.local_value(state.velocity), space.communicator());
  }

  template <int dim>
  double FlowSolver<dim>::mean_pressure(const Id id) const
  {
    return dealii::Utilities::MPI::sum(
               equations.faces().part(id).pressure.local_value(state.pressure),
               space.communicator()) /
           area(id);
  }

  template <int dim>
  Tensor<1, dim> FlowSolver<dim>::force(const Id id)
  {
    equations.unmasked_residual(state, residual, false);
    Tensor<1, dim> sum;
    for (const unsigned int node : equations.faces().part(id).nodes)
      if (node < space.nodes()->locally_owned_size())
        for (unsigned int c = 0; c < dim; ++c)
          sum[c] += residual.velocity.local_element(dim * node + c);
    return dealii::Utilities::MPI::sum(sum, space.communicator());
  }

  template class FlowSolver<2>;
  template class FlowSolver<3>;
} // namespace semilunar::flow
