// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/spline/primitives.h>
#include <semilunar/valve/boundary_curves.h>

#include <algorithm>
#include <cmath>

namespace semilunar::valve
{
  using spline::ControlPoint;
  using spline::KnotVector;
  using spline::Point;

  namespace
  {
    constexpr unsigned int degree = 3;

    /// The knots between the symmetry plane (0) and the commissure (1). Two short elements at the
    /// middle bend the free edge round the tip of its V.
    constexpr std::array<double, n_base_elements / 2 + 1> half_breakpoints{
        {0., 0.1, 0.2, 0.55, 1.}};

    std::vector<double> inner_knots()
    {
      std::vector<double> knots{0.5};
      for (unsigned int k = 1; k + 1 < half_breakpoints.size(); ++k)
      {
        knots.push_back(0.5 * (1. - half_breakpoints[k]));
        knots.push_back(0.5 * (1. + half_breakpoints[k]));
      }
      std::sort(knots.begin(), knots.end());
      return knots;
    }

    /// Make the half at positive y the mirror image of the other one to the last bit.
    void mirror(std::vector<ControlPoint> &curve)
    {
      const unsigned int middle = curve.size() / 2;
      curve[middle].position[1] = 0.;
      for (unsigned int i = 0; i < middle; ++i)
      {
        curve[curve.size() - 1 - i] = curve[i];
        curve[curve.size() - 1 - i].position[1] *= -1.;
      }
    }

    /// The scallop (V2): the arc r = R, cut by a plane, which makes z linear in x.
    BoundaryCurves with_scallop(const Design &design)
    {
      const double R = design.radius, angle = design.half_angle();
      spline::NurbsPatch strip = spline::cylinder(R, -angle, angle, 0., 1.);
      strip.elevate_degree(0, degree - strip.knots(0).degree());
      strip.insert_knots(0, inner_knots());

      const double x_foot = R * std::cos(angle);
      BoundaryCurves curves{strip.knots(0), {}, {}};
      for (unsigned int i = 0; i < strip.n_control_points(0); ++i)
      {
        ControlPoint point = strip.control_point(i, 0);
        const double share = (R - point.position[0]) / (R - x_foot);
        point.position[2] =
            design.nadir_height + share * (design.post_foot_height - design.nadir_height);
        curves.scallop.push_back(point);
      }
      curves.scallop.front().position =
          Point<3>(x_foot, -R * std::sin(angle), design.post_foot_height);
      mirror(curves.scallop);
      return curves;
    }

    /// The rational function of the middle control point in the symmetry plane. Only its two
    /// neighbors are non-zero there as well.
    double middle_function(const BoundaryCurves &curves)
    {
      const std::vector<double> N = curves.knots.evaluate(0.5);
      const unsigned int first = curves.knots.span(0.5) - degree,
                         middle = curves.scallop.size() / 2;
      double sum = 0.;
      for (unsigned int k = 0; k < N.size(); ++k)
        sum += N[k] * curves.scallop[first + k].weight;
      return N[middle - first] * curves.scallop[middle].weight / sum;
    }

    /// The rounding of the tip (V5).
    struct TipRounding
    {
      double neighbor_share; ///< lambda of the control points next to the middle
      double rho;            ///< of the hyperbola
      double pull;           ///< H, by which the edge stays off the corner of the V
    };

    /// As round as the published valve or, if the gap leaves less room, as the planes allow that
    /// keep the edge away from its neighbors: first the hyperbola gets sharper, then the control
    /// points next to the tip come closer.
    TipRounding tip_rounding(const BoundaryCurves &curves, const Design &design,
                             const double x_commissure)
    {
      constexpr double published_pull = 0.08;
      const double room = design.free_edge_gap - design.smallest_gap();
      const double depth = x_commissure - design.smallest_gap();
      const double H = depth * published_pull > room ? room / depth : published_pull;

      const double a = middle_function(curves), b = 1. - a;
      const double even = distance_from_middle(curves.knots, curves.scallop.size() / 2 + 1);
      if (H < b * even)
        return {H / b, 0., H};
      // the root of a rho + b h(even) = H
      const double A = b * b * (1. - even * even) - a * a, C = b * b * even * even - H * H;
      return {even, -C / (a * H + std::sqrt(a * a * H * H - A * C)), H};
    }

    void add_free_edge(BoundaryCurves &curves, const Design &design)
    {
      const unsigned int n = curves.scallop.size();
      const double R = design.commissure_radius(), angle = design.half_commissure_angle();
      const Point<3> commissure(R * std::cos(angle), -R * std::sin(angle),
                                design.commissure_height);
      const Point<3> between(commissure[0], 0., commissure[2]);
      const Point<3> tip(design.free_edge_gap, 0., design.free_edge_height);

      const TipRounding rounding = tip_rounding(curves, design, commissure[0]);
      const Point<3> corner = tip + rounding.pull / (1. - rounding.pull) * (tip - between);
      const double even = distance_from_middle(curves.knots, n / 2 + 1);
      for (unsigned int i = 0; i < n; ++i)
      {
        const double s = distance_from_middle(curves.knots, i);
        const double along =
            i == n / 2 ? 0. : 1. - (1. - rounding.neighbor_share) * (1. - s) / (1. - even);
        const double up =
            std::sqrt(along * along + rounding.rho * rounding.rho * (1. - along * along));
        Point<3> point = corner + up * (between - corner);
        point[1] = along * commissure[1];
        curves.free_edge.push_back({point, curves.scallop[i].weight});
      }
      curves.free_edge.front().position = commissure;
      mirror(curves.free_edge);
    }
  } // namespace

  double distance_from_middle(const KnotVector &knots, const unsigned int function)
  {
    return std::abs(2. * knots.greville_abscissae()[function] - 1.);
  }

  BoundaryCurves boundary_curves(const Design &design)
  {
    BoundaryCurves curves = with_scallop(design);
    add_free_edge(curves, design);
    return curves;
  }
} // namespace semilunar::valve
