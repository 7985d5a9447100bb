// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_coupling_cell_map_h
#define semilunar_coupling_cell_map_h

#include <semilunar/flow/flow_solver.h>
#include <semilunar/shell/spatial_hash.h>

namespace semilunar::coupling
{
  /// Finds points in the cells of the mesh that hold fluid, starting from where they were: inverts
  /// the isoparametric map of a cell by Newton's method and walks through the faces beyond which
  /// the point lies. Costs about a microsecond for a point that stays in its cell.
  class CellMap
  {
  public:
    using Cell = dealii::DoFHandler<3>::active_cell_iterator;

    /// Refers to the flow's spaces and current positions.
    explicit CellMap(const flow::FlowSolver<3> &flow);

    struct Place
    {
      Cell cell; ///< owned or ghost; the end if the point was not found
      dealii::Point<3> unit_point;
    };
    /// @param guess a cell that is not artificial, and where to start in it
    Place find(const dealii::Tensor<1, 3> &x, const Place &guess) const;

    /// Search the owned cells of this rank for some of the points, whatever is known about them.
    std::vector<Place> search(const std::vector<dealii::Tensor<1, 3>> &points,
                              const std::vector<unsigned int> &which) const;

    /// Where a unit point of a cell is.
    dealii::Tensor<1, 3> position(const Place &place) const;

  private:
    /// Invert the map of a cell. @return whether the iteration converged near the cell
    bool invert(const dealii::Tensor<1, 3> &x, const Cell &cell, dealii::Point<3> &unit) const;
    bool is_inside(const dealii::Point<3> &unit) const;
    /// The cell beyond the face that the point lies farthest out of; the end at the boundary.
    Cell neighbor(const Cell &cell, const dealii::Point<3> &unit) const;
    Place search_around(const dealii::Tensor<1, 3> &x, const Cell &cell) const;
    shell::SpatialHash::Box bounding_box(const Cell &cell) const;
    /// Positions of the cell's nodes times the shape functions, and their derivatives.
    void evaluate(const Cell &cell, const dealii::Point<3> &unit, dealii::Tensor<1, 3> &x,
                  dealii::Tensor<2, 3> &jacobian) const;

    const flow::FlowSolver<3> &flow;
    const unsigned int n_1d;
    std::vector<std::vector<double>> shapes; ///< coefficients of the Lagrange polynomials
  };
} // namespace semilunar::coupling

#endif
