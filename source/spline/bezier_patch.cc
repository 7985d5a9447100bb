// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/spline/bernstein.h>
#include <semilunar/spline/closest_point.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cstring>

namespace semilunar::spline
{
  namespace
  {
    /// One homogeneous point in one SIMD register (an extension that GCC and Clang share; without
    /// such registers the compiler falls back to scalars).
    using Vector4 = double __attribute__((vector_size(32)));

    inline void load(const std::array<double, 4> &from, Vector4 &to)
    {
      std::memcpy(&to, from.data(), sizeof(to));
    }

    inline void store(const Vector4 &from, Tensor<1, 3> &to)
    {
      for (unsigned int d = 0; d < 3; ++d)
        to[d] = from[d];
    }

    inline void bernstein(const unsigned int p, const double x, double (&jet)[3][max_degree + 1])
    {
      if (p == 3)
        cubic_bernstein_jet(x, jet[0], jet[1], jet[2]);
      else
        bernstein_jet(p, x, jet[0], jet[1], jet[2]);
    }

    /// Derivatives of the homogeneous point: first all rows along the first direction, then across.
    /// Inlined with constant degrees it becomes straight-line code.
    __attribute__((always_inline)) inline void
    homogeneous_jet(const unsigned int p, const unsigned int q,
                    const std::array<double, 4> *coefficients, const Point<2> &xi,
                    Vector4 (&jet)[n_derivatives])
    {
      double u[3][max_degree + 1], v[3][max_degree + 1];
      bernstein(p, xi[0], u);
      bernstein(q, xi[1], v);
      for (Vector4 &derivative : jet)
        derivative = Vector4{};
      for (unsigned int j = 0; j <= q; ++j)
      {
        Vector4 row{}, row1{}, row11{}, c;
        for (unsigned int i = 0; i <= p; ++i)
        {
          load(coefficients[j * (p + 1) + i], c);
          row += u[0][i] * c;
          row1 += u[1][i] * c;
          row11 += u[2][i] * c;
        }
        jet[value] += v[0][j] * row;
        jet[d1] += v[0][j] * row1;
        jet[d2] += v[1][j] * row;
        jet[d11] += v[0][j] * row11;
        jet[d22] += v[2][j] * row;
        jet[d12] += v[1][j] * row1;
      }
    }
  } // namespace

  BezierPatch bezier_patch(const Surface &surface, const unsigned int element_index,
                           const std::vector<Tensor<1, 3>> &control_vectors)
  {
    AssertIndexRange(element_index, surface.elements.size());
    const BezierElement &element = surface.elements[element_index];
    const unsigned int m = element.n_bernstein();
    BezierPatch patch{element.degree, std::vector<std::array<double, 4>>(m)};
    Vector4 sums[(max_degree + 1) * (max_degree + 1)];
    std::fill_n(sums, m, Vector4{});
    const double *c = element.extraction.data();
    for (unsigned int a = 0; a < element.n_functions(); ++a, c += m)
    {
      const unsigned int i = element.control_points[a];
      const Tensor<1, 3> &x = control_vectors[i];
      Vector4 point{x[0], x[1], x[2], 1.};
      point *= surface.control_points[i].weight;
      for (unsigned int b = 0; b < m; ++b)
        sums[b] += c[b] * point;
    }
    std::memcpy(patch.coefficients.data(), sums, m * sizeof(Vector4));
    return patch;
  }

  SurfaceJet evaluate(const BezierPatch &patch, const Point<2> &xi)
  {
    Vector4 X[n_derivatives];
    if (patch.degree[0] == 3 && patch.degree[1] == 3)
      homogeneous_jet(3, 3, patch.coefficients.data(), xi, X);
    else
      homogeneous_jet(patch.degree[0], patch.degree[1], patch.coefficients.data(), xi, X);

    // the quotient rule (S5), with the weights in the last entries of X
    const double scale = 1. / X[value][3];
    const double W1 = X[d1][3], W2 = X[d2][3];
    const double W11 = X[d11][3], W22 = X[d22][3], W12 = X[d12][3];
    X[value] *= scale;
    X[d1] = (X[d1] - W1 * X[value]) * scale;
    X[d2] = (X[d2] - W2 * X[value]) * scale;
    X[d11] = (X[d11] - 2. * W1 * X[d1] - W11 * X[value]) * scale;
    X[d22] = (X[d22] - 2. * W2 * X[d2] - W22 * X[value]) * scale;
    X[d12] = (X[d12] - W2 * X[d1] - W1 * X[d2] - W12 * X[value]) * scale;

    SurfaceJet jet;
    for (unsigned int k = 0; k < n_derivatives; ++k)
      store(X[k], jet[k]);
    return jet;
  }
} // namespace semilunar::spline
