// SPDX-License-Identifier: LGPL-2.1-or-later
// Dead loads on curved surfaces: total forces and moments against closed forms; messages for loads
// that make no sense.

#include <semilunar/core/exceptions.h>
#include <semilunar/shell/loads.h>

#include <functional>

#include "../tests.h"
#include "shell_cases.h"

using namespace semilunar;
using namespace semilunar::shell;
using namespace semilunar::spline;
using namespace semilunar::tests;

namespace
{
  const double pi = dealii::numbers::PI;
  const double R = 2.5, begin = 0.3, end = 1.7, height = 1.6;
  const double arc = R * (end - begin), area = arc * height;
  constexpr double mass_per_area = 0.7;

  struct Case
  {
    Surface surface = refined(cylinder(R, begin, end, 0., height), {{3, 3}}, {{6, 4}});
    QuadraturePoints points{surface};
    Vectors X = positions(surface);

    Vectors forces(const LoadParameters &loads) const
    {
      return dead_forces(surface, points, loads, mass_per_area);
    }
  };

  void check_resultant(const std::string &what, const Case &c, const LoadParameters &loads,
                       const Tensor<1, 3> &force, const Tensor<1, 3> &place)
  {
    const Vectors f = c.forces(loads);
    check(what + ", force", (total(f) - force).norm() / force.norm(), 1e-8);
    check(what + ", moment",
          (moment(c.X, f) - cross_product_3d(place, force)).norm() / force.norm(), 1e-8);
  }

  void check_surface_loads()
  {
    const Case c;
    // centroid of the area
    const Tensor<1, 3> centroid({R * (std::sin(end) - std::sin(begin)) / (end - begin),
                                 R * (std::cos(begin) - std::cos(end)) / (end - begin),
                                 height / 2.});
    LoadParameters loads;
    check("no load", norm(c.forces(loads)), 0.);
    loads.pressure = 5.;
    check("the follower pressure is no dead load", norm(c.forces(loads)), 0.);
    loads.area_load = "1, -2, 0.5";
    check_resultant("area load", c, loads, area * Tensor<1, 3>({1., -2., 0.5}), centroid);
    loads = LoadParameters();
    loads.acceleration = "(0, 0, -981)";
    check_resultant("acceleration", c, loads, area * mass_per_area * Tensor<1, 3>({0., 0., -981.}),
                    centroid);
    loads.area_load = "0 0 981";
    const double with_both = (1. - mass_per_area) * 981. * area;
    check_resultant("both", c, loads, Tensor<1, 3>({0., 0., with_both}), centroid);

    Case ball;
    ball.surface = refined(sphere(R, 0., pi / 2., 0., pi / 2.), {{3, 3}}, {{6, 6}});
    ball.points = QuadraturePoints(ball.surface);
    ball.X = positions(ball.surface);
    loads = LoadParameters();
    loads.area_load = "0, 3, 0";
    check_resultant("octant of a sphere", ball, loads, pi / 2. * R * R * Tensor<1, 3>({0., 3., 0.}),
                    Tensor<1, 3>({R / 2., R / 2., R / 2.}));
  }

  void check_edge_loads()
  {
    const Case c;
    LoadParameters loads;
    loads.edge_loads = "left: (1, 2, 3)";
    const Tensor<1, 3> load({1., 2., 3.});
    const double x = R * std::cos(begin), y = R * std::sin(begin);
    check_resultant("load on a straight edge", c, loads, height * load,
                    Tensor<1, 3>({x, y, height / 2.}));
    loads.edge_loads = "z=1.6: (1, 2, 3)";
    check_resultant("load on a curved edge", c, loads, arc * load,
                    Tensor<1, 3>({R * (std::sin(end) - std::sin(begin)) / (end - begin),
                                  R * (std::cos(begin) - std::cos(end)) / (end - begin), height}));
    loads.edge_loads = "top: (0, 0, 1); bottom: (0, 0, -1)";
    check("opposite loads", total(c.forces(loads)).norm(), 1e-13);
    check("opposite loads stretch", dot(c.X, c.forces(loads)) / (arc * height) - 1., 1e-8);
  }

