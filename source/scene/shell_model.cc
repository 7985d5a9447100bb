// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/scene/shell_model.h>

#include <limits>

namespace semilunar::scene
{
  void ShellParameters::add_parameters(dealii::ParameterHandler &prm)
  {
    section.add_parameters(prm);
    supports.add_parameters(prm);
    loads.add_parameters(prm);
    contact.add_parameters(prm);
  }

  ShellModel::ShellModel(spline::Surface given_surface, const ShellParameters &parameters,
                         Timers &timers, const unsigned int n_sectors)
      : surface(std::move(given_surface)), symmetry(n_sectors),
        section(parameters.section.make_section()), points(surface),
        equations(make_equations(surface, parameters.supports)),
        assembly(surface, points, *section,
                 [section = parameters.section](const auto &position, const auto &frame)
                 { return fibre_direction(section, position, frame); }),
        contact(parameters.contact.enabled ? std::make_unique<shell::Contact>(
                                                 surface, points, parameters.contact, symmetry)
                                           : nullptr),
        dead_forces(shell::dead_forces(surface, points, parameters.loads,
                                       parameters.section.density * parameters.section.thickness)),
        edge_moments(surface, parameters.loads),
        equilibrium(surface, points, equations, assembly, parameters.loads.follower_pressure(),
                    dead_forces, contact.get(), timers, &edge_moments)
  {
  }

  void report_size(const ShellModel &model, Log &log)
  {
    log.line(std::to_string(model.surface.elements.size()) + " elements, " +
             std::to_string(model.surface.control_points.size()) + " control points, " +
             std::to_string(model.equations.n_equations()) + " equations, " +
             std::to_string(model.points.n_points()) + " quadrature points");
  }

  LargestStrain largest_strain(const ShellModel &model, const shell::ControlVectors &x,
                               const int face, const std::function<bool(unsigned int)> &counts)
  {
    const double xi = 0.5 * face * model.section->thickness();
    LargestStrain largest{-std::numeric_limits<double>::infinity(), 0};
    for (unsigned int q = 0; q < model.points.n_points(); ++q)
    {
      const double strain = principal_strains(model.assembly.section_strain(x, q), xi)[0];
      if (strain > largest.value && counts(q))
        largest = {strain, q};
    }
    return largest;
  }
} // namespace semilunar::scene
