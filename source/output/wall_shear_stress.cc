// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/output/wall_shear_stress.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <limits>

namespace semilunar::output
{
  template <int dim>
  dealii::Tensor<1, dim> wall_shear_stress(const dealii::Tensor<2, dim> &gradient,
                                           const dealii::Tensor<1, dim> &normal,
                                           const double viscosity)
  {
    const dealii::Tensor<1, dim> traction =
        -viscosity * (gradient * normal + dealii::transpose(gradient) * normal);
    return traction - (traction * normal) * normal;
  }

  template <int dim>
  WallShearStress wall_shear_stress(const FlowState<dim> &state,
                                    const std::set<dealii::types::boundary_id> &walls)
  {
    const dealii::QGaussLobatto<dim - 1> points(3);
    dealii::FEFaceValues<dim> values(state.mapping, state.velocity_dofs.get_fe(), points,
                                     dealii::update_gradients | dealii::update_normal_vectors |
                                         dealii::update_JxW_values);
    const dealii::FEValuesExtractors::Vector velocity(0);
    std::vector<dealii::Tensor<2, dim>> gradients(points.size());
    WallShearStress stress{std::numeric_limits<double>::infinity(), 0., 0.};
    double area = 0.;
    for (const auto &cell : state.velocity_dofs.active_cell_iterators())
      if (cell->is_locally_owned())
        for (const unsigned int f : cell->face_indices())
          if (is_at_wall(cell, f, walls))
          {
            values.reinit(cell, f);
            values[velocity].get_function_gradients(state.velocity, gradients);
            for (unsigned int q = 0; q < points.size(); ++q)
            {
              const double magnitude =
                  wall_shear_stress(gradients[q], values.normal_vector(q), state.viscosity).norm();
              stress.min = std::min(stress.min, magnitude);
              stress.max = std::max(stress.max, magnitude);
              stress.mean += values.JxW(q) * magnitude;
              area += values.JxW(q);
            }
          }
    namespace MPI = dealii::Utilities::MPI;
    const MPI_Comm communicator = state.communicator();
    area = MPI::sum(area, communicator);
    if (area == 0.)
      return {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
              std::numeric_limits<double>::quiet_NaN()};
    return {MPI::min(stress.min, communicator), MPI::max(stress.max, communicator),
            MPI::sum(stress.mean, communicator) / area};
  }

  template dealii::Tensor<1, 2> wall_shear_stress(const dealii::Tensor<2, 2> &,
                                                  const dealii::Tensor<1, 2> &, double);
  template dealii::Tensor<1, 3> wall_shear_stress(const dealii::Tensor<2, 3> &,
                                                  const dealii::Tensor<1, 3> &, double);
  template WallShearStress wall_shear_stress(const FlowState<2> &,
                                             const std::set<dealii::types::boundary_id> &);
  template WallShearStress wall_shear_stress(const FlowState<3> &,
                                             const std::set<dealii::types::boundary_id> &);
} // namespace semilunar::output
