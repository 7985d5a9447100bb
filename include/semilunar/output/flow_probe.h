// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_output_flow_probe_h
#define semilunar_output_flow_probe_h

#include <semilunar/output/flow_state.h>
#include <semilunar/output/linear_functional.h>

#include <array>

namespace semilunar::output
{
  /// A point fixed in space: velocity and pressure there.
  template <int dim>
  class FlowProbe
  {
  public:
    explicit FlowProbe(const dealii::Point<dim> &position) : position(position) {}

    /// Locate the point: at first, and whenever the mesh has changed or moved. Collective.
    /// @return whether it lies in the mesh, or within a thousandth of a cell outside of it
    bool reinit(const FlowState<dim> &state);

    struct Values
    {
      dealii::Tensor<1, dim> velocity; ///< [cm/s]
      double pressure;                 ///< [dyn/cm^2]
    };
    /// Collective. NaN if the point does not lie in the mesh.
    Values evaluate(const FlowState<dim> &state) const;

  private:
    const dealii::Point<dim> position;
    bool found = false;
    std::array<LinearFunctional, dim> velocity; ///< empty on all ranks but one
    LinearFunctional pressure;
  };
} // namespace semilunar::output

#endif
