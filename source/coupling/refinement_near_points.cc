// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/coupling/refinement_near_points.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <cmath>

namespace semilunar::coupling
{
  namespace
  {
    using dealii::Point;
    using Triangulation = RefinementNearPoints::Triangulation;
    using ActiveCell = Triangulation::active_cell_iterator;
    using Cell = Triangulation::cell_iterator;

    /// Of a cell that a coarser one will be one day, so that it is not refined again at once.
    constexpr double hysteresis = 1.; // in its widths
    constexpr unsigned int n_children = 8;

    /// A cell's width, and how far it is from the nearest of the points: (I8).
    class Distances
    {
    public:
      explicit Distances(const std::vector<Point<3>> &points) : tree(dealii::pack_rtree(points)) {}

      static double width(const Cell &cell) { return cell->diameter() / std::sqrt(3.); }

      double operator()(const Cell &cell) const
      {
        namespace index = boost::geometry::index;
        const Point<3> centre = cell->center();
        double result = 0.;
        for (auto nearest = tree.qbegin(index::nearest(centre, 1)); nearest != tree.qend();
             ++nearest)
          result = nearest->distance(centre);
        return result - 0.5 * cell->diameter();
      }

    private:
      const dealii::RTree<Point<3>> tree;
    };

    /// What may become of the cells of a rank.
    struct Candidates
    {
      /// Cells, and the width of the zone, in widths of fine cells, from which on they are to be
      /// refined, or below which they may be coarsened.
      std::vector<std::pair<double, ActiveCell>> fine, coarse;

      double n_cells(const double width, const Triangulation &triangulation) const
      {
        double more = 0.;
        for (const auto &[threshold, cell] : fine)
          more += threshold <= width ? n_children - 1. : 0.;
        for (const auto &[threshold, cell] : coarse)
          more -= threshold > width ? (n_children - 1.) / n_children : 0.;
        return triangulation.n_global_active_cells() +
               dealii::Utilities::MPI::sum(more, triangulation.get_communicator());
      }
    };

    Candidates find_candidates(const Triangulation &triangulation, const Distances &distance,
                               const int coarsest, const int finest)
    {
      Candidates result;
      for (const auto &cell : triangulation.active_cell_iterators())
      {
        if (!cell->is_locally_owned())
          continue;
        const double fine_width = Distances::width(cell) * std::pow(2., cell->level() - finest);
        if (cell->level() < finest)
          result.fine.emplace_back(distance(cell) / fine_width, cell);
        if (cell->level() > coarsest)
        {
          const Cell parent = cell->parent();
          result.coarse.emplace_back(distance(parent) / fine_width -
                                         hysteresis * Distances::width(parent) / fine_width,
                                     cell);
        }
      }
      return result;
    }

    int coarsest_level(const Triangulation &triangulation)
    {
      int result = triangulation.n_global_levels();
      for (const auto &cell : triangulation.active_cell_iterators())
        if (cell->is_locally_owned())
          result = std::min(result, cell->level());
      return dealii::Utilities::MPI::min(result, triangulation.get_communicator());
    }

    /// The width of the fine zone that the number of cells allows.
    double allowed_width(const Candidates &candidates, const Triangulation &triangulation,
                         const RefinementParameters &prm)
    {
      if (candidates.n_cells(prm.width, triangulation) <= prm.max_cells)
        return prm.width;
      constexpr unsigned int n_bisections = 20;
      double low = -std::pow(2., prm.levels + 1),
             high = prm.width; // low: not even cells with points
      for (unsigned int i = 0; i < n_bisections; ++i)
      {
        const double middle = 0.5 * (low + high);
        (candidates.n_cells(middle, triangulation) <= prm.max_cells ? low : high) = middle;
      }
      return low;
    }
  } // namespace

  void RefinementParameters::add_parameters(dealii::ParameterHandler &prm)
  {
    namespace Patterns = dealii::Patterns;
    prm.enter_subsection("Refinement");
    prm.add_parameter("Levels", levels,
                      "How often the cells of the fluid around the leaflets are halved in each "
                      "direction, wherever the leaflets are; 0: the mesh stays as it is",
                      Patterns::Integer(0, 4));
    prm.add_parameter("Width", width,
                      "Of the zone of fine cells at each side of a leaflet, in widths of these "
                      "cells [-]",
                      Patterns::Double(0.));
    prm.add_parameter("Interval", interval,
                      "Time steps between looks whether leaflets have left the fine zone",
                      Patterns::Integer(1));
    prm.add_parameter("Largest number of cells", max_cells,
                      "The fine zone becomes narrower rather than the mesh much larger than this",
                      Patterns::Integer(1));
    prm.leave_subsection();
  }

  RefinementNearPoints::RefinementNearPoints(Triangulation &triangulation,
                                             const RefinementParameters &parameters,
                                             const std::vector<Position> &points)
      : triangulation(triangulation), prm(parameters), coarsest(coarsest_level(triangulation)),
        finest(coarsest + prm.levels)
  {
    for (unsigned int level = 0; level < prm.levels; ++level)
      if (flag(points))
        triangulation.execute_coarsening_and_refinement();
  }

  bool RefinementNearPoints::flag(const std::vector<Position> &points)
  {
    const Distances distance(std::vector<Point<3>>(points.begin(), points.end()));
    const Candidates candidates = find_candidates(triangulation, distance, coarsest, finest);
    const double width = allowed_width(candidates, triangulation, prm);
    bool any = false;
    for (const auto &[threshold, cell] : candidates.fine)
      if (threshold <= width)
      {
        cell->set_refine_flag();
        any = true;
      }
    for (const auto &[threshold, cell] : candidates.coarse)
      if (threshold > width)
      {
        cell->set_coarsen_flag();
        any = true;
      }
    return dealii::Utilities::MPI::max(any ? 1 : 0, triangulation.get_communicator()) == 1;
  }

  bool RefinementNearPoints::due(const unsigned int step,
                                 const std::vector<unsigned int> &with_points) const
  {
    if (prm.levels == 0 || step % prm.interval != 0)
      return false;
    std::vector<bool> holds_points(triangulation.n_active_cells(), false);
    for (const unsigned int index : with_points)
      holds_points[index] = true;
    const auto is_coarse = [this](const ActiveCell &cell)
    {
      if (cell->level() < finest)
        return true;
      for (const unsigned int face : cell->face_indices())
        if (!cell->at_boundary(face) && cell->neighbor_is_coarser(face))
          return true;
      return false;
    };
    bool result = false;
    for (const auto &cell : triangulation.active_cell_iterators())
      result = result || (holds_points[cell->active_cell_index()] && is_coarse(cell));
    return dealii::Utilities::MPI::max(result ? 1 : 0, triangulation.get_communicator()) == 1;
  }
} // namespace semilunar::coupling
