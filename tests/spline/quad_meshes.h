// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef tests_spline_quad_meshes_h
#define tests_spline_quad_meshes_h

#include <semilunar/spline/quad_mesh.h>
#include <semilunar/spline/relaxation.h>
#include <semilunar/spline/unstructured_spline.h>

#include <cmath>
#include <map>

namespace semilunar::tests
{
  using spline::ControlPoint;
  using spline::Point;
  using spline::QuadMesh;
  using spline::Tensor;

  /// A mesh and a position for each vertex.
  struct PlacedMesh
  {
    QuadMesh mesh;
    std::vector<Point<2>> places;
  };

  /// Faces given by the places of their corners; equal places are one vertex.
  inline PlacedMesh mesh_of(const std::vector<std::array<Point<2>, 4>> &faces)
  {
    std::map<std::pair<long, long>, unsigned int> number;
    std::vector<Point<2>> places;
    std::vector<QuadMesh::Face> numbered;
    for (const auto &corners : faces)
    {
      QuadMesh::Face face;
      for (unsigned int k = 0; k < 4; ++k)
      {
        const auto key =
            std::make_pair(std::lround(corners[k][0] * 1e8), std::lround(corners[k][1] * 1e8));
        const auto [found, is_new] = number.insert({key, places.size()});
        if (is_new)
          places.push_back(corners[k]);
        face[k] = found->second;
      }
      numbered.push_back(face);
    }
    return {QuadMesh(places.size(), numbered), places};
  }

  /// A quadrilateral divided into k x k faces.
  inline void divide(const std::array<Point<2>, 4> &c, const unsigned int k,
                     std::vector<std::array<Point<2>, 4>> &faces)
  {
    const auto at = [&](const unsigned int i, const unsigned int j)
    {
      const double s = double(i) / k, t = double(j) / k;
      return Point<2>((1. - s) * (1. - t) * c[0] + s * (1. - t) * c[1] + s * t * c[2] +
                      (1. - s) * t * c[3]);
    };
    for (unsigned int j = 0; j < k; ++j)
      for (unsigned int i = 0; i < k; ++i)
        faces.push_back({{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}});
  }

  /// n sectors of k x k faces around the origin, which is extraordinary unless n is 4.
  inline PlacedMesh star(const unsigned int n, const unsigned int k)
  {
    std::vector<std::array<Point<2>, 4>> faces;
    const double step = 2. * M_PI / n;
    const auto ray = [&](const double i, const double length)
    { return Point<2>(length * std::cos(i * step), length * std::sin(i * step)); };
    for (unsigned int i = 0; i < n; ++i)
      divide({{Point<2>(), ray(i, 1.), ray(i + 0.5, 1.2), ray(i + 1., 1.)}}, k, faces);
    return mesh_of(faces);
  }

  /// Four points of valence 3: an oblong joined to the corners of a square, which are rounded.
  inline PlacedMesh rounded_square(const unsigned int k)
  {
    const Point<2> a(0.35, 0.3), b(0.65, 0.3), c(0.65, 0.7), d(0.35, 0.7);
    std::vector<std::array<Point<2>, 4>> faces;
    divide({{a, b, c, d}}, k, faces);
    divide({{Point<2>(0, 0), Point<2>(1, 0), b, a}}, k, faces);
    divide({{Point<2>(1, 0), Point<2>(1, 1), c, b}}, k, faces);
    divide({{Point<2>(1, 1), Point<2>(0, 1), d, c}}, k, faces);
    divide({{Point<2>(0, 1), Point<2>(0, 0), a, d}}, k, faces);
    return mesh_of(faces);
  }

  /// The unit square with four points of valence 5 and four of valence 3: three by three blocks,
  /// the middle one a small square joined to its corners.
  inline PlacedMesh square_with_points(const unsigned int k)
  {
    const double x[4] = {0., 1. / 3., 2. / 3., 1.}, inner[2] = {0.42, 0.58};
    std::vector<std::array<Point<2>, 4>> faces;
    for (unsigned int j = 0; j < 3; ++j)
      for (unsigned int i = 0; i < 3; ++i)
        if (i != 1 || j != 1)
          divide({{Point<2>(x[i], x[j]), Point<2>(x[i + 1], x[j]), Point<2>(x[i + 1], x[j + 1]),
                   Point<2>(x[i], x[j + 1])}},
                 k, faces);
    const unsigned int round[5][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}};
    const auto large = [&](const unsigned int c)
    { return Point<2>(x[1 + round[c][0]], x[1 + round[c][1]]); };
    const auto small = [&](const unsigned int c)
    { return Point<2>(inner[round[c][0]], inner[round[c][1]]); };
    divide({{small(0), small(1), small(2), small(3)}}, k, faces);
    for (unsigned int c = 0; c < 4; ++c)
      divide({{large(c), large(c + 1), small(c + 1), small(c)}}, k, faces);
    PlacedMesh placed = mesh_of(faces);
    spline::relax(placed.mesh, placed.places);
    return placed;
  }

  /// Control points at the places, lifted by a function.
  template <typename Height>
  std::vector<ControlPoint> lifted(const PlacedMesh &placed, const Height &height)
  {
    std::vector<Point<3>> points;
    for (const Point<2> &x : placed.places)
      points.emplace_back(x[0], x[1], height(x));
    return clamped_net(placed.mesh, points);
  }
} // namespace semilunar::tests

#endif
