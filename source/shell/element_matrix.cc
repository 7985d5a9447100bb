// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/shell/element_matrix.h>

#include <algorithm>

namespace semilunar::shell
{
  using spline::n_derivatives;

  namespace
  {
    constexpr unsigned int width = QuadraturePoints::simd_width;

    /// K_ab += sum_de G_da H_de G_eb for width columns b, starting at the given one: one strip of
    /// one of the nine component blocks. The product H G stays in registers.
    void add_strip(const double (&H)[n_derivatives][n_derivatives], const double *basis,
                   const unsigned int n, const unsigned int stride, const unsigned int column,
                   double *block)
    {
      double product[n_derivatives][width];
      for (unsigned int d = 0; d < n_derivatives; ++d)
      {
        for (unsigned int b = 0; b < width; ++b)
          product[d][b] = 0.;
        for (unsigned int e = 0; e < n_derivatives; ++e)
          for (unsigned int b = 0; b < width; ++b)
            product[d][b] += H[d][e] * basis[e * stride + column + b];
      }
      for (unsigned int a = 0; a < n; ++a)
      {
        double *out = block + a * stride + column;
        double sum[width];
        for (unsigned int b = 0; b < width; ++b)
          sum[b] = out[b];
        for (unsigned int d = 0; d < n_derivatives; ++d)
        {
          const double factor = basis[d * stride + a];
          for (unsigned int b = 0; b < width; ++b)
            sum[b] += factor * product[d][b];
        }
        for (unsigned int b = 0; b < width; ++b)
          out[b] = sum[b];
      }
    }
  } // namespace

  void ElementMatrix::reinit(const unsigned int n_functions, const unsigned int stride,
                             const bool with_tangent)
  {
    n = n_functions;
    n_padded = stride;
    tangent = with_tangent;
    forces.assign(3 * n, 0.);
    if (tangent)
    {
      blocks.resize_fast(9 * n * n_padded);
      std::fill(blocks.begin(), blocks.end(), 0.);
    }
  }

  void ElementMatrix::add(const PointResponse &response, const double *basis, const double weight)
  {
    for (unsigned int a = 0; a < n; ++a)
      for (unsigned int i = 0; i < 3; ++i)
      {
        double sum = 0.;
        for (unsigned int d = 0; d < n_derivatives; ++d)
          sum += basis[d * n_padded + a] * response.gradient[d][i];
        forces[3 * a + i] += weight * sum;
      }
    if (!tangent)
      return;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
      {
        double H[n_derivatives][n_derivatives];
        for (unsigned int d = 0; d < n_derivatives; ++d)
          for (unsigned int e = 0; e < n_derivatives; ++e)
            H[d][e] = weight * response.hessian[d][i][e][j];
        double *block = &blocks[(3 * i + j) * n * n_padded];
        for (unsigned int column = 0; column < n_padded; column += width)
          add_strip(H, basis, n, n_padded, column, block);
      }
  }

  void ElementMatrix::copy_matrix(std::vector<double> &block) const
  {
    block.resize(9 * n * n);
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        for (unsigned int a = 0; a < n; ++a)
        {
          const double *in = &blocks[((3 * i + j) * n + a) * n_padded];
          double *out = &block[(3 * a + i) * 3 * n + j];
          for (unsigned int b = 0; b < n; ++b)
            out[3 * b] = in[b];
        }
  }
} // namespace semilunar::shell
