// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/mesh/tube_shape.h>

#include <deal.II/base/numbers.h>

#include <Sacado.hpp>

#include <cmath>

namespace semilunar::mesh
{
  namespace
  {
    constexpr double pi = dealii::numbers::PI;

    using Dual = Sacado::Fad::SFad<double, 3>;

    double value(const double x)
    {
      return x;
    }
    double value(const Dual &x)
    {
      return x.val();
    }
  } // namespace

  TubeShape::TubeShape(const TubeParameters &parameters)
      : tube(parameters), axis(tube.begin, tube.end, tube.zone_begin, tube.zone_end,
                               tube.zone_transition, tube.zone_ratio)
  {
  }

  template <typename Number>
  Number TubeShape::bulge(const Number &z) const
  {
    using std::cos;
    const auto &s = tube.sinus;
    if (!s.exists || value(z) <= s.begin || value(z) >= s.end)
      return 0.;
    const double length = value(z) < s.peak ? s.peak - s.begin : s.end - s.peak;
    return 0.5 * (1. + cos(pi * (z - s.peak) / length));
  }

  template <typename Number>
  Number TubeShape::bulge_slope(const Number &z) const
  {
    using std::sin;
    const auto &s = tube.sinus;
    if (!s.exists || value(z) <= s.begin || value(z) >= s.end)
      return 0.;
    const double length = value(z) < s.peak ? s.peak - s.begin : s.end - s.peak;
    return -0.5 * pi / length * sin(pi * (z - s.peak) / length);
  }

  template <typename Number>
  Number TubeShape::lumen_radius(const Number &theta, const Number &z) const
  {
    using std::cos;
    const double mean = 0.5 * (tube.sinus.lobe_radius + tube.sinus.commissure_radius) - tube.radius;
    const double amplitude = 0.5 * (tube.sinus.lobe_radius - tube.sinus.commissure_radius);
    return tube.radius + bulge(z) * (mean + amplitude * cos(3. * theta));
  }

  template <typename Number>
  Number TubeShape::wall_thickness(const Number &theta, const Number &z) const
  {
    using std::cos;
    using std::sin;
    using std::sqrt;
    const double mean = 0.5 * (tube.sinus.lobe_radius + tube.sinus.commissure_radius) - tube.radius;
    const double amplitude = 0.5 * (tube.sinus.lobe_radius - tube.sinus.commissure_radius);
    const Number along = bulge_slope(z) * (mean + amplitude * cos(3. * theta));
    const Number around = -3. * amplitude * bulge(z) * sin(3. * theta) / lumen_radius(theta, z);
    return tube.wall_thickness * sqrt(1. + along * along + around * around);
  }

  template <typename Number>
  Number TubeShape::hexagon_radius(const Number &theta) const
  {
    using std::cos;
    const double sector = std::floor(value(theta) / (pi / 3.));
    return tube.core_radius * std::cos(pi / 6.) / cos(theta - (sector + 0.5) * pi / 3.);
  }

  template <typename Number>
  Number TubeShape::shell_radius(const Number &tau, const Number &theta, const Number &z) const
  {
    using std::pow;
    const Number wall = lumen_radius(theta, z);
    if (value(tau) > 1.)
      return wall + (tau - 1.) * wall_thickness(theta, z);
    const double g = tube.wall_clustering;
    Number t = tau;
    if (g != 1.)
      t = (1. - pow(g, -tau)) / (1. - 1. / g);
    const Number rho = (1. - t) * hexagon_radius(theta) + t;
    return rho * (tube.radius + rho * (wall - tube.radius));
  }

  template <typename Number>
  void TubeShape::evaluate(const Chart chart, const Number *coordinates, const Number z,
                           Number *position) const
  {
    using std::atan2;
    using std::cos;
    using std::sin;
    using std::sqrt;
    if (chart == Chart::shell)
    {
      const Number r = shell_radius(coordinates[0], coordinates[1], z);
      position[0] = r * cos(coordinates[1]);
      position[1] = r * sin(coordinates[1]);
    }
    else
    {
      const Number &x = coordinates[0], &y = coordinates[1];
      Number factor = tube.radius;
      if (value(x) != 0. || value(y) != 0.)
      {
        const Number theta = atan2(y, x);
        factor += sqrt(x * x + y * y) * (lumen_radius(theta, z) - tube.radius);
      }
      position[0] = factor * x;
      position[1] = factor * y;
    }
    position[2] = z;
  }

  double TubeShape::radius(const double theta, const double z) const
  {
    return lumen_radius(theta, z);
  }

  double TubeShape::hexagon(const double theta) const
  {
    return hexagon_radius(theta);
  }

  TubeShape::Point TubeShape::position(const Chart chart, const Point &coordinates) const
  {
    const double at[3] = {coordinates[0], coordinates[1], coordinates[2]};
    Point position;
    evaluate(chart, at, axis.position(coordinates[2]), &position[0]);
    return position;
  }

  TubeShape::Point TubeShape::coordinates(const Chart chart, const Point &position) const
  {
    const double z = position[2], r = std::hypot(position[0], position[1]);
    double theta = std::atan2(position[1], position[0]);
    if (theta < 0.)
      theta += 2. * pi;
    const double wall = lumen_radius(theta, z), delta = wall - tube.radius;
    const double rho =
        2. * r / (tube.radius + std::sqrt(tube.radius * tube.radius + 4. * r * delta));
    const double zeta = axis.coordinate(z);
    if (chart == Chart::core)
      return r > 0. ? Point(rho * position[0] / r, rho * position[1] / r, zeta)
                    : Point(0., 0., zeta);
    if (r > wall && tube.wall_thickness > 0.)
      return Point(1. + (r - wall) / wall_thickness(theta, z), theta, zeta);
    const double inner = hexagon_radius(theta), t = (rho - inner) / (1. - inner);
    const double g = tube.wall_clustering;
    const double tau = g == 1. ? t : -std::log1p(-t * (1. - 1. / g)) / std::log(g);
    return Point(tau, theta, zeta);
  }

  dealii::DerivativeForm<1, 3, 3> TubeShape::gradient(const Chart chart,
                                                      const Point &coordinates) const
  {
    Dual at[3], result[3];
    for (unsigned int d = 0; d < 3; ++d)
      at[d] = Dual(3, d, coordinates[d]);
    const double z = axis.position(coordinates[2]);
    Dual height(z);
    height.fastAccessDx(2) = axis.stretch(z);
    evaluate(chart, at, height, result);
    dealii::DerivativeForm<1, 3, 3> gradient;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        gradient[i][j] = result[i].dx(j);
    return gradient;
  }
} // namespace semilunar::mesh
