// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The part of FluidStructure that keeps the density of points.
#include <semilunar/core/exceptions.h>
#include <semilunar/coupling/fluid_structure.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <limits>

namespace semilunar::coupling
{
  std::vector<double> FluidStructure::cell_widths() const
  {
    const auto &triangulation = flow.spaces().velocity_dofs().get_triangulation();
    std::vector<double> of_cells(triangulation.n_active_cells(), 0.);
    for (const ImmersedPoints::Local &point : in_shell->local())
      of_cells[point.active_cell_index] = 1.;
    for (const auto &cell : triangulation.active_cell_iterators())
      if (of_cells[cell->active_cell_index()] > 0.)
        of_cells[cell->active_cell_index()] = std::cbrt(cell->measure());
    std::vector<double> widths(immersed.surface.elements.size(),
                               std::numeric_limits<double>::infinity());
    for (const ImmersedPoints::Local &point : in_shell->local())
    {
      double &width = widths[gauss->element(point.q)];
      width = std::min(width, of_cells[point.active_cell_index]);
    }
    dealii::Utilities::MPI::min(widths, communicator, widths);
    return widths;
  }

  PointNumbers FluidStructure::numbers_of_points() const
  {
    return point_numbers(*gauss, immersed.surface.elements.size());
  }

  bool FluidStructure::adapt_points()
  {
    if (!shell)
      return false;
    const Timers::Scope timer(timers, "coupling: points");
    const unsigned int n_outside = in_shell->n_points() - in_shell->n_inside();
    bool changed = false;
    // more points may find smaller cells
    constexpr unsigned int max_rounds = 4;
    for (unsigned int round = 0; round < max_rounds; ++round)
    {
      const PointNumbers numbers =
          adapted_numbers(*gauss, points.positions, cell_widths(), prm.points_per_cell);
      if (numbers == numbers_of_points())
        break;
      renew_points(numbers);
      changed = true;
    }
    if (changed && n_outside == 0 && in_shell->n_inside() < in_shell->n_points())
      throw NumericsError("of a part of an immersed surface that was in the fluid new points lie "
                          "outside",
                          "t = " + std::to_string(flow.time()), "");
    return changed;
  }

  void FluidStructure::renew_points(const PointNumbers &numbers)
  {
    const unsigned int n_before = n_shell_points();
    auto renewed = std::make_unique<const shell::QuadraturePoints>(immersed.surface, numbers);
    std::vector<double> multipliers = transfer({lambda.begin(), lambda.begin() + n_before}, *gauss,
                                               *renewed, immersed.surface.elements.size());
    multipliers.insert(multipliers.end(), lambda.begin() + n_before, lambda.end());
    lambda = std::move(multipliers);
    own_gauss = std::move(renewed);
    gauss = own_gauss.get();
    shell->set_points(*gauss);
    points = all_points();
    penalties.resize(points.positions.size());
    in_shell = std::make_unique<ImmersedPoints>(
        flow,
        std::vector<Force>(points.positions.begin(), points.positions.begin() + gauss->n_points()));
    weighted_dt = 0.; // other cells may hold points
  }

  void FluidStructure::set_points(const PointNumbers &numbers,
                                  const std::vector<double> &multipliers)
  {
    if (shell && numbers != numbers_of_points())
      renew_points(numbers);
    AssertDimension(multipliers.size(), lambda.size());
    lambda = multipliers;
  }
} // namespace semilunar::coupling
