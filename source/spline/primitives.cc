// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/spline/primitives.h>

#include <deal.II/base/numbers.h>

#include <cmath>

namespace semilunar::spline
{
  using dealii::numbers::PI;

  namespace
  {
    /// Slack for angles that were computed, like 2 pi / 3.
    constexpr double angle_slack = 1e-12;

    /// A circular arc of radius 1 in a plane, in homogeneous coordinates (w x, w y, w).
    struct Arc
    {
      KnotVector knots;
      std::vector<Tensor<1, 3>> points;
    };

    /// The quadratic arc of one element, (S12). Above 120 degrees its middle weight gets small
    /// (zero at the half circle): there the same arc is written as a cubic, whose weights stay
    /// above 1/3.
    std::vector<Tensor<1, 3>> arc_element(const double begin, const double end, const bool cubic)
    {
      const auto at = [](const double angle, const double weight)
      {
        Tensor<1, 3> point;
        point[0] = std::cos(angle);
        point[1] = std::sin(angle);
        point[2] = weight;
        return point;
      };
      const Tensor<1, 3> first = at(begin, 1.), last = at(end, 1.);
      const Tensor<1, 3> middle = at((begin + end) / 2., std::cos((end - begin) / 2.));
      if (!cubic)
        return {first, middle, last};
      return {first, (first + 2. * middle) / 3., (2. * middle + last) / 3., last};
    }

    Arc arc(const double begin, const double end, const std::string &shape)
    {
      const double angle = std::abs(end - begin);
      if (!(angle > angle_slack && angle < 2. * PI + angle_slack))
        throw InputError(shape, std::to_string(end - begin), "the angle between the ends is wrong",
                         "it must be non-zero and at most a full circle (in radians)");
      const unsigned int n_elements = angle > PI + angle_slack ? 2 : 1;
      const bool cubic = angle / n_elements > 2. / 3. * PI + angle_slack;
      const unsigned int degree = cubic ? 3 : 2;
      std::vector<double> knots(degree + 1, 0.);
      Arc result{KnotVector::uniform(degree, 1), {}};
      for (unsigned int e = 0; e < n_elements; ++e)
      {
        const double a = begin + (end - begin) * e / n_elements;
        const double b = begin + (end - begin) * (e + 1) / n_elements;
        const auto points = arc_element(a, b, cubic);
        result.points.insert(result.points.end(), points.begin() + (e == 0 ? 0 : 1), points.end());
        knots.insert(knots.end(), degree, (e + 1.) / n_elements);
      }
      knots.push_back(1.);
      result.knots = KnotVector(degree, knots);
      return result;
    }

    void check_radius(const double radius, const std::string &shape)
    {
      if (!(radius > 0.) || !std::isfinite(radius))
        throw InputError(shape, std::to_string(radius), "the radius is not positive", "");
    }

    /// A straight segment as a spline of degree 1.
    KnotVector segment()
    {
      return KnotVector::uniform(1, 1);
    }

    /// A point of the arc, scaled to a radius, at a height.
    ControlPoint on_circle(const Tensor<1, 3> &arc_point, const double radius, const double z)
    {
      const double w = arc_point[2];
      return {Point<3>(radius * arc_point[0] / w, radius * arc_point[1] / w, z), w};
    }
  } // namespace

  NurbsPatch quadrilateral(const std::array<Point<3>, 4> &corners)
  {
    std::vector<ControlPoint> net;
    for (const Point<3> &corner : corners)
      net.push_back({corner, 1.});
    return NurbsPatch({{segment(), segment()}}, net);
  }

  NurbsPatch cylinder(const double radius, const double angle_begin, const double angle_end,
                      const double z_begin, const double z_end)
  {
    check_radius(radius, "cylinder");
    const Arc circle = arc(angle_begin, angle_end, "cylinder");
    std::vector<ControlPoint> net;
    for (const double z : {z_begin, z_end})
      for (const Tensor<1, 3> &point : circle.points)
        net.push_back(on_circle(point, radius, z));
    return NurbsPatch({{circle.knots, segment()}}, net);
  }

  NurbsPatch sphere(const double radius, const double longitude_begin, const double longitude_end,
                    const double latitude_begin, const double latitude_end)
  {
    check_radius(radius, "sphere");
    if (std::max(std::abs(latitude_begin), std::abs(latitude_end)) > PI / 2. + angle_slack)
      throw InputError("sphere", std::to_string(latitude_end), "the latitude is out of range",
                       "between -pi/2 and pi/2");
    const Arc parallel = arc(longitude_begin, longitude_end, "sphere");
    const Arc meridian = arc(latitude_begin, latitude_end, "sphere");
    std::vector<ControlPoint> net;
    for (const Tensor<1, 3> &profile : meridian.points) // revolved: weights multiply
      for (const Tensor<1, 3> &point : parallel.points)
      {
        ControlPoint control =
            on_circle(point, radius * profile[0] / profile[2], radius * profile[1] / profile[2]);
        control.weight *= profile[2];
        net.push_back(control);
      }
    return NurbsPatch({{parallel.knots, meridian.knots}}, net);
  }

  NurbsPatch annulus(const double inner_radius, const double outer_radius, const double angle_begin,
                     const double angle_end)
  {
    check_radius(inner_radius, "annulus");
    check_radius(outer_radius, "annulus");
    const Arc circle = arc(angle_begin, angle_end, "annulus");
    std::vector<ControlPoint> net;
    for (const Tensor<1, 3> &point : circle.points)
      for (const double radius : {inner_radius, outer_radius})
        net.push_back(on_circle(point, radius, 0.));
    return NurbsPatch({{segment(), circle.knots}}, net);
  }
} // namespace semilunar::spline
