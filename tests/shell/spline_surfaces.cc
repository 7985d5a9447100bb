// SPDX-License-Identifier: LGPL-2.1-or-later
// Shells on surfaces with T-junctions and extraordinary points: patch tests of membrane and
// bending, and observed orders for the clamped plate and the Scordelis-Lo roof against tensor
// products.

#include <semilunar/shell/loads.h>
#include <semilunar/shell/supports.h>
#include <semilunar/spline/boundary_rows.h>
#include <semilunar/spline/fit.h>

#include "../spline/quad_meshes.h"
#include "../tests.h"
#include "spline_shells.h"

#include <set>

using namespace semilunar;
using namespace semilunar::shell;
using namespace semilunar::tests;

namespace
{
  /// The largest force on control points that are not in two rows of the boundary, by the largest.
  double unbalanced(const SplineShell &model, const ControlVectors &x)
  {
    ControlVectors forces(x.size());
    model.assembly.add(x, 0., forces, {});
    const auto sides = boundary_sides(model.surface);
    std::set<unsigned int> outer;
    for (const unsigned int row : {0u, 1u})
      for (const unsigned int c : control_row(model.surface, sides, row))
        outer.insert(c);
    double inside = 0., all = 0.;
    for (unsigned int c = 0; c < forces.size(); ++c)
    {
      all = std::max(all, forces[c].norm());
      if (outer.count(c) == 0)
        inside = std::max(inside, forces[c].norm());
    }
    return inside / all;
  }

  /// A uniform finite membrane strain makes no forces inside, whatever the mesh.
  void membrane_patch_test(const std::string &name, const Surface &surface)
  {
    const SplineShell model(surface, linear_elastic(1e6, 0.3, 0.05));
    ControlVectors x = positions(surface);
    for (auto &p : x)
      p = Tensor<1, 3>({1.1 * p[0] + 0.05 * p[1], -0.02 * p[0] + 0.95 * p[1], p[2]});
    check(name + ": membrane patch test", unbalanced(model, x), 1e-11);
  }

  /// Nor do uniform small curvatures on a T-mesh, in whose space they are.
  void bending_patch_test()
  {
    // exact coefficients: a biquadratic patch of one element, raised to cubic and refined
    const double size = 1e-7;
    std::vector<spline::ControlPoint> net;
    for (unsigned int j = 0; j < 3; ++j)
      for (unsigned int i = 0; i < 3; ++i)
      {
        const double xx = i == 2 ? 1. : 0., yy = j == 2 ? 1. : 0.; // blossoms of x^2 and y^2
        net.push_back(
            {Point<3>(i / 2., j / 2., size * (xx - 0.4 * yy + 0.7 * (i / 2.) * (j / 2.))), 1.});
      }
    spline::NurbsPatch bent(
        {{spline::KnotVector::uniform(2, 1), spline::KnotVector::uniform(2, 1)}}, net);
    make_cubic(bent, 6);
    const Surface flat = to_surface(with_t_junctions(cubic_square(6))),
                  curved = to_surface(with_t_junctions(bent));
    const SplineShell model(flat, linear_elastic(1e6, 0.3, 0.05));
    check("T-junctions: bending patch test (second order in the rotation)",
          unbalanced(model, positions(curved)), 1e-5);
    check(
        "T-junctions: bending energy",
        [&]()
        {
          ControlVectors forces(flat.control_points.size());
          const double energy = model.assembly.add(positions(curved), 0., forces, {});
          const double a = 2. * size, b = -0.8 * size, c = 0.7 * size,
                       D = 1e6 * 0.05 * 0.05 * 0.05 / 12. / (1. - 0.09);
          return energy / (0.5 * D * (a * a + b * b + 2. * 0.3 * a * b + 2. * 0.7 * c * c)) - 1.;
        }(),
        1e-4);
  }

  struct Result
  {
    unsigned int n;
    double value;
  };

  /// A linear analysis. @return the work of the load, twice the energy
  Result work(const Surface &surface, const SectionParameters &material,
              const std::string &supports, const std::string &area_load)
  {
    const SplineShell model(surface, material);
    const Equations equations = make_equations(model.surface, {supports});
    LoadParameters loads;
    loads.area_load = area_load;
    const ControlVectors forces = dead_forces(model.surface, model.points, loads, 0.);
    const ControlVectors x = linear_response(model, equations, forces);
    return {unsigned(surface.control_points.size()), dot(sum(x, -1., positions(surface)), forces)};
  }

