// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/coupling/cell_map.h>
#include <semilunar/flow/tensor_kernel.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace semilunar::coupling
{
  using dealii::Point;
  using dealii::Tensor;

  namespace
  {
    /// Points of a face belong to both of its cells.
    constexpr double face_tolerance = 1e-9;
  } // namespace

  CellMap::CellMap(const flow::FlowSolver<3> &flow) : flow(flow), n_1d(flow.spaces().degree() + 1)
  {
    for (const auto &polynomial : dealii::Polynomials::generate_complete_Lagrange_basis(
             flow::nodes_1d(flow.spaces().degree())))
    {
      // Horner's scheme on plain coefficients: value and derivative by differences at 0
      std::vector<double> coefficients;
      std::vector<double> derivatives(n_1d);
      polynomial.value(0., derivatives);
      double factorial = 1.;
      for (unsigned int k = 0; k < n_1d; factorial *= ++k)
        coefficients.push_back(derivatives[k] / factorial);
      shapes.push_back(coefficients);
    }
  }

  void CellMap::evaluate(const Cell &cell, const Point<3> &unit, Tensor<1, 3> &x,
                         Tensor<2, 3> &jacobian) const
  {
    constexpr unsigned int most = 4; // nodes in a direction
    double value[3][most], slope[3][most];
    for (unsigned int d = 0; d < 3; ++d)
      for (unsigned int i = 0; i < n_1d; ++i)
      {
        double v = 0., s = 0.;
        for (unsigned int k = n_1d; k-- > 0;)
        {
          s = s * unit[d] + v;
          v = v * unit[d] + shapes[i][k];
        }
        value[d][i] = v;
        slope[d][i] = s;
      }
    const flow::CellLane where = flow.spaces().lane_of(cell->active_cell_index());
    const auto *nodes = flow.spaces().velocity_nodes(where.batch);
    const flow::Vector &positions = flow.positions();
    x = Tensor<1, 3>();
    jacobian = Tensor<2, 3>();
    unsigned int node = 0;
    for (unsigned int k = 0; k < n_1d; ++k)
      for (unsigned int j = 0; j < n_1d; ++j)
      {
        const double vv = value[1][j] * value[2][k], sv = slope[1][j] * value[2][k],
                     vs = value[1][j] * slope[2][k];
        for (unsigned int i = 0; i < n_1d; ++i, ++node)
          for (unsigned int c = 0; c < 3; ++c)
          {
            const double p = positions.local_element(3 * nodes[node][where.lane] + c);
            x[c] += value[0][i] * vv * p;
            jacobian[c][0] += slope[0][i] * vv * p;
            jacobian[c][1] += value[0][i] * sv * p;
            jacobian[c][2] += value[0][i] * vs * p;
          }
      }
  }

  Tensor<1, 3> CellMap::position(const Place &place) const
  {
    Tensor<1, 3> x;
    Tensor<2, 3> jacobian;
    evaluate(place.cell, place.unit_point, x, jacobian);
    return x;
  }

  bool CellMap::invert(const Tensor<1, 3> &x, const Cell &cell, Point<3> &unit) const
  {
    constexpr unsigned int max_iterations = 12;
    constexpr double largest_step = 1., converged = 1e-12, far_outside = 4.;
    for (unsigned int iteration = 0; iteration < max_iterations; ++iteration)
    {
      Tensor<1, 3> y;
      Tensor<2, 3> jacobian;
      evaluate(cell, unit, y, jacobian);
      if (!(determinant(jacobian) > 0.))
        return false;
      Tensor<1, 3> step = dealii::invert(jacobian) * (x - y);
      const double length = step.norm();
      if (length > largest_step)
        step *= largest_step / length;
      unit += step;
      if (length < converged)
        return true;
      for (unsigned int d = 0; d < 3; ++d)
        if (std::abs(unit[d] - 0.5) > far_outside)
          return true; // it lies in that direction
    }
    return false;
  }

  bool CellMap::is_inside(const Point<3> &unit) const
  {
    for (unsigned int d = 0; d < 3; ++d)
      if (unit[d] < -face_tolerance || unit[d] > 1. + face_tolerance)
        return false;
    return true;
  }

  CellMap::Cell CellMap::neighbor(const Cell &cell, const Point<3> &unit) const
  {
    const Cell end = flow.spaces().velocity_dofs().end();
    unsigned int face = 0;
    double farthest = 0.;
    for (unsigned int d = 0; d < 3; ++d)
      for (unsigned int side = 0; side < 2; ++side)
      {
        const double beyond = side == 0 ? -unit[d] : unit[d] - 1.;
        if (beyond > farthest && !cell->at_boundary(2 * d + side))
        {
          farthest = beyond;
          face = 2 * d + side;
        }
      }
    if (farthest <= face_tolerance)
      return end;
    auto next = cell->neighbor(face);
    while (next->has_children()) // any of the smaller ones: the walk goes on from there
      next = next->child(0);
    return next->is_artificial() || !flow.spaces().in_lumen(next->active_cell_index()) ? end
                                                                                       : Cell(next);
  }

  CellMap::Place CellMap::search_around(const Tensor<1, 3> &x, const Cell &cell) const
  {
    for (const unsigned int face : cell->face_indices())
      if (!cell->at_boundary(face))
      {
        auto next = cell->neighbor(face);
        while (next->has_children())
          next = next->child(0);
        if (next->is_artificial() || !flow.spaces().in_lumen(next->active_cell_index()))
          continue;
        Place place{Cell(next), Point<3>(0.5, 0.5, 0.5)};
        if (invert(x, place.cell, place.unit_point) && is_inside(place.unit_point))
          return place;
      }
    return {flow.spaces().velocity_dofs().end(), {}};
  }

  shell::SpatialHash::Box CellMap::bounding_box(const Cell &cell) const
  {
    // The nodes' box, and what a curved cell may reach beyond its nodes.
    constexpr double bulge = 0.1;
    const flow::CellLane where = flow.spaces().lane_of(cell->active_cell_index());
    const auto *nodes = flow.spaces().velocity_nodes(where.batch);
    shell::SpatialHash::Box box;
    for (unsigned int c = 0; c < 3; ++c)
    {
      double lower = std::numeric_limits<double>::max(), upper = -lower;
      for (unsigned int i = 0; i < n_1d * n_1d * n_1d; ++i)
      {
        const double p = flow.positions().local_element(3 * nodes[i][where.lane] + c);
        lower = std::min(lower, p);
        upper = std::max(upper, p);
      }
      box.lower[c] = lower - bulge * (upper - lower);
      box.upper[c] = upper + bulge * (upper - lower);
    }
    return box;
  }

  std::vector<CellMap::Place> CellMap::search(const std::vector<Tensor<1, 3>> &points,
                                              const std::vector<unsigned int> &which) const
  {
    const auto &handler = flow.spaces().velocity_dofs();
    std::vector<Cell> cells;
    std::vector<shell::SpatialHash::Box> boxes;
    for (const auto &cell : handler.active_cell_iterators())
      if (cell->is_locally_owned() && flow.spaces().in_lumen(cell->active_cell_index()))
      {
        cells.push_back(cell);
        boxes.push_back(bounding_box(cell));
      }
    shell::SpatialHash hash;
    hash.build(boxes, 0.);
    const auto holds = [](const shell::SpatialHash::Box &box, const Tensor<1, 3> &x)
    {
      for (unsigned int c = 0; c < 3; ++c)
        if (x[c] < box.lower[c] || x[c] > box.upper[c])
          return false;
      return true;
    };
    std::vector<Place> places(which.size(), {handler.end(), {}});
    for (unsigned int i = 0; i < which.size(); ++i)
      for (const unsigned int candidate : hash.near(points[which[i]]))
        if (holds(boxes[candidate], points[which[i]]))
        {
          Place place{cells[candidate], Point<3>(0.5, 0.5, 0.5)};
          if (!invert(points[which[i]], place.cell, place.unit_point) ||
              !is_inside(place.unit_point))
            continue;
          place.unit_point = dealii::GeometryInfo<3>::project_to_unit_cell(place.unit_point);
          places[i] = place;
          break;
        }
    return places;
  }

  CellMap::Place CellMap::find(const Tensor<1, 3> &x, const Place &guess) const
  {
    constexpr unsigned int longest_walk = 50;
    Place place = guess;
    for (unsigned int step = 0; step < longest_walk; ++step)
    {
      const bool converged = invert(x, place.cell, place.unit_point);
      if (converged && is_inside(place.unit_point))
      {
        place.unit_point = dealii::GeometryInfo<3>::project_to_unit_cell(place.unit_point);
        return place;
      }
      const Cell next = neighbor(place.cell, place.unit_point);
      if (next == flow.spaces().velocity_dofs().end())
        break;
      place = {next, Point<3>(0.5, 0.5, 0.5)};
    }
    return search_around(x, place.cell);
  }
} // namespace semilunar::coupling
