// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_output_cross_section_h
#define semilunar_output_cross_section_h

#include <semilunar/output/flow_state.h>
#include <semilunar/output/linear_functional.h>

namespace semilunar::output
{
  /// The plane x_axis = position through a lumen: flow rate and mean pressure there (O3). Points of
  /// the plane are located once, and their contributions added up to a linear functional.
  template <int dim>
  class CrossSection
  {
  public:
    /// @param n_points Gauss points per cell and direction; exact where the plane cuts cells
    /// parallel to two faces (tubes, channels), otherwise the more the better
    CrossSection(unsigned int axis, double position, unsigned int n_points = 4)
        : axis(axis), position(position), n_points(n_points)
    {
    }

    /// Locate the plane: at first, and whenever the mesh has changed or moved. Collective.
    void reinit(const FlowState<dim> &state);

    struct Values
    {
      double area;      ///< [cm^2], in the plane [cm]
      double flow_rate; ///< along the axis [cm^3/s], in the plane [cm^2/s]
      double pressure;  ///< mean [dyn/cm^2]; NaN if the plane misses the lumen
    };
    /// Collective.
    Values evaluate(const FlowState<dim> &state) const;

  private:
    const unsigned int axis;
    const double position;
    const unsigned int n_points;
    double area = 0.; ///< of this rank
    LinearFunctional flow_rate, pressure;
  };
} // namespace semilunar::output

#endif
