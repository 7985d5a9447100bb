// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_scene_flow_boundaries_h
#define semilunar_scene_flow_boundaries_h

#include <semilunar/core/time_table.h>
#include <semilunar/flow/boundary_conditions.h>
#include <semilunar/mesh/mesh.h>
#include <semilunar/scene/expression.h>

#include <set>

namespace semilunar::scene
{
  /// What happens at the parts of the boundary, by name: the section Boundary conditions.
  struct FlowBoundaries
  {
    std::string types;
    std::string velocities, tractions, pressures, resistances, windkessels, flow_rates;
    double flow_rate_inertance = 30.; ///< [g/cm^4]
    TimeTableParameters pressure_table, flow_rate_table;

    void add_parameters(dealii::ParameterHandler &prm);

    /// @param exact velocity for boundaries of type exact, empty if there is none
    /// @throws InputError for what does not fit together or the mesh
    template <int dim>
    flow::BoundaryConditions<dim> conditions(const mesh::Mesh<dim> &mesh,
                                             const Constants &constants,
                                             const VectorField<dim> &exact) const;

    /// The boundaries of the lumen of type wall.
    template <int dim>
    std::set<dealii::types::boundary_id> walls(const mesh::Mesh<dim> &mesh) const;
  };
} // namespace semilunar::scene

#endif
