// SPDX-License-Identifier: LGPL-2.1-or-later
// Edge moments that follow the rotation: their force, work and tangent, and a cantilever rolled up
// to a full circle against its closed form. Newton's method with the predicted stress: far
// rotations in one load step.

#include <semilunar/core/exceptions.h>
#include <semilunar/shell/equilibrium.h>
#include <semilunar/shell/section_parameters.h>
#include <semilunar/shell/static_solver.h>
#include <semilunar/shell/supports.h>

#include "../tests.h"
#include "shell_cases.h"

using namespace semilunar;
using namespace semilunar::shell;
using namespace semilunar::tests;
using dealii::numbers::PI;

namespace
{
  LoadParameters moments(const std::string &list)
  {
    LoadParameters loads;
    loads.edge_moments = list;
    return loads;
  }

  /// A bent panel in a deformed state, and the moments along one edge of it.
  struct Panel
  {
    Surface surface = refined(spline::cylinder(2.5, 0.3, 1.7, 0., 1.6), {{3, 3}}, {{3, 2}});
    Vectors x =
        sum(spline::positions(surface), 1., random_vectors(surface.control_points.size(), 0.08, 4));

    Vectors forces(const EdgeMoments &edge, const Vectors &positions) const
    {
      Vectors f(x.size());
      edge.add(positions, -1., f, {});
      return f;
    }
  };

  void check_forces()
  {
    const Panel p;
    const double M = 0.7;
    // On the undeformed cylinder, whose normal points outward. The moment vector is M (conormal x
    // normal) times the length of the edge.
    const Vectors X = spline::positions(p.surface);
    const double arc = 2.5 * 1.4, height = 1.6;
    const Tensor<1, 3> up({0., 0., 1.});
    const auto couple = [&](const std::string &place)
    {
      const Vectors f = p.forces(EdgeMoments(p.surface, moments(place + ": 0.7")), X);
      check("no resultant force, " + place, total(f).norm() / norm(f), 1e-14);
      return moment(X, f);
    };
    // at "right", phi = 1.7, conormal x normal = e_phi x e_r = -e_z; at "left" the opposite
    check("moment, right", (couple("right") + M * height * up).norm() / M, 1e-6);
    check("moment, left", (couple("left") - M * height * up).norm() / M, 1e-6);
    // at the top e_z x e_r = e_phi, integrated along the arc
    const Tensor<1, 3> chord(
        {2.5 * (std::cos(1.7) - std::cos(0.3)), 2.5 * (std::sin(1.7) - std::sin(0.3)), 0.});
    check("moment, top", (couple("top") - M * chord).norm() / (M * arc), 1e-6);
    check("moment, bottom", (couple("bottom") + M * chord).norm() / (M * arc), 1e-6);
  }

  /// A rigid rotation does work on the moment vector alone; a moment turned along with a rotated
  /// shell turns with it.
  void check_rotation()
  {
    const Panel p;
    const EdgeMoments edge(p.surface, moments("top: 0.7; right: -0.4"));
    const Vectors f = p.forces(edge, p.x);
    // a rotation by 90 degrees about z, and one about x
    Vectors turned_x(p.x.size()), turned_f(p.x.size());
    const auto turn = [](const Tensor<1, 3> &v) { return Tensor<1, 3>({-v[2], -v[0], v[1]}); };
    for (unsigned int c = 0; c < p.x.size(); ++c)
    {
      turned_x[c] = turn(p.x[c]);
      turned_f[c] = turn(f[c]);
    }
    check("moments turn with the shell",
          norm(sum(p.forces(edge, turned_x), -1., turned_f)) / norm(f), 1e-13);
  }

