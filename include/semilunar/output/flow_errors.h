// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_output_flow_errors_h
#define semilunar_output_flow_errors_h

#include <semilunar/output/flow_state.h>

#include <functional>

namespace semilunar::output
{
  /// Distance of a flow from an exact one.
  struct FlowErrors
  {
    double velocity_l2 = 0., velocity_h1 = 0.; ///< norm, seminorm
    double pressure_l2 = 0.;
    double velocity_max = 0.; ///< over the points of integration
  };

  /// @param velocity, pressure exact ones at the state's time
  /// @param level_is_free whether the pressure's level means nothing: differences have mean 0
  /// Collective.
  template <int dim>
  FlowErrors
  flow_errors(const FlowState<dim> &state,
              const std::function<dealii::Tensor<1, dim>(const dealii::Point<dim> &)> &velocity,
              const std::function<double(const dealii::Point<dim> &)> &pressure,
              bool level_is_free);
} // namespace semilunar::output

#endif
