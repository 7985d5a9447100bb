// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/flow/equations.h>

namespace semilunar::flow
{
  template <int dim>
  Equations<dim>::Equations(const Spaces<dim> &spaces, const Parameters &parameters,
                            const BoundaryConditions<dim> &conditions, const WallParameters *wall)
      : space(spaces), prm(parameters), bc(conditions),
        forms(CellForms<dim>::create(spaces, parameters)), boundary(spaces), point_terms(spaces)
  {
    if (wall)
      wall_equations = std::make_unique<WallEquations<dim>>(spaces, *wall);
    else if (spaces.has_wall())
      throw InputError("Wall", "", "the mesh has cells of a wall that nothing is known about",
                       "describe the wall, or give the mesh a wall thickness of 0");
  }

  template <int dim>
  void Equations<dim>::reinit(const Vector &positions, const Vector &reference)
  {
    if (wall_equations)
    {
      wall_equations->reinit(reference);
      find_held_nodes(reference);
    }
    boundary.reinit();
    for (const auto &[id, part] : boundary.parts())
      if (bc.all().count(id) == 0)
        throw InputError("boundary " + std::to_string(id), "", "has no condition",
                         "give one for each part of the boundary of the flow mesh");
    point_terms.set({});
    if (wall_equations && wall_equations->parameters().has_support())
    {
      boundary.update_geometry(reference);
      wall_equations->reinit_support(boundary, bc.supported(), reference);
    }
    if (wall_equations && wall_equations->parameters().prestress != 0.)
    {
      update_geometry(reference);
      wall_equations->balance_pressure(*forms, boundary, fixed, reference);
    }
    update_geometry(positions);
  }

  template <int dim>
  void Equations<dim>::update_geometry(const Vector &positions)
  {
    forms->update_geometry(positions);
    boundary.update_geometry(positions);
    fixed.reinit(space, boundary, bc);
    fixed.hold(held_nodes);
  }

  template <int dim>
  void Equations<dim>::find_held_nodes(const Vector &reference)
  {
    held_nodes.clear();
    const unsigned int n_stored =
        space.nodes()->locally_owned_size() + space.nodes()->n_ghost_indices();
    for (unsigned int node = 0; node < n_stored; ++node)
      if (wall_equations->nodes().in_wall(node))
      {
        dealii::Point<dim> x;
        for (unsigned int c = 0; c < dim; ++c)
          x[c] = reference.local_element(dim * node + c);
        if (bc.is_held(x))
          held_nodes.push_back(node);
      }
  }

  template <int dim>
  void Equations<dim>::start_step(const Step &new_step, const VectorFunction<dim> &body_force)
  {
    step = new_step;
    relations.clear();
    has_resistance = false;
    for (const auto &[id, part] : boundary.parts())
      if (const auto &condition = bc.all().at(id); condition.pressure)
      {
        relations[id] = condition.pressure->relation(step.bdf, step.time);
        has_resistance = has_resistance || relations[id].resistance != 0.;
      }
    if (body_force)
      forms->set_body_force(body_force, step.time);
  }

  template <int dim>
  void Equations<dim>::linearise(const Vector &advecting, const bool newton)
  {
    forms->linearise({advecting, step.mesh_velocity, step.bdf.alpha[0], newton});
    if (wall_equations)
      wall_equations->linearise(advecting);
    for (const auto &[id, relation] : relations)
    {
      const double own = bc.all().at(id).backflow;
      const double beta = prm.convective_form == "none" ? 0. : own < 0. ? prm.backflow : own;
      boundary.linearise_backflow(id, beta * prm.density, advecting, step.mesh_velocity);
    }
  }

  template <int dim>
  std::map<dealii::types::boundary_id, double>
  Equations<dim>::open_flow_rates(const Vector &velocity) const
  {
    std::vector<double> rates;
    for (const auto &[id, relation] : relations)
      rates.push_back(boundary.part(id).flow_rate.local_value(velocity));
    dealii::Utilities::MPI::sum(rates, space.communicator(), rates);
    std::map<dealii::types::boundary_id, double> result;
    unsigned int i = 0;
    for (const auto &[id, relation] : relations)
      result[id] = rates[i++];
    return result;
  }