  void check_tangent()
  {
    const Panel p;
    const EdgeMoments edge(p.surface, moments("top: 0.7; left: -0.4"));
    const Vectors direction = random_vectors(p.x.size(), 1., 9);
    Vectors difference(p.x.size()), tangent(p.x.size()), f(p.x.size());
    const double step = 1e-3, load = 0.6;
    for (const auto &[offset, weight] : central_differences)
    {
      Vectors moved(p.x.size());
      edge.add(sum(p.x, offset * step, direction), load, moved, {});
      difference = sum(difference, weight / step, moved);
    }
    edge.add(p.x, load, f,
             [&](const std::vector<unsigned int> &c, const double *block)
             {
               for (unsigned int a = 0; a < c.size(); ++a)
                 for (unsigned int i = 0; i < 3; ++i)
                   for (unsigned int b = 0; b < c.size(); ++b)
                     for (unsigned int j = 0; j < 3; ++j)
                       tangent[c[a]][i] +=
                           block[(3 * a + i) * 3 * c.size() + 3 * b + j] * direction[c[b]][j];
             });
    check("tangent of moments", norm(sum(tangent, -1., difference)) / norm(difference), 1e-9);
  }

  void check_messages()
  {
    const Panel p;
    for (const auto &[list, part] :
         {std::pair<std::string, std::string>{"right 5", "write PLACE: M"},
          {"right: (0, 0, 5)", "not a number"},
          {"rim: 5", "no such node set"},
          {"(2, 1, 0): 5", "no edge of the surface"}})
    {
      std::string message;
      try
      {
        EdgeMoments(p.surface, moments(list));
      }
      catch (const InputError &error)
      {
        message = error.what();
      }
      check("message for " + list,
            message.find("Loads/Edge moments") == 0 && message.find(part) != std::string::npos ? 0.
                                                                                               : 1.,
            0.);
    }
  }

  /// A strip clamped at x = 0 under an end load, and its path.
  struct Strip
  {
    const double length, thickness;
    unsigned int iterations = 0;
    std::vector<LoadStep> steps;
    std::vector<Tensor<1, 3>> tips; // displacement

    Strip(const double length, const double thickness, const unsigned int n_elements,
          const LoadParameters &loads, const StaticSolverParameters &solver)
        : length(length), thickness(thickness)
    {
      const Surface surface = plate(length, 1., {{4, 2}}, {{n_elements, 1}});
      SectionParameters parameters;
      parameters.material = "Saint Venant-Kirchhoff";
      parameters.thickness = thickness;
      parameters.saint_venant_kirchhoff = {1.2e6, 0.};
      const auto section = parameters.make_section();
      const QuadraturePoints points(surface);
      const Assembly assembly(surface, points, *section,
                              [](const Tensor<1, 3> &, const std::array<Tensor<1, 3>, 2> &) {
                                return std::array<double, 2>{{1., 0.}};
                              });
      const Equations equations = make_equations(surface, {"clamp x=0"});
      const Vectors forces = dead_forces(surface, points, loads, 0.);
      const EdgeMoments edge_moments(surface, loads);
      Timers timers;
      Equilibrium system(surface, points, equations, assembly, 0., forces, nullptr, timers,
                         &edge_moments);
      dealii::Vector<double> u(system.n_unknowns());
      const unsigned int tip = n_elements + 3; // last control point of the first row
      iterations = solve_static(system, u, solver,
                                {[&](const LoadStep &step, const dealii::Vector<double> &state)
                                 {
                                   steps.push_back(step);
                                   tips.push_back(system.positions(state, step.load)[tip] -
                                                  surface.control_points[tip].position);
                                 }});
    }
  };

  StaticSolverParameters newton(const unsigned int n_load_steps)
  {
    StaticSolverParameters parameters;
    parameters.method = "Newton";
    parameters.n_load_steps = n_load_steps;
    return parameters;
  }

