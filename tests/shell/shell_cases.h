// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_tests_shell_cases_h
#define semilunar_tests_shell_cases_h

#include <semilunar/spline/evaluation.h>
#include <semilunar/spline/primitives.h>

#include <random>

namespace semilunar::tests
{
  using spline::Point;
  using spline::Surface;
  using spline::Tensor;
  using Vectors = std::vector<Tensor<1, 3>>;

  inline Surface refined(spline::NurbsPatch patch, const std::array<unsigned int, 2> &degrees,
                         const std::array<unsigned int, 2> &n_elements)
  {
    for (unsigned int direction = 0; direction < 2; ++direction)
    {
      patch.elevate_degree(direction, degrees[direction] - patch.knots(direction).degree());
      patch.refine_to(direction, n_elements[direction]);
    }
    return to_surface(patch);
  }

  /// The rectangle [0, length] x [0, width] at a height, normal +z.
  inline Surface plate(const double length, const double width,
                       const std::array<unsigned int, 2> &degrees,
                       const std::array<unsigned int, 2> &n_elements, const double height = 0.)
  {
    return refined(
        spline::quadrilateral({{Point<3>(0., 0., height), Point<3>(length, 0., height),
                                Point<3>(0., width, height), Point<3>(length, width, height)}}),
        degrees, n_elements);
  }

  /// Vectors with components between -size and size; the same for the same seed everywhere.
  inline Vectors random_vectors(const unsigned int n, const double size, const unsigned int seed)
  {
    std::mt19937 generator(seed);
    Vectors vectors(n);
    for (auto &v : vectors)
      for (unsigned int i = 0; i < 3; ++i)
        v[i] = size * (2. * (generator() / 4294967295.) - 1.);
    return vectors;
  }

  inline Vectors sum(Vectors a, const double factor, const Vectors &b)
  {
    for (unsigned int c = 0; c < a.size(); ++c)
      a[c] += factor * b[c];
    return a;
  }

  inline double dot(const Vectors &a, const Vectors &b)
  {
    double result = 0.;
    for (unsigned int c = 0; c < a.size(); ++c)
      result += a[c] * b[c];
    return result;
  }

  inline double norm(const Vectors &a)
  {
    return std::sqrt(dot(a, a));
  }

  inline Tensor<1, 3> total(const Vectors &forces)
  {
    Tensor<1, 3> result;
    for (const auto &force : forces)
      result += force;
    return result;
  }

  /// Moment about the origin of forces at positions.
  inline Tensor<1, 3> moment(const Vectors &positions, const Vectors &forces)
  {
    Tensor<1, 3> result;
    for (unsigned int c = 0; c < forces.size(); ++c)
      result += cross_product_3d(positions[c], forces[c]);
    return result;
  }

  /// Offsets, in steps, and weights of the central difference quotient of sixth order.
  struct DifferencePoint
  {
    int offset;
    double weight;
  };
  constexpr DifferencePoint central_differences[] = {
      {-3, -1. / 60.}, {-2, 3. / 20.}, {-1, -0.75}, {1, 0.75}, {2, -3. / 20.}, {3, 1. / 60.}};
} // namespace semilunar::tests

#endif