  /// Errors of a sequence of meshes, relative to a value, and the order in the number of control
  /// points squared.
  void log_orders(const std::string &name, const std::vector<Result> &results, const double exact,
                  const double smallest_order)
  {
    std::fprintf(stderr, "%s:", name.c_str());
    double order = 0.;
    for (unsigned int k = 0; k < results.size(); ++k)
    {
      const double error = results[k].value / exact - 1.;
      if (k > 0)
        order = -2. * std::log(std::abs(error / (results[k - 1].value / exact - 1.))) /
                std::log(double(results[k].n) / results[k - 1].n);
      std::fprintf(stderr, " %u %.3e (%.2f)", results[k].n, error, order);
    }
    std::fprintf(stderr, "\n");
    check(name + ": order below the expected one by", std::max(0., smallest_order - order), 0.);
  }

  void clamped_plate()
  {
    const SectionParameters material = linear_elastic(1e7, 0.3, 0.01);
    const auto plate_work = [&](const Surface &surface)
    { return work(surface, material, clamped_all_round, "0, 0, 1"); };
    const double exact = plate_work(to_surface(cubic_square(40))).value;
    std::vector<Result> grids, t_meshes, points;
    for (const unsigned int n : {4u, 8u, 16u})
    {
      grids.push_back(plate_work(to_surface(cubic_square(n))));
      t_meshes.push_back(plate_work(to_surface(with_t_junctions(cubic_square(n)))));
      const PlacedMesh placed = square_with_points(n / 2);
      points.push_back(
          plate_work(to_surface(placed.mesh, lifted(placed, [](const Point<2> &) { return 0.; }))));
    }
    log_orders("clamped plate, tensor product", grids, exact, 3.5);
    log_orders("clamped plate, T-junctions", t_meshes, exact, 3.5);
    log_orders("clamped plate, extraordinary points", points, exact, 3.);
  }

  /// The fit leaves round-off where supports need planes.
  void put_into_planes(Surface &surface)
  {
    for (spline::ControlPoint &point : surface.control_points)
      for (const auto &[axis, level] : {std::pair<unsigned int, double>{2, 0.}, {2, 50.}})
        if (std::abs(point.position[axis] - level) < 1e-7)
          point.position[axis] = level;
  }

  void scordelis_lo()
  {
    const SectionParameters material = linear_elastic(4.32e8, 0., 0.25);
    const auto roof_work = [&](const Surface &surface)
    { return work(surface, material, roof_supports, "0, -90, 0"); };
    const double exact = roof_work(to_surface(cubic_roof(40))).value;
    std::vector<Result> grids, t_meshes, points;
    for (const unsigned int n : {4u, 8u, 16u})
    {
      grids.push_back(roof_work(to_surface(cubic_roof(n))));
      t_meshes.push_back(roof_work(to_surface(with_t_junctions(cubic_roof(n)))));
      const PlacedMesh placed = square_with_points(n / 2);
      const Surface map =
          to_surface(placed.mesh, lifted(placed, [](const Point<2> &) { return 0.; }));
      Surface fitted = map;
      const spline::NurbsPatch shape = cubic_roof(1);
      std::vector<std::array<unsigned int, 2>> edges;
      for (const auto &side : boundary_sides(map))
        edges.push_back({{side.element, side.side}});
      spline::fit(
          fitted,
          [&](const spline::SurfacePoint &p)
          {
            const auto u = evaluate(map, p)[spline::value];
            return shape.evaluate(
                {std::min(1., std::max(0., u[0])), std::min(1., std::max(0., u[1]))});
          },
          edges);
      put_into_planes(fitted);
      points.push_back(roof_work(fitted));
    }
    log_orders("Scordelis-Lo roof, tensor product", grids, exact, 3.5);
    log_orders("Scordelis-Lo roof, T-junctions", t_meshes, exact, 3.5);
    log_orders("Scordelis-Lo roof, extraordinary points", points, exact, 3.);
  }
} // namespace

int main()
{
  membrane_patch_test("T-junctions", to_surface(with_t_junctions(cubic_square(6))));
  for (const unsigned int n : {3u, 5u, 6u})
  {
    const PlacedMesh placed = star(n, 3);
    membrane_patch_test(
        "valence " + std::to_string(n),
        to_surface(placed.mesh, lifted(placed, [](const Point<2> &) { return 0.; })));
  }
  bending_patch_test();
  clamped_plate();
  scordelis_lo();
}