  /// Uniform stretch l and curvature k per reference length: l^2 = 1 - h^2 k^2 / 6, M = E I l^2 k.
  void check_rolled_up()
  {
    const double length = 12., h = 0.1, stiffness = 1.2e6 * h * h * h / 12.;
    const double full = 2. * PI * stiffness / length;
    StaticSolverParameters solver = newton(4);
    solver.load_factors = {0.5, 0.25, 0.75};
    const Strip strip(length, h, 24, moments("x=12: " + std::to_string(full)), solver);
    for (const double load : {0.25, 0.5, 0.75, 1.})
    {
      unsigned int k = 0;
      while (k < strip.steps.size() && strip.steps[k].load != load)
        ++k;
      check("a step ends at load factor " + std::to_string(load), k == strip.steps.size(), 0.);
      double curvature = load * full / stiffness;
      for (unsigned int i = 0; i < 50; ++i)
        curvature = load * full / stiffness / (1. - h * h * curvature * curvature / 6.);
      const double angle = curvature * length;
      const double radius = std::sqrt(1. - h * h * curvature * curvature / 6.) / curvature;
      check("rolled up, x", (strip.tips[k][0] + length - radius * std::sin(angle)) / length, 2e-6);
      check("rolled up, z", (strip.tips[k][2] - radius * (1. - std::cos(angle))) / length, 2e-6);
    }
  }

  void check_iterations()
  {
    // thickness over length 1/100 and 1/1000 under the same P L^2 / (E I) = 4: the end rises by
    // 0.67 of the length in a single load step
    for (const double h : {0.1, 0.01})
    {
      LoadParameters loads;
      loads.edge_loads = "x=10: (0, 0, " + std::to_string(4e3 * h * h * h) + ")";
      const Strip strip(10., h, 16, loads, newton(1));
      check("one step, thickness " + std::to_string(h), strip.steps.size() - 1., 0.);
      check("one step, iterations above 5", strip.iterations - 5., 5.);
      check("one step, rise", strip.tips.back()[2] / 6.69964 - 1., 1e-4);
    }
  }

  /// Resultants that the linearisation predicts against differences of the stress.
  void check_prediction()
  {
    const Panel p;
    const QuadraturePoints points(p.surface);
    for (const std::string material : {"Saint Venant-Kirchhoff", "Fung"})
    {
      SectionParameters parameters;
      parameters.material = material;
      const auto section = parameters.make_section();
      const Assembly assembly(p.surface, points, *section,
                              [](const Tensor<1, 3> &, const std::array<Tensor<1, 3>, 2> &) {
                                return std::array<double, 2>{{1., 0.}};
                              });
      const Vectors x =
          sum(spline::positions(p.surface), 0.1, sum(p.x, -1., spline::positions(p.surface)));
      const Vectors change = random_vectors(x.size(), 1e-3, 5);
      const auto at = [&](const double t)
      {
        const Vectors moved = sum(x, t, change);
        std::vector<Resultants> all;
        for (unsigned int q = 0; q < points.n_points(); ++q)
        {
          SectionResponse response;
          section->evaluate(assembly.section_strain(moved, q), false, response);
          all.push_back({response.n, response.m});
        }
        return all;
      };
      const auto start = at(0.), predicted = assembly.predict(x, change);
      std::vector<Resultants> slope(start.size());
      for (const auto &[offset, weight] : central_differences)
      {
        const auto moved = at(0.1 * offset);
        for (unsigned int q = 0; q < moved.size(); ++q)
          for (unsigned int I = 0; I < 3; ++I)
          {
            slope[q].n[I] += 10. * weight * moved[q].n[I];
            slope[q].m[I] += 10. * weight * moved[q].m[I];
          }
      }
      double error[2] = {}, size[2] = {};
      for (unsigned int q = 0; q < start.size(); ++q)
        for (unsigned int I = 0; I < 3; ++I)
        {
          error[0] += std::abs(predicted[q].n[I] - start[q].n[I] - slope[q].n[I]);
          error[1] += std::abs(predicted[q].m[I] - start[q].m[I] - slope[q].m[I]);
          size[0] += std::abs(slope[q].n[I]);
          size[1] += std::abs(slope[q].m[I]);
        }
      check("predicted membrane force, " + material, error[0] / size[0], 1e-7);
      check("predicted moment, " + material, error[1] / size[1], 1e-7);
    }
  }
} // namespace

int main()
{
  check_forces();
  check_rotation();
  check_tangent();
  check_messages();
  check_prediction();
  check_rolled_up();
  check_iterations();
}
