// SPDX-License-Identifier: LGPL-2.1-or-later
// Members of FlowSolver that carry the state over to another mesh or another run.
#include <semilunar/flow/flow_solver.h>

namespace semilunar::flow
{
  template <int dim>
  typename StateTransfer<dim>::State FlowSolver<dim>::transferred_state(const bool mesh_moves)
  {
    typename StateTransfer<dim>::State carried;
    carried.velocities = {&state.velocity, &old_state.velocity};
    carried.pressures = {&state.pressure, &old_state.pressure};
    if (mesh_moves)
      for (Vector *positions : nodes.transferred())
        carried.velocities.push_back(positions);
    carried.at_points = equations.cells().accumulated_pressure();
    return carried;
  }

  template <int dim>
  void FlowSolver<dim>::refine()
  {
    Assert(!in_step, dealii::ExcMessage("The mesh is refined between steps."));
    Timers::Scope scope(timers, "flow: refinement");
    nodes.make_displacements();
    triangulation.prepare_coarsening_and_refinement();
    transfer.prepare(transferred_state(nodes.moving()), false);
    triangulation.execute_coarsening_and_refinement();
    space.distribute_dofs();
    equations.cells().reinit(equations.cells().accumulated_pressure() != nullptr);
    transfer.finish(transferred_state(nodes.moving()));
    renew(nodes.moving(), true);
  }

  template <int dim>
  void FlowSolver<dim>::renew(const bool mesh_moves, const bool from_displacements)
  {
    nodes.renew(mesh_moves, from_displacements);
    const FlowVector current_state = state, previous_state = old_state;
    reinit_vectors();
    state = current_state;
    old_state = previous_state;
    for (const FlowVector *vector : {&state, &old_state}) // copies come without ghosts
    {
      space.make_readable_velocity(vector->velocity);
      space.make_readable_pressure(vector->pressure);
    }
    older_state = old_state;
    equations.reinit(nodes.positions(), nodes.reference_positions());
    if (motion)
      reinit_motion();
    linear_solver.reinit();
  }

  template <int dim>
  std::vector<double> FlowSolver<dim>::save_state()
  {
    Assert(!in_step, dealii::ExcMessage("The state is saved between steps."));
    transfer.prepare(transferred_state(nodes.moving()), true);
    linear_solver.reinit();
    std::vector<double> numbers = {current_time, old_dt, double(n_steps), double(nodes.moving()),
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
    const bool mesh_moves = numbers.at(3) != 0., with_points = numbers.at(4) != 0.;
    unsigned int next = 5;
    for (const auto &[id, condition] : conditions.all())
      if (condition.pressure)
      {
        const unsigned int n = condition.pressure->state().size();
        condition.pressure->set_state({numbers.begin() + next, numbers.begin() + next + n});
        next += n;
      }
    space.distribute_dofs();
    equations.cells().reinit(with_points);
    transfer.load(transferred_state(mesh_moves), with_points);
    renew(mesh_moves, false);
  }

#define INSTANTIATE(dim)                                                                           \
  template typename StateTransfer<dim>::State FlowSolver<dim>::transferred_state(bool);            \
  template void FlowSolver<dim>::refine();                                                         \
  template void FlowSolver<dim>::renew(bool, bool);                                                \
  template std::vector<double> FlowSolver<dim>::save_state();                                      \
  template void FlowSolver<dim>::load_state(const std::vector<double> &)
  INSTANTIATE(2);
  INSTANTIATE(3);
#undef INSTANTIATE
} // namespace semilunar::flow