  void check_point_loads()
  {
    const Case c;
    LoadParameters loads;
    // beside the surface; acts on the nearest point
    const double angle = 0.9, z = 0.77;
    const Tensor<1, 3> normal({std::cos(angle), std::sin(angle), 0.}), up({0., 0., z});
    const auto list = [](const Tensor<1, 3> &p)
    {
      std::string text;
      for (unsigned int i = 0; i < 3; ++i)
      {
        char number[40];
        std::snprintf(number, sizeof(number), "%.17g", p[i]);
        text += (i > 0 ? ", " : "(") + std::string(number);
      }
      return text + ")";
    };
    loads.point_loads = list(1.1 * R * normal + up) + ": (3, -1, 2)";
    check_resultant("point load", c, loads, Tensor<1, 3>({3., -1., 2.}), R * normal + up);
    loads.point_loads += "; " + list(R * normal + up) + ": (-3, 1, -2)";
    check("two point loads", norm(c.forces(loads)), 1e-7);
    loads.point_loads =
        list(Tensor<1, 3>({R * std::cos(end), R * std::sin(end), height})) + ": (0, 0, 4)";
    const Vectors f = c.forces(loads);
    check("a load on a corner goes to its control point", f.back()[2] - 4., 1e-9);
  }

  void check_pressure()
  {
    LoadParameters loads;
    check("no pressure", loads.follower_pressure(), 0.);
    loads.pressure = -12.5;
    check("pressure", loads.follower_pressure() + 12.5, 0.);
    loads.pressure = 0.;
    loads.pressure_mmhg = 100.;
    check("100 mmHg in dyn/cm^2", loads.follower_pressure() / 133322. - 1., 1e-14);
  }

  /// A message must name the entry and hold all of these.
  void check_message(const std::string &entry, LoadParameters loads,
                     std::string LoadParameters::*member, const std::string &value,
                     const std::vector<std::string> &parts)
  {
    loads.*member = value;
    std::string message = "no message";
    try
    {
      Case().forces(loads);
    }
    catch (const InputError &error)
    {
      message = error.what();
    }
    bool complete = message.find(entry + " = \"") == 0;
    for (const std::string &part : parts)
      complete = complete && message.find(part) != std::string::npos;
    if (!complete)
      std::fprintf(stderr, "%s\n", message.c_str());
    check("message for " + entry + " = " + value, complete ? 0. : 1., 0.);
  }

  void check_messages()
  {
    const auto area_load = &LoadParameters::area_load, point = &LoadParameters::point_loads,
               edge = &LoadParameters::edge_loads, acceleration = &LoadParameters::acceleration;
    check_message("Loads/Area load", {}, area_load, "1, 2",
                  {"\"1, 2\"", "not a vector", "three numbers"});
    check_message("Loads/Acceleration", {}, acceleration, "0, 0, g",
                  {"\"g\"", "not a number", "1.5e-3"});
    check_message("Loads/Point loads", {}, point, "(0, 0, 1) (1, 0, 0)",
                  {"(0, 0, 1) (1, 0, 0)", "not a load", "PLACE: (fx, fy, fz)"});
    check_message("Loads/Point loads", {}, point, "left: (1, 0, 0)",
                  {"\"left\"", "not a vector", "three numbers"});
    check_message("Loads/Edge loads", {}, edge, "rim: (1, 0, 0)",
                  {"\"rim\"", "no such node set", "left, right, bottom, top"});
    check_message("Loads/Edge loads", {}, edge, "(2, 1, 0): (1, 0, 0)",
                  {"(2, 1, 0)", "no edge of the surface", "whole edge"});

    LoadParameters twice;
    twice.pressure = 1.;
    twice.pressure_mmhg = 2.;
    bool refused = false;
    try
    {
      twice.follower_pressure();
    }
    catch (const InputError &error)
    {
      refused = error.where() == "Loads/Pressure" &&
                std::string(error.what()).find("given twice") != std::string::npos;
    }
    check("pressure given twice", refused ? 0. : 1., 0.);
  }
} // namespace

int main()
{
  check_surface_loads();
  check_edge_loads();
  check_point_loads();
  check_pressure();
  check_messages();
}
