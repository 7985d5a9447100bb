// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_output_wall_shear_stress_h
#define semilunar_output_wall_shear_stress_h

#include <semilunar/output/flow_state.h>

#include <set>

namespace semilunar::output
{
  /// Tangential traction of the fluid on a wall (O6): the tangential part of -2 mu eps(u) n.
  /// @param gradient [i][j] = du_i/dx_j @param normal outward from the fluid
  template <int dim>
  dealii::Tensor<1, dim> wall_shear_stress(const dealii::Tensor<2, dim> &gradient,
                                           const dealii::Tensor<1, dim> &normal, double viscosity);

  struct WallShearStress
  {
    double min, max, mean; ///< of the magnitude [dyn/cm^2]
  };

  /// Over all walls: smallest and largest value at the corners, edges and centres of faces, mean by
  /// area. Collective; NaN if there are no walls.
  template <int dim>
  WallShearStress wall_shear_stress(const FlowState<dim> &state,
                                    const std::set<dealii::types::boundary_id> &walls);
} // namespace semilunar::output

#endif
