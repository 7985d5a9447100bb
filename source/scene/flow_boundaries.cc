// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/core/nearest_name.h>
#include <semilunar/core/parameters.h>
#include <semilunar/core/units.h>
#include <semilunar/scene/flow_boundaries.h>

#include <algorithm>

namespace semilunar::scene
{
  namespace
  {
    const std::string section = "Boundary conditions/";
    const std::vector<std::string> kinds = {"wall",       "slip",       "velocity",
                                            "exact",      "traction",   "pressure",
                                            "resistance", "Windkessel", "flow rate"};

    /// The value of a boundary in one of the lists. @throws InputError if it is missing
    std::string value_for(const std::string &boundary, const std::string &list,
                          const std::string &entry, const std::string &kind)
    {
      for (const auto &[name, value] : named_parts(list, section + entry))
        if (name == boundary)
          return value;
      throw InputError(section + entry, list,
                       "boundary '" + boundary + "' of type '" + kind + "' is not in it",
                       "add '" + boundary + ": VALUE'");
    }

    bool is_in(const std::string &boundary, const std::string &list, const std::string &entry)
    {
      const auto parts = named_parts(list, section + entry);
      return std::any_of(parts.begin(), parts.end(),
                         [&](const auto &part) { return part.first == boundary; });
    }

    /// Makes the condition of one boundary.
    template <int dim>
    class Maker
    {
    public:
      Maker(const FlowBoundaries &prm, const Constants &constants, const VectorField<dim> &exact)
          : prm(prm), constants(constants), exact(exact)
      {
      }

      void add(const dealii::types::boundary_id id, const std::string &name,
               const std::string &kind, flow::BoundaryConditions<dim> &conditions) const
      {
        if (kind == "wall")
          conditions.set_wall(id);
        else if (kind == "slip")
          conditions.set_slip(id);
        else if (kind == "velocity")
          conditions.set_velocity(
              id, vector_field<dim>(value_for(name, prm.velocities, "Velocities", kind), constants,
                                    section + "Velocities"));
        else if (kind == "exact")
          conditions.set_velocity(id, exact_velocity());
        else if (kind == "traction")
          conditions.set_traction(id, traction(name));
        else
          conditions.set_open(id, pressure_model(name, kind));
      }

    private:
      const FlowBoundaries &prm;
      const Constants &constants;
      const VectorField<dim> &exact;

      VectorField<dim> exact_velocity() const
      {
        if (!exact)
          throw InputError(section + "Types", prm.types, "there is no exact solution",
                           "give Exact solution/Velocity");
        return exact;
      }

      flow::TractionFunction<dim> traction(const std::string &name) const
      {
        const auto field =
            vector_field<dim>(value_for(name, prm.tractions, "Tractions", "traction"), constants,
                              section + "Tractions");
        return [field](const dealii::Point<dim> &x, const dealii::Tensor<1, dim> &,
                       const double time) { return field(x, time); };
      }

      /// A function of time from the list, or else from the table.
      std::function<double(double)>
      from_list_or_table(const std::string &name, const std::string &list, const std::string &entry,
                         const TimeTableParameters &table, const std::string &table_entry,
                         const double unit, const std::string &kind) const
      {
        if (is_in(name, list, entry) || table.empty())
          return time_function(value_for(name, list, entry, kind), constants, section + entry);
        const TimeTable values(table, section + table_entry);
        return [values, unit](const double time) { return unit * values.value(time); };
      }

      std::shared_ptr<flow::PressureModel> pressure_model(const std::string &name,
                                                          const std::string &kind) const
      {
        if (kind == "pressure")
          return std::make_shared<flow::PrescribedPressure>(from_list_or_table(
              name, prm.pressures, "Pressures", prm.pressure_table, "Pressure table", mmHg, kind));
        if (kind == "flow rate")
          return std::make_shared<flow::PrescribedFlow>(
              from_list_or_table(name, prm.flow_rates, "Flow rates", prm.flow_rate_table,
                                 "Flow rate table", 1., kind),
              prm.flow_rate_inertance);
        if (kind == "resistance")
          return std::make_shared<flow::Resistance>(
              number(value_for(name, prm.pressures, "Pressures", kind), constants,
                     section + "Pressures"),
              number(value_for(name, prm.resistances, "Resistances", kind), constants,
                     section + "Resistances"));
        return windkessel(name);
      }

      std::shared_ptr<flow::PressureModel> windkessel(const std::string &name) const
      {
        const std::string entry = section + "Windkessels";
        const auto parts =
            components(value_for(name, prm.windkessels, "Windkessels", "Windkessel"), 5, entry);
        std::array<double, 5> v;
        std::transform(parts.begin(), parts.end(), v.begin(),
                       [&](const std::string &part) { return number(part, constants, entry); });
        if (!(v[1] > 0.) || !(v[2] > 0.))
          throw InputError(entry, prm.windkessels,
                           "compliance and distal resistance must be greater than 0",
                           "give '(Rp, C, Rd, distal pressure, initial pressure)'");
        return std::make_shared<flow::Windkessel>(
            flow::Windkessel::Parameters{v[0], v[1], v[2], v[3], v[4]});
      }
    };
  } // namespace

