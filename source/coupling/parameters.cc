// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/parameters.h>
#include <semilunar/coupling/parameters.h>

#include <deal.II/base/parameter_handler.h>

namespace semilunar::coupling
{
  void Parameters::add_parameters(dealii::ParameterHandler &prm)
  {
    namespace Patterns = dealii::Patterns;
    prm.enter_subsection("Coupling");
    prm.add_parameter("Normal penalty", beta_normal,
                      "Traction per velocity through the surface [g/(cm^2 s)]", positive_number());
    prm.add_parameter("Tangential penalty", beta_tangential,
                      "Traction per velocity along the surface [g/(cm^2 s)]; 0: slip",
                      Patterns::Double(0.));
    prm.add_parameter("Relaxation", relaxation,
                      "r of the multiplier, lambda <- (lambda + beta (u - v).n) / (1 + r) [-]; "
                      "steady leak r p / beta",
                      Patterns::Double(0.));
    prm.add_parameter("Points per cell", points_per_cell,
                      "Immersed points per width of a fluid cell, in each direction, at least [-]; "
                      "fewer than 2 leak",
                      Patterns::Double(1.));
    prm.add_parameter(
        "Incompressibility", incompressibility,
        "Weight of the accumulated grad-div in cells near a surface, in density h^2 / "
        "step [-]; 0: none, leaks",
        Patterns::Double(0.));
    prm.add_parameter("Scheme", scheme,
                      "quasi-direct: the fluid is solved together with the linearised structure; "
                      "block: in turn, with Aitken's acceleration",
                      Patterns::Selection("quasi-direct|block"));
    prm.add_parameter(
        "Tolerance", tolerance,
        "Of the structure's residual relative to its forces, at the end of a step [-]",
        Patterns::Double(0., 0.5));
    prm.add_parameter("Iterations", max_iterations, "After these a step has failed",
                      Patterns::Integer(1));
    prm.leave_subsection();
  }
} // namespace semilunar::coupling
