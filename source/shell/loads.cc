// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/core/units.h>
#include <semilunar/shell/loads.h>
#include <semilunar/spline/closest_point.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/utilities.h>

namespace semilunar::shell
{
  using spline::Tensor;

  namespace
  {
    /// "PLACE: vector" items of a list.
    std::vector<std::pair<std::string, Tensor<1, 3>>> parse_items(const std::string &list,
                                                                  const std::string &entry)
    {
      std::vector<std::pair<std::string, Tensor<1, 3>>> items;
      for (const std::string &item : dealii::Utilities::split_string_list(list, ';'))
        if (!item.empty())
        {
          const std::vector<std::string> parts = dealii::Utilities::split_string_list(item, ':');
          if (parts.size() != 2)
            throw InputError(entry, item, "this is not a load", "write PLACE: (fx, fy, fz)");
          items.emplace_back(parts[0], parse_vector(parts[1], entry));
        }
      return items;
    }

    void add_area_load(const QuadraturePoints &points, const spline::Surface &surface,
                       const Tensor<1, 3> &load, std::vector<Tensor<1, 3>> &forces)
    {
      for (unsigned int q = 0; q < points.n_points(); ++q)
      {
        const auto &element = surface.elements[points.element(q)];
        const double *R = points.basis(q, spline::value);
        for (unsigned int a = 0; a < element.n_functions(); ++a)
          forces[element.control_points[a]] += points.weight(q) * R[a] * load;
      }
    }

    void add_point_load(const spline::Surface &surface, const Tensor<1, 3> &place,
                        const Tensor<1, 3> &load, std::vector<Tensor<1, 3>> &forces)
    {
      const spline::SurfacePoint foot =
          closest_point(surface, spline::positions(surface), place).point;
      spline::BasisValues basis;
      spline::evaluate_basis(surface, foot.element, foot.xi, basis);
      const auto &element = surface.elements[foot.element];
      for (unsigned int a = 0; a < element.n_functions(); ++a)
        forces[element.control_points[a]] += basis.values[spline::value][a] * load;
    }

    void add_edge_load(const spline::Surface &surface, const spline::ElementSide &side,
                       const Tensor<1, 3> &load, std::vector<Tensor<1, 3>> &forces)
    {
      const auto &element = surface.elements[side.element];
      const auto points = spline::positions(surface);
      const unsigned int along = side.side < 2 ? 1 : 0;
      const dealii::QGauss<1> quadrature(element.degree[along] + 1);
      spline::BasisValues basis;
      for (unsigned int q = 0; q < quadrature.size(); ++q)
      {
        spline::Point<2> xi;
        xi[1 - along] = side.side % 2;
        xi[along] = quadrature.point(q)[0];
        spline::evaluate_basis(surface, side.element, xi, basis);
        const auto jet = spline::interpolate(element, basis, points);
        const double length =
            quadrature.weight(q) * jet[along == 0 ? spline::d1 : spline::d2].norm();
        for (unsigned int a = 0; a < element.n_functions(); ++a)
          forces[element.control_points[a]] += length * basis.values[spline::value][a] * load;
      }
    }
  } // namespace

  void LoadParameters::add_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Loads");
    prm.add_parameter(
        "Pressure", pressure,
        "Follower pressure against the surface normal, on the deformed area [force/area].");
    prm.add_parameter("Pressure in mmHg", pressure_mmhg,
                      "The same for a scene in cm, g, s; give one of the two [mmHg].");
    prm.add_parameter("Area load", area_load,
                      "Dead load vector on the undeformed area [force/area].");
    prm.add_parameter("Acceleration", acceleration,
                      "Body force per mass; acts through density and thickness [length/time^2].");
    prm.add_parameter(
        "Point loads", point_loads,
        "Dead forces at points of the undeformed surface, '(x, y, z): (fx, fy, fz)', "
        "separated by semicolons; each acts at the nearest point of the surface [force].");
    prm.add_parameter(
        "Edge loads", edge_loads,
        "Dead forces along edges, 'PLACE: (fx, fy, fz)', separated by semicolons; a PLACE "
        "is a node set or a coordinate plane that holds an edge [force/length].");
    prm.add_parameter(
        "Edge moments", edge_moments,
        "Moments along edges, 'PLACE: M', separated by semicolons: per undeformed length, about "
        "the edge, turning what lies at it towards the surface normal; they follow the rotation "
        "of the shell, on whose angle they do work [force].");
    prm.leave_subsection();
  }

  double LoadParameters::follower_pressure() const
  {
    if (pressure != 0. && pressure_mmhg != 0.)
      throw InputError("Loads/Pressure", "", "the pressure is given twice",
                       "give either Pressure or Pressure in mmHg");
    return pressure + mmHg * pressure_mmhg;
  }

  Tensor<1, 3> LoadParameters::dead_area_load(const double mass_per_area) const
  {
    return parse_vector(area_load, "Loads/Area load") +
           mass_per_area * parse_vector(acceleration, "Loads/Acceleration");
  }

  std::vector<Tensor<1, 3>> dead_forces(const spline::Surface &surface,
                                        const QuadraturePoints &points,
                                        const LoadParameters &parameters,
                                        const double mass_per_area)
  {
    std::vector<Tensor<1, 3>> forces(surface.control_points.size());
    const Tensor<1, 3> area_load = parameters.dead_area_load(mass_per_area);
    if (area_load.norm() > 0.)
      add_area_load(points, surface, area_load, forces);
    for (const auto &[place, load] : parse_items(parameters.point_loads, "Loads/Point loads"))
      add_point_load(surface, parse_vector(place, "Loads/Point loads"), load, forces);
    for (const auto &[place, load] : parse_items(parameters.edge_loads, "Loads/Edge loads"))
    {
      const Location location = find_location(surface, place, "Loads/Edge loads");
      for (const auto &side : location_sides(surface, location, "Loads/Edge loads"))
        add_edge_load(surface, side, load, forces);
    }
    return forces;
  }
} // namespace semilunar::shell
