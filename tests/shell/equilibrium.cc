// SPDX-License-Identifier: LGPL-2.1-or-later
// The equations of equilibrium as the solvers see them, on a curved panel with prescribed and tied
// displacements, pressure and dead loads: their derivatives with respect to displacements and load,
// and the forces that residuals are compared with.

#include <semilunar/core/timers.h>
#include <semilunar/shell/equilibrium.h>
#include <semilunar/shell/loads.h>
#include <semilunar/shell/section_parameters.h>
#include <semilunar/shell/supports.h>

#include <cmath>
#include <limits>
#include <memory>

#include "../tests.h"
#include "shell_cases.h"

using namespace semilunar;
using namespace semilunar::shell;
using namespace semilunar::tests;

namespace
{
  using Vector = NonlinearSystem::Vector;

  constexpr double pressure = 4e4, radius = 1.2, width = 0.7;

  struct Panel
  {
    explicit Panel(const std::string &edge_load = "", const double p = 0.)
        : surface(refined(spline::cylinder(radius, 0.3, 1.5, 0., width), {{3, 2}}, {{3, 2}})),
          points(surface), section(SectionParameters().make_section()),
          assembly(surface, points, *section,
                   [](const Tensor<1, 3> &, const std::array<Tensor<1, 3>, 2> &) {
                     return std::array<double, 2>{{1., 0.}};
                   }),
          equations(make_equations(surface, {"clamp left; symmetry z=0; move right x 0.06"})),
          dead(dead_loads(edge_load)),
          system(surface, points, equations, assembly, p, dead, nullptr, timers),
          n(system.n_unknowns()), u(n), direction(n)
    {
      const Vectors noise = random_vectors(n, 1., 8);
      for (unsigned int i = 0; i < n; ++i)
      {
        u[i] = 0.004 * noise[i][0];
        direction[i] = noise[i][1];
      }
    }
    Vectors dead_loads(const std::string &edge_load) const
    {
      LoadParameters loads;
      loads.edge_loads = edge_load;
      return dead_forces(surface, points, loads, 1.);
    }
    Vector residual(const Vector &state, const double load)
    {
      Vector r;
      force = system.residual(state, load, r);
      return r;
    }

    const Surface surface;
    const QuadraturePoints points;
    const std::unique_ptr<Section> section;
    const Assembly assembly;
    const Equations equations;
    const Vectors dead;
    Timers timers;
    Equilibrium system;
    const unsigned int n;
    Vector u, direction;
    double force = 0.; // that the last residual is to be compared with
  };

  double difference(Vector a, const Vector &b)
  {
    a -= b;
    return a.l2_norm() / b.l2_norm();
  }

  void check_residual(Panel &panel)
  {
    const double load = 0.6;
    const Vector r = panel.residual(panel.u, load);
    std::vector<Tensor<1, 3>> x;
    panel.equations.expand(panel.u, load, x);
    const Vectors X = positions(panel.surface);
    for (unsigned int c = 0; c < X.size(); ++c)
      x[c] += X[c];
    check("positions", norm(sum(x, -1., panel.system.positions(panel.u, load))), 0.);
    Vectors forces(X.size());
    const double energy = panel.assembly.add(x, load * pressure, forces, {});
    Vector expected;
    panel.equations.restrict(sum(forces, -load, panel.dead), expected);
    check("residual", difference(r, expected), 1e-15);
    check("strain energy", panel.system.strain_energy() / energy - 1., 1e-15);

    // the force of a load of 1 per area in every direction
    LoadParameters ones;
    ones.area_load = "1, 1, 1";
    panel.equations.restrict(dead_forces(panel.surface, panel.points, ones, 0.), expected);
    check("lumped area", difference(panel.system.lumped_area(), expected), 1e-14);
  }

  void check_derivatives(Panel &panel)
  {
    const double load = 0.6, step = 1e-5;
    Vector by_u(panel.n), by_load(panel.n), by_load_step(panel.n);
    for (const auto &[offset, weight] : central_differences)
    {
      Vector moved = panel.u;
      moved.add(offset * step, panel.direction);
      by_u.add(weight / step, panel.residual(moved, load));
      by_load.add(weight / step, panel.residual(panel.u, load + offset * step));
    }
    panel.system.linearize(panel.u, load, 0.);
    Vector solution = by_u;
    panel.system.solve(solution);
    check("derivative by displacements", difference(solution, panel.direction), 1e-7);

    const double shift = 1e7; // as large as the stiffness
    panel.system.linearize(panel.u, load, shift);
    solution = by_u;
    for (unsigned int i = 0; i < panel.n; ++i)
      solution[i] += shift * panel.system.lumped_area()[i] * panel.direction[i];
    panel.system.solve(solution);
    check("derivative by displacements, shifted", difference(solution, panel.direction), 1e-7);

    panel.system.load_derivative(panel.u, load, by_load_step);
    check("derivative by load factor", difference(by_load_step, by_load), 1e-6);
  }

  void check_forces()
  {
    const Vector zero(Panel().n);
    // Of the full loads on the undeformed shell; independent of the supports and the load factor.
    Panel loaded("top: (3, 0, 4)");
    loaded.residual(zero, 0.5);
    check("norm of an edge load", loaded.force / norm(loaded.dead) - 1., 1e-14);
    loaded.residual(zero, -0.5);
    check("norm of an edge load, negative load factor", loaded.force / norm(loaded.dead) - 1.,
          1e-14);
    Panel inflated("", pressure);
    inflated.residual(zero, 0.5);
    const Vectors X = positions(inflated.surface);
    Vectors forces(X.size());
    inflated.assembly.add(X, pressure, forces, {});
    check("norm of pressure", inflated.force / norm(forces) - 1., 1e-9);
    inflated.residual(inflated.u, 0.5);
    check("norm of pressure on the deformed shell", inflated.force / norm(forces) - 1., 1e-9);

    Panel both("top: (3e3, 0, 4e3)", pressure);
    both.residual(zero, 0.5);
    check("norm of both", both.force / norm(sum(forces, -1., both.dead)) - 1., 1e-9);

    // no loads: reactions in all prescribed components
    Panel moved;
    const Vector r = moved.residual(moved.u, 0.5);
    forces.assign(X.size(), Tensor<1, 3>());
    moved.assembly.add(moved.system.positions(moved.u, 0.5), 0., forces, {});
    double reactions = 0.;
    for (unsigned int c = 0; c < X.size(); ++c)
      for (unsigned int i = 0; i < 3; ++i)
        if (moved.equations.is_prescribed(c, i))
          reactions += forces[c][i] * forces[c][i];
    check("norm of reactions", moved.force / std::sqrt(reactions) - 1., 1e-14);
    moved.residual(zero, 0.);
    check("a force to compare with at rest", moved.force > 0. ? 0. : 1., 0.);
    check("no bound on changes without contact",
          moved.system.largest_change() == std::numeric_limits<double>::infinity() ? 0. : 1., 0.);
  }
} // namespace

int main()
{
  Panel panel("top: (3e3, 0, 4e3)", pressure);
  check_residual(panel);
  check_derivatives(panel);
  check_forces();
}
