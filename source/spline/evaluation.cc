// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/spline/bernstein.h>
#include <semilunar/spline/evaluation.h>

#include <deal.II/base/exceptions.h>

namespace semilunar::spline
{
  namespace
  {
    /// The derivatives of one function side by side, padded to a whole number of SIMD registers (a
    /// vector extension that GCC and Clang share).
    using PaddedJet = double __attribute__((vector_size(64)));

    /// The tensor-product Bernstein polynomials, (S3): table[b][derivative].
    void tabulate_bernstein(const std::array<unsigned int, 2> &degree, const Point<2> &xi,
                            PaddedJet *table)
    {
      double u[3][max_degree + 1], v[3][max_degree + 1];
      bernstein_jet(degree[0], xi[0], u[0], u[1], u[2]);
      bernstein_jet(degree[1], xi[1], v[0], v[1], v[2]);
      for (unsigned int j = 0; j <= degree[1]; ++j)
        for (unsigned int i = 0; i <= degree[0]; ++i, ++table)
          *table = PaddedJet{u[0][i] * v[0][j], u[1][i] * v[0][j], u[0][i] * v[1][j],
                             u[2][i] * v[0][j], u[0][i] * v[2][j], u[1][i] * v[1][j]};
    }

    /// From w_a N_a and its derivatives to R_a: the quotient rule (S5).
    void divide_by_weight(const PaddedJet &W, BasisValues &basis)
    {
      auto &R = basis.values;
      const double scale = 1. / W[value];
      const unsigned int n = R[value].size();
      for (unsigned int a = 0; a < n; ++a)
      {
        const double r = R[value][a] * scale;
        const double r1 = (R[d1][a] - r * W[d1]) * scale;
        const double r2 = (R[d2][a] - r * W[d2]) * scale;
        R[value][a] = r;
        R[d1][a] = r1;
        R[d2][a] = r2;
        R[d11][a] = (R[d11][a] - 2. * r1 * W[d1] - r * W[d11]) * scale;
        R[d22][a] = (R[d22][a] - 2. * r2 * W[d2] - r * W[d22]) * scale;
        R[d12][a] = (R[d12][a] - r1 * W[d2] - r2 * W[d1] - r * W[d12]) * scale;
      }
    }
  } // namespace

  void evaluate_basis(const Surface &surface, const unsigned int element_index, const Point<2> &xi,
                      BasisValues &basis)
  {
    AssertIndexRange(element_index, surface.elements.size());
    const BezierElement &element = surface.elements[element_index];
    const unsigned int n = element.n_functions(), m = element.n_bernstein();
    Assert(element.degree[0] <= max_degree && element.degree[1] <= max_degree,
           dealii::ExcMessage("degree above max_degree: the surface was not checked"));

    PaddedJet table[(max_degree + 1) * (max_degree + 1)];
    tabulate_bernstein(element.degree, xi, table);
    for (std::vector<double> &values : basis.values)
      values.resize(n);

    PaddedJet W{};
    const double *c = element.extraction.data();
    for (unsigned int a = 0; a < n; ++a, c += m)
    {
      PaddedJet N{};
      for (unsigned int b = 0; b < m; ++b)
        N += c[b] * table[b];
      N *= surface.control_points[element.control_points[a]].weight;
      W += N;
      for (unsigned int k = 0; k < n_derivatives; ++k)
        basis.values[k][a] = N[k];
    }
    divide_by_weight(W, basis);
  }

  SurfaceJet interpolate(const BezierElement &element, const BasisValues &basis,
                         const std::vector<Tensor<1, 3>> &control_vectors)
  {
    SurfaceJet jet;
    for (unsigned int a = 0; a < element.n_functions(); ++a)
    {
      const Tensor<1, 3> &x = control_vectors[element.control_points[a]];
      for (unsigned int k = 0; k < n_derivatives; ++k)
        for (unsigned int d = 0; d < 3; ++d)
          jet[k][d] += basis.values[k][a] * x[d];
    }
    return jet;
  }

  std::vector<Tensor<1, 3>> positions(const Surface &surface)
  {
    std::vector<Tensor<1, 3>> result;
    result.reserve(surface.control_points.size());
    for (const ControlPoint &point : surface.control_points)
      result.push_back(point.position);
    return result;
  }

  SurfaceJet evaluate(const Surface &surface, const SurfacePoint &point)
  {
    BasisValues basis;
    evaluate_basis(surface, point.element, point.xi, basis);
    const BezierElement &element = surface.elements[point.element];
    SurfaceJet jet;
    for (unsigned int a = 0; a < element.n_functions(); ++a)
      for (unsigned int k = 0; k < n_derivatives; ++k)
        jet[k] += basis.values[k][a] * surface.control_points[element.control_points[a]].position;
    return jet;
  }
} // namespace semilunar::spline
