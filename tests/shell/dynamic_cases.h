// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_tests_dynamic_cases_h
#define semilunar_tests_dynamic_cases_h

#include <semilunar/core/timers.h>
#include <semilunar/shell/section_parameters.h>
#include <semilunar/shell/supports.h>
#include <semilunar/shell/time_integrator.h>

#include <memory>

#include "shell_cases.h"

namespace semilunar::tests
{
  using namespace shell;
  using Velocity = std::function<Tensor<1, 3>(const Tensor<1, 3> &)>;

  /// Material and thickness of a St. Venant-Kirchhoff shell of density one.
  inline SectionParameters section_of(const double youngs_modulus, const double poisson_ratio,
                                      const double thickness)
  {
    SectionParameters parameters;
    parameters.material = "Saint Venant-Kirchhoff";
    parameters.thickness = thickness;
    parameters.saint_venant_kirchhoff.youngs_modulus = youngs_modulus;
    parameters.saint_venant_kirchhoff.poisson_ratio = poisson_ratio;
    parameters.density = 1.;
    return parameters;
  }

  /// What surrounds a moving shell besides its surface.
  struct Surroundings
  {
    std::string supports;
    double pressure = 0.;
    TimeTable load = TimeTable(1.);
    ContactParameters contact{};
    Tensor<1, 3> area_load{};
  };

  /// A shell that moves: everything that a TimeIntegrator refers to.
  struct MovingShell
  {
    MovingShell(const Surface &given, const SectionParameters &material, const Surroundings &around,
                const TimeIntegratorParameters &time)
        : surface(given), points(surface), section(material.make_section()),
          assembly(surface, points, *section,
                   [](const Tensor<1, 3> &, const std::array<Tensor<1, 3>, 2> &) {
                     return std::array<double, 2>{{1., 0.}};
                   }),
          equations(make_equations(surface, {around.supports, true})),
          mass(surface, points, material.density * material.thickness),
          contact(around.contact.enabled
                      ? std::make_unique<Contact>(surface, points, around.contact)
                      : nullptr),
          dead(mass.per_area() > 0. // there are tests without
                   ? mass.load([&](unsigned int) { return around.area_load / mass.per_area(); })
                   : ControlVectors(surface.control_points.size())),
          equilibrium(surface, points, equations, assembly, around.pressure, dead, contact.get(),
                      timers),
          integrator(equilibrium, equations, mass, contact.get(), around.load, time)
    {
    }

    /// Start at the undeformed positions plus displacements, with velocities; both projected.
    void start(const Velocity &displacement, const Velocity &velocity)
    {
      integrator.start(project(displacement), project(velocity));
    }

    NonlinearSystem::Vector project(const Velocity &field) const
    {
      NonlinearSystem::Vector right_hand_side, result;
      equations.restrict(mass.load(
                             [&](const unsigned int q) {
                               return field(spline::evaluate(
                                   surface, {points.element(q), points.xi(q)})[spline::value]);
                             }),
                         right_hand_side);
      mass.solve(equations, right_hand_side, result);
      return result;
    }

    void run_to(const double time)
    {
      while (integrator.time() < time)
        integrator.advance(time, [] { return false; });
    }

    const Surface surface;
    const QuadraturePoints points;
    const std::unique_ptr<Section> section;
    const Assembly assembly;
    const Equations equations;
    const Mass mass;
    const std::unique_ptr<Contact> contact;
    const ControlVectors dead;
    Timers timers;
    Equilibrium equilibrium;
    TimeIntegrator integrator;
  };
} // namespace semilunar::tests

#endif
