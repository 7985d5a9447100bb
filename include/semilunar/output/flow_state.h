// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_output_flow_state_h
#define semilunar_output_flow_state_h

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/lac/la_parallel_vector.h>

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
    unsigned int degree() const { return velocity_dofs.get_fe().degree; }
    MPI_Comm communicator() const { return velocity_dofs.get_communicator(); }
  };
} // namespace semilunar::output

#endif
