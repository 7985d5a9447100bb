// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_tests_spline_shells_h
#define semilunar_tests_spline_shells_h

#include <semilunar/shell/equilibrium.h>
#include <semilunar/shell/section_parameters.h>
#include <semilunar/shell/static_solver.h>
#include <semilunar/spline/t_spline.h>

#include "shell_cases.h"

namespace semilunar::tests
{
  inline shell::SectionParameters linear_elastic(const double E, const double nu,
                                                 const double thickness)
  {
    shell::SectionParameters parameters;
    parameters.material = "Saint Venant-Kirchhoff";
    parameters.thickness = thickness;
    parameters.saint_venant_kirchhoff = {E, nu};
    return parameters;
  }

  /// A shell of any surface, with fibres along the first direction of its elements.
  struct SplineShell
  {
    const Surface surface;
    const std::unique_ptr<shell::Section> section;
    const shell::QuadraturePoints points;
    const shell::Assembly assembly;

    SplineShell(const Surface &s, const shell::SectionParameters &parameters,
                const unsigned int n_gauss = 0)
        : surface(s), section(parameters.make_section()), points(surface, n_gauss),
          assembly(surface, points, *section,
                   [](const auto &, const auto &) {
                     return std::array<double, 2>{{1., 0.}};
                   })
    {
    }
  };

  /// Positions of the control points under dead forces, by a linear analysis.
  inline Vectors linear_response(const SplineShell &shell, const shell::Equations &equations,
                                 const Vectors &forces)
  {
    Timers timers;
    shell::Equilibrium equilibrium(shell.surface, shell.points, equations, shell.assembly, 0.,
                                   forces, nullptr, timers);
    shell::NonlinearSystem::Vector u(equations.n_equations());
    shell::StaticSolverParameters solver;
    solver.method = "linear";
    Vectors x;
    solve_static(equilibrium, u, solver,
                 {[&](const shell::LoadStep &step, const shell::NonlinearSystem::Vector &state)
                  { x = equilibrium.positions(state, step.load); }});
    return x;
  }

  inline void make_cubic(spline::NurbsPatch &patch, const unsigned int n_elements)
  {
    for (unsigned int d = 0; d < 2; ++d)
    {
      patch.elevate_degree(d, 3 - patch.knots(d).degree());
      patch.refine_to(d, n_elements);
    }
  }

  /// The unit square, cubic, of n x n elements.
  inline spline::NurbsPatch cubic_square(const unsigned int n)
  {
    spline::NurbsPatch patch = spline::quadrilateral(
        {{Point<3>(0., 0., 0.), Point<3>(1., 0., 0.), Point<3>(0., 1., 0.), Point<3>(1., 1., 0.)}});
    make_cubic(patch, n);
    return patch;
  }

  /// The Scordelis-Lo roof, whole, of n x n elements.
  inline spline::NurbsPatch cubic_roof(const unsigned int n)
  {
    spline::NurbsPatch patch =
        spline::cylinder(25., 50. * M_PI / 180., 130. * M_PI / 180., 0., 50.);
    make_cubic(patch, n);
    return patch;
  }
  constexpr const char *roof_supports = "fix z=0 xy; fix z=50 xy; fix (0,25,25) z";
  constexpr const char *clamped_all_round = "clamp x=0; clamp x=1; clamp y=0; clamp y=1";

  /// Refined twice where T-junctions run through the middle of things.
  inline spline::TSpline with_t_junctions(const spline::NurbsPatch &patch)
  {
    spline::TSpline spline(patch);
    spline.refine_where([](const Point<2> &low, const Point<2> &high, const unsigned int level)
                        { return level < 2 && low[0] < 0.45 && low[1] < 0.45 && high[1] > 0.2; });
    return spline;
  }
} // namespace semilunar::tests

#endif
