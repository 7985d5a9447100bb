// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_flow_scaled_jacobian_h
#define semilunar_flow_scaled_jacobian_h

#include <semilunar/flow/spaces.h>

namespace semilunar::flow
{
  /// Smallest scaled Jacobian at the nodes of the cells of the lumen (doc/theory/mesh.md).
  /// Collective. @param positions of the nodes, readable
  template <int dim>
  double min_scaled_jacobian(const Spaces<dim> &spaces, const Vector &positions);
} // namespace semilunar::flow

#endif
