// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_output_flow_state_h
#define semilunar_output_flow_state_h

#include <semilunar/mesh/mesh.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <set>

namespace semilunar::output
{
  using FlowVector = dealii::LinearAlgebra::distributed::Vector<double>;

  /// A state of a flow as the output sees it; refers to what the solver owns.
  template <int dim>
  struct FlowState
  {
    const dealii::Mapping<dim> &mapping;
    const dealii::DoFHandler<dim> &velocity_dofs; ///< VelocityDofs::handler()
    const dealii::DoFHandler<dim> &pressure_dofs;
    const FlowVector &velocity, &pressure; ///< with ghosts [cm/s], [dyn/cm^2]
    double density, viscosity;             ///< [g/cm^3], [g/(cm s)]
    double time, dt;                       ///< [s]

    const dealii::Triangulation<dim> &triangulation() const
    {
      return velocity_dofs.get_triangulation();
    }
    /// Whether there are cells of an elastic wall: coarse ones, which all ranks know.
    bool has_wall() const
    {
      for (const auto &cell : triangulation().cell_iterators_on_level(0))
        if (cell->material_id() == mesh::wall)
          return true;
      return false;
    }
    unsigned int degree() const { return velocity_dofs.get_fe().degree; }
    MPI_Comm communicator() const { return velocity_dofs.get_communicator(); }
  };

  /// Whether a cell has blood in it and belongs to this rank.
  template <class Cell>
  bool is_owned_lumen(const Cell &cell)
  {
    return cell->is_locally_owned() && cell->material_id() == mesh::lumen;
  }

  /// Whether a face is one of a cell of the lumen between blood and a wall: on a boundary that is
  /// one, or next to a cell of an elastic wall.
  template <class Cell>
  bool is_at_wall(const Cell &cell, const unsigned int face,
                  const std::set<dealii::types::boundary_id> &walls)
  {
    if (cell->material_id() != mesh::lumen)
      return false;
    if (cell->at_boundary(face))
      return walls.count(cell->face(face)->boundary_id()) > 0;
    return cell->neighbor(face)->material_id() == mesh::wall;
  }
} // namespace semilunar::output

#endif
