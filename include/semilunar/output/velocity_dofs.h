// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_output_velocity_dofs_h
#define semilunar_output_velocity_dofs_h

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>

namespace semilunar::output
{
  /// The vector-valued space of a velocity whose entries are interleaved, component c of node i of
  /// a scalar space being entry dim i + c: what deal.II's tools ask for, numbered in this way so
  /// that the velocity itself can be given to them.
  template <int dim>
  class VelocityDofs
  {
  public:
    /// @param scalar dofs of one component; to be built anew when these change. Collective.
    explicit VelocityDofs(const dealii::DoFHandler<dim> &scalar);

    const dealii::DoFHandler<dim> &handler() const { return dofs; }

  private:
    const dealii::FESystem<dim> element;
    dealii::DoFHandler<dim> dofs;
  };
} // namespace semilunar::output

#endif