  void FlowBoundaries::add_parameters(dealii::ParameterHandler &prm)
  {
    namespace Patterns = dealii::Patterns;
    prm.enter_subsection("Boundary conditions");
    prm.add_parameter(
        "Types", types,
        "What happens at each part of the boundary, 'NAME: TYPE; NAME: TYPE'. wall: no slip; slip: "
        "no flow through it; velocity, traction: as given below; exact: the exact solution's "
        "velocity; and open boundaries with a uniform pressure, stabilised against backflow: "
        "pressure: as given; resistance: p = P + R Q, Q being the flow rate out of the mesh; "
        "Windkessel: proximal resistance, compliance, distal resistance; flow rate: a pressure "
        "such "
        "that so much flows in.");
    prm.add_parameter("Velocities", velocities,
                      "'NAME: (u, v, w); ...', expressions in x, y, z, t [cm/s]");
    prm.add_parameter(
        "Tractions", tractions,
        "Stress times outward normal, 'NAME: (u, v, w); ...', expressions in x, y, z, "
        "t [dyn/cm^2]");
    prm.add_parameter("Pressures", pressures,
                      "'NAME: P; ...', expressions in t for type pressure, numbers for resistance; "
                      "80*mmHg is 80 mmHg [dyn/cm^2]");
    prm.add_parameter("Resistances", resistances, "'NAME: R; ...' [dyn s/cm^5]");
    prm.add_parameter(
        "Windkessels", windkessels,
        "'NAME: (proximal resistance, compliance, distal resistance, distal pressure, "
        "initial pressure of the compliance); ...' [dyn s/cm^5, cm^5/dyn, dyn/cm^2]");
    prm.add_parameter("Flow rates", flow_rates,
                      "Into the mesh, 'NAME: Q; ...', expressions in t "
                      "[cm^3/s]");
    prm.add_parameter("Flow rate inertance", flow_rate_inertance,
                      "How hard the pressure of type flow rate works against a deviation, which is "
                      "proportional to the square of the time step: about ten times rho L / A of "
                      "what the blood flows through [g/cm^4], > 0",
                      positive_number());
    prm.enter_subsection("Pressure table");
    pressure_table.add_parameters(prm, "pressure of boundaries of type pressure that are not among "
                                       "the Pressures [mmHg]");
    prm.leave_subsection();
    prm.enter_subsection("Flow rate table");
    flow_rate_table.add_parameters(
        prm,
        "flow rate of boundaries of type flow rate that are not among the Flow rates [cm^3/s]");
    prm.leave_subsection();
    prm.leave_subsection();
  }

  template <int dim>
  flow::BoundaryConditions<dim> FlowBoundaries::conditions(const mesh::Mesh<dim> &mesh,
                                                           const Constants &constants,
                                                           const VectorField<dim> &exact) const
  {
    flow::BoundaryConditions<dim> result;
    const Maker<dim> maker(*this, constants, exact);
    std::set<std::string> given;
    for (const auto &[name, kind] : named_parts(types, section + "Types"))
    {
      const auto id = mesh.boundary_id(name, section + "Types");
      if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end())
        throw InputError(section + "Types", kind, "there is no such type of boundary",
                         suggest(kind, kinds));
      maker.add(id, name, kind, result);
      given.insert(name);
    }
    for (const auto &[name, id] : mesh.boundary_ids)
      if (given.count(name) == 0)
        throw InputError(section + "Types", types, "boundary '" + name + "' has no type",
                         "add '" + name + ": wall' or another type");
    return result;
  }

  template <int dim>
  std::set<dealii::types::boundary_id> FlowBoundaries::walls(const mesh::Mesh<dim> &mesh) const
  {
    std::set<dealii::types::boundary_id> ids;
    const mesh::BoundaryIds of_lumen = mesh.lumen_boundary_ids();
    for (const auto &[name, kind] : named_parts(types, section + "Types"))
      if (kind == "wall" && of_lumen.count(name) > 0)
        ids.insert(of_lumen.at(name));
    return ids;
  }

  template flow::BoundaryConditions<2> FlowBoundaries::conditions(const mesh::Mesh<2> &,
                                                                  const Constants &,
                                                                  const VectorField<2> &) const;
  template flow::BoundaryConditions<3> FlowBoundaries::conditions(const mesh::Mesh<3> &,
                                                                  const Constants &,
                                                                  const VectorField<3> &) const;
  template std::set<dealii::types::boundary_id> FlowBoundaries::walls(const mesh::Mesh<2> &) const;
  template std::set<dealii::types::boundary_id> FlowBoundaries::walls(const mesh::Mesh<3> &) const;
} // namespace semilunar::scene
