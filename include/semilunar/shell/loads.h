// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_shell_loads_h
#define semilunar_shell_loads_h

#include <semilunar/shell/location.h>
#include <semilunar/shell/quadrature_points.h>

#include <deal.II/base/parameter_handler.h>

namespace semilunar::shell
{
  /// The loads at load factor one, in the words of a scene file. Units are those of the scene.
  struct LoadParameters
  {
    double pressure = 0.;
    double pressure_mmhg = 0.;
    std::string area_load = "0, 0, 0";
    std::string acceleration = "0, 0, 0";
    std::string point_loads, edge_loads, edge_moments;

    void add_parameters(dealii::ParameterHandler &prm);
    /// Pressure in the scene's units. @throws InputError if given twice
    double follower_pressure() const;
    /// The dead load on the undeformed area: area load and acceleration [force/area].
    spline::Tensor<1, 3> dead_area_load(double mass_per_area) const;
  };

  /// Forces on the control points that do not depend on the deformation: area load, acceleration
  /// (times density and thickness), point and edge loads; each has units of force.
  /// @throws InputError for loads that name no place of the surface
  std::vector<spline::Tensor<1, 3>> dead_forces(const spline::Surface &surface,
                                                const QuadraturePoints &points,
                                                const LoadParameters &parameters,
                                                double mass_per_area);
} // namespace semilunar::shell

#endif
