// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/valve/deployment.h>
#include <semilunar/valve/turn.h>

#include <deal.II/base/numbers.h>

#include <cmath>

namespace semilunar::valve
{
  namespace
  {
    /// Circumference of an ellipse by its longer semi-axis, (V9).
    double relative_circumference(const double ellipticity)
    {
      const double k = 1. - ellipticity * ellipticity;
      return 4. * std::comp_ellint_2(std::sqrt(k));
    }

    /// Stretch by the factors along the direction and across it.
    template <typename Vector>
    void stretch(Vector &x, const double direction, const double along, const double across)
    {
      const double c = std::cos(direction), s = std::sin(direction);
      const double u = along * (c * x[0] + s * x[1]), v = across * (c * x[1] - s * x[0]);
      x[0] = c * u - s * v;
      x[1] = s * u + c * v;
    }

    bool is_circle(const Design &design)
    {
      return design.expansion == 1. && design.ellipticity == 1.;
    }
  } // namespace

  CrossSection cross_section(const Design &design)
  {
    constexpr double pi = dealii::numbers::PI;
    const double direction = design.ellipse_direction * pi / 180.;
    if (design.ellipticity == 1.)
      return {design.expansion, design.expansion, direction};
    const double longer = design.expansion * 2. * pi / relative_circumference(design.ellipticity);
    return {longer, design.ellipticity * longer, direction};
  }

  void deploy(std::vector<spline::ControlPoint> &points, const Design &design)
  {
    if (is_circle(design))
      return; // to the last bit
    const CrossSection section = cross_section(design);
    for (spline::ControlPoint &point : points)
      stretch(point.position, section.direction, section.longer, section.shorter);
  }

  spline::NurbsPatch in_place(const spline::NurbsPatch &patch, const unsigned int k,
                              const Design &design)
  {
    std::vector<spline::ControlPoint> net = patch.control_net();
    turn(net, k, design.n_leaflets);
    deploy(net, design);
    return spline::NurbsPatch({{patch.knots(0), patch.knots(1)}}, net);
  }

  std::vector<spline::Tensor<1, 3>> undeployed(std::vector<spline::Tensor<1, 3>> positions,
                                               const Design &design)
  {
    if (is_circle(design))
      return positions;
    const CrossSection section = cross_section(design);
    for (spline::Tensor<1, 3> &x : positions)
      stretch(x, section.direction, 1. / section.longer, 1. / section.shorter);
    return positions;
  }
} // namespace semilunar::valve
