// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_mesh_tube_shape_h
#define semilunar_mesh_tube_shape_h

#include <semilunar/mesh/graded_axis.h>
#include <semilunar/mesh/tube_parameters.h>

#include <deal.II/base/derivative_form.h>
#include <deal.II/base/point.h>

namespace semilunar::mesh
{
  /// The shape of a tube as a map from grid coordinates to space and back, in closed form.
  class TubeShape
  {
  public:
    using Point = dealii::Point<3>;
    enum class Chart
    {
      core, ///< x^, y^ of the unit disc, zeta: for the hexagon around the axis
      shell ///< tau, theta, zeta: for the layers around it, (H5) and (H6)
    };

    explicit TubeShape(const TubeParameters &parameters);

    /// Inner radius (H2).
    double radius(double theta, double z) const;
    /// The hexagon's boundary rho_c(theta) in the unit disc.
    double hexagon(double theta) const;

    Point position(Chart chart, const Point &coordinates) const;
    Point coordinates(Chart chart, const Point &position) const;
    /// Derivatives of the position with respect to the coordinates.
    dealii::DerivativeForm<1, 3, 3> gradient(Chart chart, const Point &coordinates) const;

  private:
    const TubeParameters tube;
    const GradedAxis axis;

    /// Radius r of the point at (tau, theta) of a cross-section.
    template <typename Number>
    Number shell_radius(const Number &tau, const Number &theta, const Number &z) const;
    template <typename Number>
    Number lumen_radius(const Number &theta, const Number &z) const;
    template <typename Number>
    Number wall_thickness(const Number &theta, const Number &z) const;
    /// The share a(z) of the sinus in (H2) and its derivative.
    template <typename Number>
    Number bulge(const Number &z) const;
    template <typename Number>
    Number bulge_slope(const Number &z) const;
    template <typename Number>
    Number hexagon_radius(const Number &theta) const;
    template <typename Number>
    void evaluate(Chart chart, const Number *coordinates, Number z, Number *position) const;
  };
} // namespace semilunar::mesh

#endif
