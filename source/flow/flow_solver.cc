// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/flow/flow_solver.h>

#include <deal.II/fe/fe_tools.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace semilunar::flow
{
  using dealii::Tensor;

  template <int dim>
  FlowSolver<dim>::FlowSolver(const Parameters &parameters,
                              dealii::parallel::distributed::Triangulation<dim> &triangulation,
                              const dealii::Mapping<dim> &mapping,
                              const BoundaryConditions<dim> &conditions, Timers &timers)
      : prm((parameters.check(), parameters)), timers(timers), conditions(conditions),
        triangulation(triangulation), reference_mapping(mapping.clone()),
        space(triangulation, parameters.degree), transfer(space),
        equations(space, prm, this->conditions), linear_solver(equations, prm, timers),
        moved_mapping(parameters.degree)
  {
    make_nodes();
    reinit_vectors();
    equations.reinit(nodes);
    linear_solver.reinit();
  }

  template <int dim>
  void FlowSolver<dim>::make_nodes()
  {
    const auto &element = space.velocity_dofs().get_fe();
    dealii::FEValues<dim> values(*reference_mapping, element,
                                 dealii::Quadrature<dim>(element.get_unit_support_points()),
                                 dealii::update_quadrature_points);
    std::vector<dealii::types::global_dof_index> dofs(element.dofs_per_cell);
    nodes.reinit(space.velocities());
    for (const auto &cell : space.velocity_dofs().active_cell_iterators())
      if (!cell->is_artificial())
      {
        values.reinit(cell);
        cell->get_dof_indices(dofs);
        for (unsigned int i = 0; i < dofs.size(); ++i)
          if (space.nodes()->in_local_range(dofs[i]))
            for (unsigned int c = 0; c < dim; ++c)
              nodes.local_element(dim * space.nodes()->global_to_local(dofs[i]) + c) =
                  values.quadrature_point(i)[c];
      }
    space.make_readable_velocity(nodes);
    for (Vector *copy : {&reference_nodes, &old_nodes, &older_nodes})
    {
      copy->reinit(space.velocities()); // assignment alone may keep the ghosts of an old mesh
      *copy = nodes;
      space.make_readable_velocity(*copy);
    }
  }

  template <int dim>
  void FlowSolver<dim>::reinit_vectors()
  {
    for (FlowVector *vector : {&state, &old_state, &older_state, &residual, &change})
      vector->reinit(space);
    for (Vector *vector : {&history, &advecting, &node_velocity})
      vector->reinit(space.velocities());
    mapping_is_valid = false;
  }

  template <int dim>
  Vector FlowSolver<dim>::interpolate(const VectorFunction<dim> &function, const Vector &at,
                                      const double time) const
  {
    Vector result(space.velocities());
    for (unsigned int node = 0; node < space.nodes()->locally_owned_size(); ++node)
    {
      Point x;
      for (unsigned int c = 0; c < dim; ++c)
        x[c] = at.local_element(dim * node + c);
      const Tensor<1, dim> value = function(x, time);
      for (unsigned int c = 0; c < dim; ++c)
        result.local_element(dim * node + c) = value[c];
    }
    space.make_readable_velocity(result);
    return result;
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
      mesh_moves = true;
      nodes = interpolate(mesh_motion, reference_nodes, time);
      old_nodes = interpolate(mesh_motion, reference_nodes, time - first_dt);
      evaluate_geometry();
    }
    state.velocity = interpolate(velocity, nodes, time);
    old_state.velocity = interpolate(velocity, old_nodes, time - first_dt);
    state.pressure = 0.;
    if (pressure)
    {
      // Nodes of degree k-1 are not among those of degree k in general: by the mapping.
      const auto &element = space.pressure_dofs().get_fe();
      dealii::FEValues<dim> values(this->mapping(), element,
                                   dealii::Quadrature<dim>(element.get_unit_support_points()),
                                   dealii::update_quadrature_points);
      std::vector<dealii::types::global_dof_index> dofs(element.dofs_per_cell);
      for (const auto &cell : space.pressure_dofs().active_cell_iterators())
        if (!cell->is_artificial())
        {
          values.reinit(cell);
          cell->get_dof_indices(dofs);
          for (unsigned int i = 0; i < dofs.size(); ++i)
            if (space.pressures()->in_local_range(dofs[i]))
              state.pressure(dofs[i]) = pressure(values.quadrature_point(i), time);
        }
    }
    space.make_readable_pressure(state.pressure);
    old_state.pressure = state.pressure;
    older_nodes = old_nodes;
    older_state = old_state;
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
    std::swap(older_nodes, old_nodes);
    old_nodes = nodes;

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
      move_mesh(interpolate(mesh_motion, reference_nodes, current.time));
  }

  template <int dim>
  void FlowSolver<dim>::move_mesh(const Vector &new_positions)
  {
    mesh_moves = true;
    nodes = new_positions;
    space.make_readable_velocity(nodes);
    node_velocity.equ(bdf.alpha[0], nodes);
    node_velocity.add(bdf.alpha[1], old_nodes);
    if (bdf.alpha[2] != 0.)
      node_velocity.add(bdf.alpha[2], older_nodes);
    space.make_readable_velocity(node_velocity);
    evaluate_geometry();
  }

  template <int dim>
  void FlowSolver<dim>::evaluate_geometry()
  {
    Timers::Scope scope(timers, "flow: geometry");
    equations.update_geometry(nodes);
    mapping_is_valid = false;
  }

  template <int dim>
  void FlowSolver<dim>::first_guess()
  {
    // The extrapolated state or the old one: what has the smaller residual.
    const Vector *mesh = moving() ? &node_velocity : nullptr;
    equations.constraints().set_values(conditions, nodes, mesh, current.time);
    state = old_state;
    equations.constraints().impose(state.velocity);
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
    state = old_state;
    equations.constraints().impose(state.velocity);
  }

  template <int dim>
  void FlowSolver<dim>::solve_step()
  {
    Assert(in_step, dealii::ExcMessage("start_step() comes first."));
    Timers::Scope scope(timers, "flow");
    // A length of the mesh, and with it what makes both residuals comparable.
    const double n_nodes = space.velocity_dofs().n_dofs();
    const double volume =
        dealii::Utilities::MPI::sum(equations.cells().volume(), space.communicator());
    const double h = std::pow(volume / n_nodes, 1. / dim);
    linear_solver.set_continuity_weight(prm.density * bdf.alpha[0] * h + prm.viscosity / h);

    const Vector *mesh = moving() ? &node_velocity : nullptr;
    equations.start_step({bdf, current.time, &history, mesh}, body_force);
    const bool newton = prm.nonlinear == "Newton", iterate = prm.nonlinear != "linear-implicit";
    equations.linearise(advecting, newton);
    first_guess();
    // Residuals below this are rounding of inertia, viscous forces and pressure.
    constexpr double rounding = 1e-12;
    const double floor = rounding * ((prm.density * bdf.alpha[0] + prm.viscosity / (h * h)) *
                                         old_state.velocity.l2_norm() * volume / n_nodes +
                                     old_state.pressure.l2_norm() * std::pow(h, dim - 1) +
                                     equations.open_load(state.velocity));
    const double scale = current.residual;
    linear_target = std::max(prm.linear_tolerance * scale, floor);
    if (!iterate)
    {
      nonlinear_iteration(linear_target, false);
      return;
    }
    const double target = std::max(prm.nonlinear_tolerance * scale, floor);
    for (current.n_nonlinear = 0;;)
    {
      space.make_readable_velocity(state.velocity);
      equations.linearise(state.velocity, newton);
      equations.residual(state, residual);
      current.residual = linear_solver.norm(residual);
      if (current.residual <= target)
        return;
      if (current.n_nonlinear == prm.max_nonlinear || !std::isfinite(current.residual))
        throw NumericsError("the nonlinear iteration of the flow did not converge",
                            "t = " + std::to_string(current.time), "");
      nonlinear_iteration(std::max(prm.linear_tolerance * current.residual, 0.3 * target), newton);
    }
  }

  template <int dim>
  void FlowSolver<dim>::correct_step()
  {
    Assert(in_step, dealii::ExcMessage("solve_step() comes first."));
    Timers::Scope scope(timers, "flow");
    equations.residual(state, residual);
    if (linear_solver.norm(residual) > linear_target)
      nonlinear_iteration(linear_target, false);
  }

  template <int dim>
  unsigned int FlowSolver<dim>::nonlinear_iteration(const double target, bool)
  {
    residual.velocity *= -1.;
    residual.pressure *= -1.;
    const unsigned int n = linear_solver.solve(change, residual, target);
    state.velocity.zero_out_ghost_values();
    state.pressure.zero_out_ghost_values();
    state.velocity.add(1., change.velocity);
    state.pressure.add(1., change.pressure);
    space.make_readable_velocity(state.velocity);
    space.make_readable_pressure(state.pressure);
    ++current.n_nonlinear;
    current.n_linear += n;
    return n;
  }

  template <int dim>
  StepReport FlowSolver<dim>::accept_step()
  {
    Assert(in_step, dealii::ExcMessage("start_step() comes first."));
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
    nodes = old_nodes;
    std::swap(older_state, old_state);
    std::swap(older_nodes, old_nodes);
    in_step = false;
    if (moving())
      evaluate_geometry();
  }

  template <int dim>
  StepReport FlowSolver<dim>::advance(const double dt)
  {
    start_step(dt);
    try
    {
      solve_step();
    }
    catch (const NumericsError &)
    {
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
  typename StateTransfer<dim>::State FlowSolver<dim>::transferred_state()
  {
    typename StateTransfer<dim>::State carried;
    carried.velocities = {&state.velocity, &old_state.velocity};
    carried.pressures = {&state.pressure, &old_state.pressure};
    if (mesh_moves)
      for (Vector *displacement : {&nodes, &old_nodes})
        carried.velocities.push_back(displacement);
    carried.at_points = equations.cells().accumulated_pressure();
    return carried;
  }

  template <int dim>
  void FlowSolver<dim>::refine()
  {
    Assert(!in_step, dealii::ExcMessage("The mesh is refined between steps."));
    Timers::Scope scope(timers, "flow: refinement");
    // Displacements are carried over: new nodes then lie on the reference geometry's surfaces.
    nodes -= reference_nodes;
    old_nodes -= reference_nodes;
    for (const Vector *displacement : {&nodes, &old_nodes})
      space.make_readable_velocity(*displacement);
    triangulation.prepare_coarsening_and_refinement();
    transfer.prepare(transferred_state(), false);
    triangulation.execute_coarsening_and_refinement();
    space.distribute_dofs();
    equations.cells().reinit(equations.cells().accumulated_pressure() != nullptr);
    transfer.finish(transferred_state());
    renew();
  }

  template <int dim>
  void FlowSolver<dim>::renew()
  {
    const Vector displacement = nodes, old_displacement = old_nodes;
    const FlowVector current_state = state, previous_state = old_state;
    make_nodes();
    reinit_vectors();
    if (mesh_moves)
    {
      nodes += displacement;
      old_nodes += old_displacement;
    }
    space.make_readable_velocity(nodes);
    space.make_readable_velocity(old_nodes);
    state = current_state;
    old_state = previous_state;
    for (const FlowVector *vector : {&state, &old_state}) // copies come without ghosts
    {
      space.make_readable_velocity(vector->velocity);
      space.make_readable_pressure(vector->pressure);
    }
    older_nodes = old_nodes;
    older_state = old_state;
    equations.reinit(nodes);
    linear_solver.reinit();
  }

  template <int dim>
  std::vector<double> FlowSolver<dim>::save_state()
  {
    Assert(!in_step, dealii::ExcMessage("The state is saved between steps."));
    transfer.prepare(transferred_state(), true);
    linear_solver.reinit();
    std::vector<double> numbers = {current_time, old_dt, double(n_steps), double(mesh_moves),
                                   double(equations.cells().accumulated_pressure() != nullptr)};
    for (const auto &[id, condition] : conditions.all())
      if (condition.pressure)
        for (const double number : condition.pressure->state())
          numbers.push_back(number);
    return numbers;
  }

  template <int dim>
  void FlowSolver<dim>::load_state(const std::vector<double> &numbers)
  {
    current_time = numbers.at(0);
    old_dt = numbers.at(1);
    n_steps = static_cast<unsigned int>(numbers.at(2));
    mesh_moves = numbers.at(3) != 0.;
    unsigned int next = 5;
    for (const auto &[id, condition] : conditions.all())
      if (condition.pressure)
      {
        const unsigned int n = condition.pressure->state().size();
        condition.pressure->set_state({numbers.begin() + next, numbers.begin() + next + n});
        next += n;
      }
    space.distribute_dofs();
    reinit_vectors();
    equations.cells().reinit(numbers.at(4) != 0.);
    transfer.load(transferred_state(), numbers.at(4) != 0.);
    const Vector positions = nodes, old_positions = old_nodes;
    make_nodes();
    if (mesh_moves)
    {
      nodes = positions;
      old_nodes = old_positions;
    }
    older_nodes = old_nodes;
    older_state = old_state;
    equations.reinit(nodes);
    linear_solver.reinit();
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
  const dealii::Mapping<dim> &FlowSolver<dim>::mapping() const
  {
    if (mapping_is_valid)
      return moved_mapping;
    // Cells that are not active have no nodes of their own: any shape will do.
    const dealii::MappingQ<dim> coarse(1);
    const auto &element = space.velocity_dofs().get_fe();
    const auto hierarchic =
        dealii::FETools::lexicographic_to_hierarchic_numbering<dim>(space.degree());
    moved_mapping.initialize(
        triangulation,
        [&](const typename dealii::Triangulation<dim>::cell_iterator &cell)
        {
          std::vector<Point> points(element.dofs_per_cell);
          const bool known = cell->is_active() && !cell->is_artificial();
          const CellLane where = known ? space.lane_of(cell->active_cell_index()) : CellLane();
          for (unsigned int i = 0; i < points.size(); ++i)
            if (known)
              for (unsigned int c = 0; c < dim; ++c)
                points[hierarchic[i]][c] =
                    nodes.local_element(dim * space.velocity_nodes(where.batch)[i][where.lane] + c);
            else
              points[i] =
                  coarse.transform_unit_to_real_cell(cell, element.get_unit_support_points()[i]);
          return points;
        });
    mapping_is_valid = true;
    return moved_mapping;
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
    equations.unmasked_residual(state, residual);
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
