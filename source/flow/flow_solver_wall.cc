// SPDX-License-Identifier: LGPL-2.1-or-later
// Members of FlowSolver for an elastic wall and the mesh that follows it.
#include <semilunar/core/exceptions.h>
#include <semilunar/flow/flow_solver.h>
#include <semilunar/flow/scaled_jacobian.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace semilunar::flow
{
  using dealii::Tensor;

  template <int dim>
  void FlowSolver<dim>::reinit_motion()
  {
    // The faces on which nodes slide are those at rest.
    equations.faces().update_geometry(nodes.reference_positions());
    motion->reinit(nodes.reference_positions(), equations.faces());
    equations.faces().update_geometry(nodes.positions());
  }

  template <int dim>
  void FlowSolver<dim>::move_with_wall(const Vector &velocity, Vector positions)
  {
    {
      Timers::Scope scope(timers, "flow: mesh motion");
      take_wall_positions(velocity, positions);
      if (motion) // not if the solid is alone
      {
        motion->solve(positions);
        current.min_scaled_jacobian = min_scaled_jacobian(space, positions);
      }
    }
    move_mesh(positions);
    // Gauss points may not show it.
    if (!(current.min_scaled_jacobian > 0.))
      throw NumericsError("the wall has turned over cells of the blood's mesh",
                          "t = " + std::to_string(current.time), "");
  }

  template <int dim>
  void FlowSolver<dim>::take_wall_positions(const Vector &velocity, Vector &positions) const
  {
    const Vector &found = equations.wall()->positions(velocity);
    positions.zero_out_ghost_values();
    for (const unsigned int node : equations.wall()->nodes().owned())
      for (unsigned int c = 0; c < dim; ++c)
        positions.local_element(dim * node + c) = found.local_element(dim * node + c);
  }

  template <int dim>
  double FlowSolver<dim>::distance_of_wall() const
  {
    const Vector &found = equations.wall()->positions(state.velocity);
    double largest = 0.;
    for (const unsigned int node : equations.wall()->nodes().owned())
      for (unsigned int c = 0; c < dim; ++c)
        largest = std::max(largest, std::abs(found.local_element(dim * node + c) -
                                             nodes.positions().local_element(dim * node + c)));
    return dealii::Utilities::MPI::max(largest, space.communicator());
  }

  template <int dim>
  double FlowSolver<dim>::follow_wall()
  {
    if (!equations.wall())
      return 0.;
    const double distance = distance_of_wall();
    move_with_wall(state.velocity, nodes.positions());
    return distance;
  }

  template <int dim>
  void FlowSolver<dim>::start_from_old_state()
  {
    state = old_state;
    if (equations.wall()) // its stiffness would count more than the change of the flow
      for (const unsigned int node : equations.wall()->nodes().owned())
        for (unsigned int c = 0; c < dim; ++c)
          state.velocity.local_element(dim * node + c) = advecting.local_element(dim * node + c);
    equations.constraints().impose(state.velocity);
  }

  template <int dim>
  void FlowSolver<dim>::iterate_in_wall()
  {
    const unsigned int before = current.n_nonlinear;
    equations.residual(state, residual);
    for (double size = linear_solver.norm(residual); size > linear_target;
         size = linear_solver.norm(residual))
    {
      if (current.n_nonlinear == before + prm.max_nonlinear || !std::isfinite(size))
        throw NumericsError("the iteration of blood and wall did not converge",
                            "t = " + std::to_string(current.time), "");
      equations.wall()->linearise(state.velocity);
      // A part of the target each, for what the linearisation of the wall leaves.
      constexpr double share = 0.5;
      add_linear_solution(share * linear_target);
      equations.residual(state, residual);
    }
    check_wall();
  }

  template <int dim>
  void FlowSolver<dim>::check_wall() const
  {
    const auto &solid = equations.wall()->solid();
    const double smallest = dealii::Utilities::MPI::min(
        solid.smallest_determinant(equations.wall()->positions(state.velocity)),
        space.communicator());
    if (!(smallest > 0.))
      throw NumericsError("cells of the wall are turned over",
                          "t = " + std::to_string(current.time), "");
  }

  template <int dim>
  void FlowSolver<dim>::iterate_geometry()
  {
    const WallParameters &wall = equations.wall()->parameters();
    for (current.n_geometry = 1; current.n_geometry < wall.max_geometry_iterations;
         ++current.n_geometry)
    {
      if (distance_of_wall() < wall.geometry_tolerance)
        return;
      follow_wall();
      equations.linearise(advecting, prm.nonlinear == "Newton");
      equations.constraints().set_values(conditions, nodes.positions(), nodes.velocity_if_moving(),
                                         current.time);
      correct_step();
    }
  }

  template <int dim>
  void FlowSolver<dim>::finish_wall()
  {
    current.interface_error = distance_of_wall();
    Vector positions = nodes.positions();
    take_wall_positions(state.velocity, positions);
    nodes.move(positions, bdf);
  }

  template <int dim>
  Tensor<1, dim> FlowSolver<dim>::force_on_blood(const std::vector<Id> &ids, const bool of_wall)
  {
    equations.unmasked_residual(state, residual, false);
    std::set<unsigned int> all;
    const unsigned int n_owned = space.nodes()->locally_owned_size();
    for (const Id id : ids)
      for (const unsigned int node : equations.faces().part(id).nodes)
        if (node < n_owned)
          all.insert(node);
    if (of_wall && equations.wall())
      for (const unsigned int node : equations.wall()->nodes().owned())
        if (equations.wall()->nodes().at_interface(node))
          all.insert(node);
    Tensor<1, dim> sum;
    for (const unsigned int node : all)
      for (unsigned int c = 0; c < dim; ++c)
        sum[c] += residual.velocity.local_element(dim * node + c);
    return dealii::Utilities::MPI::sum(sum, space.communicator());
  }

  template <int dim>
  Tensor<1, dim> FlowSolver<dim>::force_of_holds()
  {
    equations.unmasked_residual(state, residual, true);
    Tensor<1, dim> sum;
    for (const unsigned int node : equations.held())
      if (node < space.nodes()->locally_owned_size() && !space.velocity_hanging().hangs(node))
        for (unsigned int c = 0; c < dim; ++c)
          sum[c] += residual.velocity.local_element(dim * node + c);
    return dealii::Utilities::MPI::sum(sum, space.communicator());
  }

#define INSTANTIATE(dim)                                                                           \
  template void FlowSolver<dim>::reinit_motion();                                                  \
  template void FlowSolver<dim>::move_with_wall(const Vector &, Vector);                           \
  template void FlowSolver<dim>::take_wall_positions(const Vector &, Vector &) const;              \
  template double FlowSolver<dim>::distance_of_wall() const;                                       \
  template double FlowSolver<dim>::follow_wall();                                                  \
  template void FlowSolver<dim>::start_from_old_state();                                           \
  template void FlowSolver<dim>::check_wall() const;                                               \
  template void FlowSolver<dim>::iterate_in_wall();                                                \
  template void FlowSolver<dim>::iterate_geometry();                                               \
  template Tensor<1, dim> FlowSolver<dim>::force_of_holds();                                       \
  template void FlowSolver<dim>::finish_wall();                                                    \
  template Tensor<1, dim> FlowSolver<dim>::force_on_blood(const std::vector<Id> &, bool)
  INSTANTIATE(2);
  INSTANTIATE(3);
#undef INSTANTIATE
} // namespace semilunar::flow
