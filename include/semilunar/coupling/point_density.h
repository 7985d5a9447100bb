// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_coupling_point_density_h
#define semilunar_coupling_point_density_h

#include <semilunar/shell/quadrature_points.h>

#include <array>
#include <vector>

namespace semilunar::coupling
{
  /// Gauss points of each element of a surface in its two directions.
  using PointNumbers = std::vector<std::array<unsigned int, 2>>;

  PointNumbers point_numbers(const shell::QuadraturePoints &points, unsigned int n_elements);

  /// Lengths of an element along its two directions, (I9), from where its points are now.
  std::array<double, 2> element_lengths(const shell::QuadraturePoints &points, unsigned int element,
                                        const std::array<unsigned int, 2> &numbers,
                                        const std::vector<dealii::Tensor<1, 3>> &positions);

  /// More points for elements that have too few for the cells they are in, fewer for those that
  /// have far too many, (I9).
  /// @param positions of the points now [cm]
  /// @param widths    of the smallest cell that each element has points in; infinite: none [cm]
  /// @param per_cell  points that there should be per width of a cell
  PointNumbers adapted_numbers(const shell::QuadraturePoints &points,
                               const std::vector<dealii::Tensor<1, 3>> &positions,
                               const std::vector<double> &widths, double per_cell);

  /// Carry a number per point over to other points of the same elements: projection to
  /// polynomials, (I10).
  std::vector<double> transfer(const std::vector<double> &values,
                               const shell::QuadraturePoints &from,
                               const shell::QuadraturePoints &to, unsigned int n_elements);
} // namespace semilunar::coupling

#endif
