// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_shell_element_matrix_h
#define semilunar_shell_element_matrix_h

#include <semilunar/shell/midsurface_point.h>
#include <semilunar/shell/quadrature_points.h>

#include <deal.II/base/aligned_vector.h>

namespace semilunar::shell
{
  /// Sums point responses, each contracted with the basis functions of an element, into the
  /// element's force and matrix.
  class ElementMatrix
  {
  public:
    /// @param n_functions functions of the element
    /// @param stride      the same, padded (QuadraturePoints::stride)
    void reinit(unsigned int n_functions, unsigned int stride, bool with_tangent);

    /// @param basis rows of functions and derivatives as in QuadraturePoints
    void add(const PointResponse &response, const double *basis, double weight);

    /// Force on function a, component i: index 3 a + i.
    const double *force() const { return forces.data(); }
    /// Write the (3n) x (3n) matrix row by row, index 3 a + i.
    void copy_matrix(std::vector<double> &block) const;

  private:
    unsigned int n = 0, n_padded = 0;
    bool tangent = false;
    std::vector<double> forces;
    dealii::AlignedVector<double> blocks; // [i][j][a][b]
  };
} // namespace semilunar::shell

#endif
