// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/flow/nodal_values.h>

#include <deal.II/fe/fe_values.h>

namespace semilunar::flow
{
  using dealii::Point;

  namespace
  {
    /// Calls visit(global dof, its place) for all owned dofs.
    template <int dim, class Visit>
    void for_owned_nodes(const dealii::DoFHandler<dim> &handler,
                         const dealii::Mapping<dim> &mapping, const Visit &visit)
    {
      const auto &element = handler.get_fe();
      dealii::FEValues<dim> values(mapping, element,
                                   dealii::Quadrature<dim>(element.get_unit_support_points()),
                                   dealii::update_quadrature_points);
      const dealii::IndexSet &owned = handler.locally_owned_dofs();
      std::vector<dealii::types::global_dof_index> dofs(element.dofs_per_cell);
      for (const auto &cell : handler.active_cell_iterators())
        if (!cell->is_artificial())
        {
          values.reinit(cell);
          cell->get_dof_indices(dofs);
          for (unsigned int i = 0; i < dofs.size(); ++i)
            if (owned.is_element(dofs[i]))
              visit(dofs[i], values.quadrature_point(i));
        }
    }
  } // namespace

  template <int dim>
  Vector nodal_velocities(const Spaces<dim> &spaces, const VectorFunction<dim> &function,
                          const Vector &positions, const double time)
  {
    Vector result(spaces.velocities());
    for (unsigned int node = 0; node < spaces.nodes()->locally_owned_size(); ++node)
    {
      Point<dim> x;
      for (unsigned int c = 0; c < dim; ++c)
        x[c] = positions.local_element(dim * node + c);
      const dealii::Tensor<1, dim> value = function(x, time);
      for (unsigned int c = 0; c < dim; ++c)
        result.local_element(dim * node + c) = value[c];
    }
    spaces.make_readable_velocity(result);
    return result;
  }

  template <int dim>
  Vector nodal_pressures(const Spaces<dim> &spaces, const dealii::Mapping<dim> &mapping,
                         const std::function<double(const Point<dim> &, double)> &function,
                         const double time)
  {
    Vector result(spaces.pressures());
    for_owned_nodes(spaces.pressure_dofs(), mapping,
                    [&](const auto dof, const Point<dim> &x) { result(dof) = function(x, time); });
    spaces.make_readable_pressure(result);
    return result;
  }

  template <int dim>
  Vector nodal_positions(const Spaces<dim> &spaces, const dealii::Mapping<dim> &mapping)
  {
    Vector result(spaces.velocities());
    for_owned_nodes(spaces.velocity_dofs(), mapping,
                    [&](const auto dof, const Point<dim> &x)
                    {
                      const unsigned int node = spaces.nodes()->global_to_local(dof);
                      for (unsigned int c = 0; c < dim; ++c)
                        result.local_element(dim * node + c) = x[c];
                    });
    spaces.make_readable_velocity(result);
    return result;
  }

  template Vector nodal_velocities(const Spaces<2> &, const VectorFunction<2> &, const Vector &,
                                   double);
  template Vector nodal_velocities(const Spaces<3> &, const VectorFunction<3> &, const Vector &,
                                   double);
  template Vector nodal_pressures(const Spaces<2> &, const dealii::Mapping<2> &,
                                  const std::function<double(const Point<2> &, double)> &, double);
  template Vector nodal_pressures(const Spaces<3> &, const dealii::Mapping<3> &,
                                  const std::function<double(const Point<3> &, double)> &, double);
  template Vector nodal_positions(const Spaces<2> &, const dealii::Mapping<2> &);
  template Vector nodal_positions(const Spaces<3> &, const dealii::Mapping<3> &);
} // namespace semilunar::flow
