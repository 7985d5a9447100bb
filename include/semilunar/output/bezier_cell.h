// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_output_bezier_cell_h
#define semilunar_output_bezier_cell_h

#include <semilunar/output/tensor_product.h>

namespace semilunar::output
{
  /// The order in which VTK lists the nodes of a Bezier quadrilateral: for each node the Bernstein
  /// index j (p+1) + i. Four corners counterclockwise, the inner nodes of the edges bottom, right,
  /// top, left (each along the rising coordinate, also at the top and on the left), then the inner
  /// nodes, first direction fastest (vtkHigherOrderQuadrilateral::PointIndexFromIJK).
  std::vector<unsigned int> vtk_node_order(const std::array<unsigned int, 2> &degree);

  /// Interpolation of fields on rational Bezier cells of one pair of degrees.
  class RationalInterpolation
  {
  public:
    explicit RationalInterpolation(const std::array<unsigned int, 2> &degree);

    /// The (p+1)(q+1) points of [0,1]^2 at which fields are to be given.
    const std::vector<dealii::Point<2>> &points() const { return nodes; }

    /// Coefficients f_b of the field sum_b R_b f_b that takes the values at the points, (O2).
    /// Fields of the form polynomial of the degree / W, W = sum_b w_b B_b, are reproduced.
    /// @param weights the weights w_b of the Bernstein polynomials, (p+1)(q+1)
    /// @param values  n_components numbers for each point
    std::vector<double> coefficients(const std::vector<double> &weights, std::vector<double> values,
                                     unsigned int n_components) const;

  private:
    std::array<Matrix, 2> at_points;   ///< Bernstein coefficients to values at the points
    std::array<Matrix, 2> from_points; ///< the inverse
    std::vector<dealii::Point<2>> nodes;
  };
} // namespace semilunar::output

#endif
