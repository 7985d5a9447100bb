// SPDX-License-Identifier: LGPL-2.1-or-later
// Shells on surfaces with T-junctions and extraordinary points: patch tests of membrane and
// bending, and observed orders for the clamped plate and the Scordelis-Lo roof against tensor
// products.

#include <semilunar/shell/equilibrium.h>
#include <semilunar/shell/loads.h>
#include <semilunar/shell/section_parameters.h>
#include <semilunar/shell/static_solver.h>
#include <semilunar/shell/supports.h>
#include <semilunar/spline/boundary_rows.h>
#include <semilunar/spline/fit.h>
#include <semilunar/spline/t_spline.h>

#include "../spline/quad_meshes.h"
#include "../tests.h"
#include "shell_cases.h"

#include <set>

using namespace semilunar;
using namespace semilunar::shell;
using namespace semilunar::tests;
using spline::TSpline;

namespace
{
  SectionParameters steel(const double E, const double nu, const double thickness)
  {
    SectionParameters parameters;
    parameters.material = "Saint Venant-Kirchhoff";
    parameters.thickness = thickness;
    parameters.saint_venant_kirchhoff = {E, nu};
    return parameters;
  }

  struct Model
  {
    const Surface surface;
    const std::unique_ptr<Section> section;
    const QuadraturePoints points;
    const Assembly assembly;

    Model(const Surface &s, const SectionParameters &material)
        : surface(s), section(material.make_section()), points(surface),
          assembly(surface, points, *section,
                   [](const auto &, const auto &) {
                     return std::array<double, 2>{{1., 0.}};
                   })
    {
    }
  };

  spline::NurbsPatch square(const unsigned int n,
                            const std::function<double(Point<2>)> &height = {})
  {
    spline::NurbsPatch patch = spline::quadrilateral(
        {{Point<3>(0., 0., 0.), Point<3>(1., 0., 0.), Point<3>(0., 1., 0.), Point<3>(1., 1., 0.)}});
    for (unsigned int d = 0; d < 2; ++d)
    {
      patch.elevate_degree(d, 2);
      patch.refine_to(d, n);
    }
    std::vector<spline::ControlPoint> net = patch.control_net();
    for (spline::ControlPoint &point : net)
      if (height)
        point.position[2] = height({point.position[0], point.position[1]});
    return spline::NurbsPatch({{patch.knots(0), patch.knots(1)}}, net);
  }

  /// Refined twice where T-junctions run through the middle of things.
  TSpline t_spline(const spline::NurbsPatch &patch)
  {
    TSpline spline(patch);
    spline.refine_where([](const Point<2> &low, const Point<2> &high, const unsigned int level)
                        { return level < 2 && low[0] < 0.45 && low[1] < 0.45 && high[1] > 0.2; });
    return spline;
  }

  /// The largest force on control points that are not in two rows of the boundary, by the largest.
  double unbalanced(const Model &model, const ControlVectors &x)
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
    const Model model(surface, steel(1e6, 0.3, 0.05));
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
    for (unsigned int d = 0; d < 2; ++d)
    {
      bent.elevate_degree(d, 1);
      bent.refine_to(d, 6);
    }
    const Surface flat = to_surface(t_spline(square(6))), curved = to_surface(t_spline(bent));
    const Model model(flat, steel(1e6, 0.3, 0.05));
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
    const Model model(surface, material);
    const Equations equations = make_equations(model.surface, {supports});
    LoadParameters loads;
    loads.area_load = area_load;
    const ControlVectors forces = dead_forces(model.surface, model.points, loads, 0.);
    Timers timers;
    Equilibrium equilibrium(model.surface, model.points, equations, model.assembly, 0., forces,
                            nullptr, timers);
    NonlinearSystem::Vector u(equations.n_equations());
    StaticSolverParameters solver;
    solver.method = "linear";
    ControlVectors x;
    solve_static(equilibrium, u, solver,
                 {[&](const LoadStep &step, const NonlinearSystem::Vector &state)
                  { x = equilibrium.positions(state, step.load); }});
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
    const SectionParameters material = steel(1e7, 0.3, 0.01);
    const std::string all_round = "clamp x=0; clamp x=1; clamp y=0; clamp y=1";
    const auto plate_work = [&](const Surface &surface)
    { return work(surface, material, all_round, "0, 0, 1"); };
    const double exact = plate_work(to_surface(square(40))).value;
    std::vector<Result> grids, t_meshes, points;
    for (const unsigned int n : {4u, 8u, 16u})
    {
      grids.push_back(plate_work(to_surface(square(n))));
      t_meshes.push_back(plate_work(to_surface(t_spline(square(n)))));
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
    const SectionParameters material = steel(4.32e8, 0., 0.25);
    const auto roof = [](const unsigned int n)
    {
      spline::NurbsPatch patch =
          spline::cylinder(25., 50. * M_PI / 180., 130. * M_PI / 180., 0., 50.);
      patch.elevate_degree(0, 1);
      patch.elevate_degree(1, 2);
      patch.refine_to(0, n);
      patch.refine_to(1, n);
      return patch;
    };
    const auto roof_work = [&](const Surface &surface)
    { return work(surface, material, "fix z=0 xy; fix z=50 xy; fix (0,25,25) z", "0, -90, 0"); };
    const double exact = roof_work(to_surface(roof(40))).value;
    std::vector<Result> grids, t_meshes, points;
    for (const unsigned int n : {4u, 8u, 16u})
    {
      grids.push_back(roof_work(to_surface(roof(n))));
      t_meshes.push_back(roof_work(to_surface(t_spline(roof(n)))));
      const PlacedMesh placed = square_with_points(n / 2);
      const Surface map =
          to_surface(placed.mesh, lifted(placed, [](const Point<2> &) { return 0.; }));
      Surface fitted = map;
      const spline::NurbsPatch shape = roof(1);
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
  membrane_patch_test("T-junctions", to_surface(t_spline(square(6))));
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
