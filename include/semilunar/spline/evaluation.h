// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_spline_evaluation_h
#define semilunar_spline_evaluation_h

#include <semilunar/spline/surface.h>

namespace semilunar::spline
{
  /// Names of the derivatives in BasisValues and SurfaceJet, with respect to xi in [0,1]^2.
  enum Derivative : unsigned int
  {
    value = 0,
    d1 = 1,
    d2 = 2,
    d11 = 3,
    d22 = 4,
    d12 = 5
  };
  constexpr unsigned int n_derivatives = 6;

  /// The rational basis functions of one element at one point: values[derivative][function].
  struct BasisValues
  {
    std::array<std::vector<double>, n_derivatives> values;
  };

  /// Evaluate all functions of the element and their first and second derivatives at xi, (S3) to
  /// (S5). Allocates nothing if basis was used for an element of as many functions before.
  void evaluate_basis(const Surface &surface, unsigned int element, const Point<2> &xi,
                      BasisValues &basis);

  /// Position and its derivatives at a point of the surface.
  using SurfaceJet = std::array<Tensor<1, 3>, n_derivatives>;

  /// Interpolate vectors given at the control points (positions, displacements) with the basis.
  SurfaceJet interpolate(const BezierElement &element, const BasisValues &basis,
                         const std::vector<Tensor<1, 3>> &control_vectors);

  /// The control points' positions as vectors.
  std::vector<Tensor<1, 3>> positions(const Surface &surface);

  /// The surface point and its derivatives in the surface's own configuration.
  SurfaceJet evaluate(const Surface &surface, const SurfacePoint &point);
} // namespace semilunar::spline

#endif
