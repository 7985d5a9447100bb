// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_flow_flow_vector_h
#define semilunar_flow_flow_vector_h

#include <semilunar/flow/spaces.h>

namespace semilunar::flow
{
  /// Velocity and pressure, or what is dual to them.
  struct FlowVector
  {
    Vector velocity, pressure;

    template <int dim>
    void reinit(const Spaces<dim> &spaces)
    {
      velocity.reinit(spaces.velocities());
      pressure.reinit(spaces.pressures());
    }
  };
} // namespace semilunar::flow

#endif