  template <int dim>
  double Equations<dim>::open_load(const Vector &velocity) const
  {
    const auto rates = open_flow_rates(velocity);
    double load = 0.;
    for (const auto &[id, relation] : relations)
      load += (std::abs(relation.pressure) + std::abs(relation.resistance * rates.at(id))) *
              boundary.part(id).normals.l2_norm();
    return load;
  }

  template <int dim>
  void Equations<dim>::finish_momentum(Vector &momentum, const bool masked) const
  {
    space.velocity_hanging().template fold<dim>(momentum.begin());
    momentum.compress(dealii::VectorOperation::add);
    if (masked)
      fixed.mask(momentum);
  }

  template <int dim>
  void Equations<dim>::finish_continuity(Vector &continuity) const
  {
    space.pressure_hanging().template fold<1>(continuity.begin());
    continuity.compress(dealii::VectorOperation::add);
  }

  template <int dim>
  void Equations<dim>::unmasked_residual(const FlowVector &state, FlowVector &r, const bool of_wall)
  {
    space.make_readable_velocity(state.velocity);
    space.make_readable_pressure(state.pressure);
    r.velocity.zero_out_ghost_values();
    r.pressure.zero_out_ghost_values();
    r.velocity = 0.;
    r.pressure = 0.;
    forms->add_residual(state.velocity, state.pressure, *step.history, r.velocity, r.pressure);
    if (wall_equations && of_wall)
      wall_equations->add_residual(state.velocity, *step.history, r.velocity);
    for (const auto &[id, relation] : relations)
      boundary.add_backflow(id, state.velocity, r.velocity);
    for (const auto &[id, part] : boundary.parts())
      if (const auto &traction = bc.all().at(id).traction)
        boundary.subtract_traction(id, traction, step.time, r.velocity);
    if (!point_terms.inactive())
      point_terms.add(state.velocity, true, r.velocity);
    finish_momentum(r.velocity, false);
    finish_continuity(r.pressure);
    const auto rates = open_flow_rates(state.velocity);
    for (const auto &[id, relation] : relations)
      boundary.part(id).flow_rate.add(relation.pressure + relation.resistance * rates.at(id),
                                      r.velocity);
  }

  template <int dim>
  void Equations<dim>::residual(const FlowVector &state, FlowVector &r)
  {
    unmasked_residual(state, r, true);
    fixed.mask(r.velocity);
  }

  template <int dim>
  void Equations<dim>::vmult(FlowVector &result, const FlowVector &x) const
  {
    space.make_readable_velocity(x.velocity);
    space.make_readable_pressure(x.pressure);
    result.velocity.zero_out_ghost_values();
    result.pressure.zero_out_ghost_values();
    result.velocity = 0.;
    result.pressure = 0.;
    forms->add_jacobian(x.velocity, x.pressure, result.velocity, result.pressure);
    if (wall_equations)
      wall_equations->add_jacobian(x.velocity, result.velocity);
    for (const auto &[id, relation] : relations)
      boundary.add_backflow(id, x.velocity, result.velocity);
    if (!point_terms.inactive())
      point_terms.add(x.velocity, false, result.velocity);
    finish_momentum(result.velocity, false);
    finish_continuity(result.pressure);
    if (has_resistance)
    {
      const auto rates = open_flow_rates(x.velocity);
      for (const auto &[id, relation] : relations)
        boundary.part(id).flow_rate.add(relation.resistance * rates.at(id), result.velocity);
    }
    fixed.mask(result.velocity);
  }

  template <int dim>
  void Equations<dim>::gradient(Vector &result, const Vector &p) const
  {
    space.make_readable_pressure(p);
    result.zero_out_ghost_values();
    result = 0.;
    forms->add_gradient(p, result);
    finish_momentum(result, true);
  }

  template class Equations<2>;
  template class Equations<3>;
} // namespace semilunar::flow
