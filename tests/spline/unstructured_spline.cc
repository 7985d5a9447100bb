// SPDX-License-Identifier: LGPL-2.1-or-later
// Splines on unstructured meshes: a grid gives B-splines; around extraordinary points functions sum
// to one, are linearly independent, and any combination of them has continuous normals.
#include "../tests.h"
#include "quad_meshes.h"

#include <semilunar/core/exceptions.h>
#include <semilunar/spline/closest_point.h>
#include <semilunar/spline/nurbs_patch.h>
#include <semilunar/spline/refined_region.h>
#include <semilunar/spline/surface_check.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <random>

using namespace semilunar;
using namespace semilunar::spline;
using namespace semilunar::tests;

namespace
{
  std::mt19937 random_number(3);

  double noise()
  {
    return std::uniform_real_distribution<double>(-1., 1.)(random_number);
  }

  Point<2> side_point(const unsigned int side, const double t)
  {
    const double x[4] = {t, 1., 1. - t, 0.}, y[4] = {0., t, 1., 1. - t};
    return {x[side], y[side]};
  }

  /// Largest distance and angle [rad] of the normals across inner edges.
  std::array<double, 2> jumps(const QuadMesh &mesh, const Surface &surface)
  {
    std::array<double, 2> largest{};
    for (unsigned int f = 0; f < mesh.n_faces(); ++f)
      for (unsigned int s = 0; s < 4; ++s)
      {
        const auto other = mesh.neighbour(f, s);
        if (!other)
          continue;
        for (const double t : {0., 0.13, 0.5, 0.9, 1.})
        {
          std::array<Tensor<1, 3>, 2> x, n;
          for (unsigned int k = 0; k < 2; ++k)
          {
            const auto jet = k == 0
                                 ? evaluate(surface, {f, side_point(s, t)})
                                 : evaluate(surface, {other.face, side_point(other.turn, 1. - t)});
            x[k] = jet[value];
            n[k] = cross_product_3d(jet[d1], jet[d2]);
            n[k] /= n[k].norm();
          }
          largest[0] = std::max(largest[0], (x[0] - x[1]).norm());
          largest[1] = std::max(largest[1], cross_product_3d(n[0], n[1]).norm());
        }
      }
    return largest;
  }

  /// By the eigenvalues of the matrix of mean products of the functions.
  unsigned int rank(const Surface &surface)
  {
    const unsigned int n = surface.control_points.size(), per_direction = 6;
    dealii::LAPACKFullMatrix<double> products(n, n);
    products = 0.;
    BasisValues basis;
    for (unsigned int e = 0; e < surface.elements.size(); ++e)
      for (unsigned int k = 0; k < per_direction * per_direction; ++k)
      {
        evaluate_basis(
            surface, e,
            {(k % per_direction + 0.5) / per_direction, (k / per_direction + 0.5) / per_direction},
            basis);
        const auto &c = surface.elements[e].control_points;
        for (unsigned int a = 0; a < c.size(); ++a)
          for (unsigned int b = 0; b < c.size(); ++b)
            products(c[a], c[b]) += basis.values[value][a] * basis.values[value][b];
      }
    products.compute_svd();
    unsigned int r = 0;
    while (r < n && products.singular_value(r) > 1e-12 * products.singular_value(0))
      ++r;
    return r;
  }

  double partition_error(const Surface &surface)
  {
    double error = 0.;
    for (const BezierElement &element : surface.elements)
      for (unsigned int b = 0; b < element.n_bernstein(); ++b)
      {
        double sum = -1.;
        for (unsigned int a = 0; a < element.n_functions(); ++a)
          sum += element.extraction[a * element.n_bernstein() + b];
        error = std::max(error, std::abs(sum));
      }
    return error;
  }

  /// Smallest area element by the largest of the faces around extraordinary points.
  double smallest_jacobian(const QuadMesh &mesh, const Surface &surface)
  {
    double smallest = 1e300, largest = 0.;
    for (unsigned int f = 0; f < mesh.n_faces(); ++f)
      if (mesh.is_irregular(f))
        for (unsigned int k = 0; k < 121; ++k)
        {
          const auto jet = evaluate(surface, {f, {k % 11 / 10., k / 11 / 10.}});
          const double J = cross_product_3d(jet[d1], jet[d2])[2];
          smallest = std::min(smallest, J);
          largest = std::max(largest, J);
        }
    return smallest / largest;
  }

  void grid()
  {
    std::vector<std::array<Point<2>, 4>> faces;
    divide({{Point<2>(0, 0), Point<2>(1, 0), Point<2>(1, 1), Point<2>(0, 1)}}, 5, faces);
    const PlacedMesh placed = mesh_of(faces);
    const UnstructuredFunctions functions(placed.mesh);
    const KnotVector knots = KnotVector::uniform(3, 5);
    // Functions of a row of vertices by place: their Greville abscissae give the identity map.
    const std::vector<double> greville = knots.greville_abscissae();
    const auto abscissa = [&](const double x, const bool outer)
    {
      const unsigned int i = std::lround(5. * x);
      return i == 0 ? greville[outer ? 0 : 1] : i == 5 ? greville[outer ? 7 : 6] : greville[i + 1];
    };
    std::vector<ControlPoint> points(functions.size());
    for (unsigned int v = 0; v < placed.mesh.n_vertices(); ++v)
      for (const auto &corner : placed.mesh.faces_at(v))
        for (unsigned int k = 0; k < 4; ++k)
        {
          const std::array<unsigned int, 2> shifts{{k % 2, k / 2}};
          const Point<2> x = placed.places[v];
          const bool edge_0 = x[0] == 0. || x[0] == 1., edge_1 = x[1] == 0. || x[1] == 1.;
          const bool across_0 = corner.turn % 2 == 0 ? shifts[0] : shifts[1];
          const bool across_1 = corner.turn % 2 == 0 ? shifts[1] : shifts[0];
          if ((across_0 && !edge_0) || (across_1 && !edge_1))
            continue;
          points[functions.number(corner, shifts)].position =
              Point<3>(abscissa(x[0], across_0), abscissa(x[1], across_1), 0.);
        }
    const Surface surface = to_surface(placed.mesh, points);
    double error = 0.;
    for (unsigned int f = 0; f < placed.mesh.n_faces(); ++f)
    {
      const Point<2> low = placed.places[placed.mesh.face(f)[0]];
      const Tensor<1, 3> x = evaluate(surface, {f, {0.3, 0.6}})[value];
      error = std::max(error, std::hypot(x[0] - low[0] - 0.06, x[1] - low[1] - 0.12));
    }
    log() << "grid: " << functions.size() << " functions" << std::endl;
    check("B-splines map their abscissae to the parameter", error, 1e-14);
    check("grid sums to one", partition_error(surface), 1e-14);
  }

  void around(const std::string &name, const PlacedMesh &placed)
  {
    for (const bool own_functions : {false, true})
    {
      std::vector<ControlPoint> points =
          lifted(placed, [](const Point<2> &x) { return x[0] * x[0] + 0.3 * x[0] * x[1]; });
      Surface surface = to_surface(placed.mesh, points, own_functions);
      spline::check(surface, name);
      check("functions sum to one", partition_error(surface), 1e-12);
      log() << name << ": " << surface.elements.size() << " elements, functions "
            << surface.control_points.size();
      if (own_functions) // those without are combinations of these
        log() << ", rank " << rank(surface);
      log() << ", smallest by largest Jacobian at the points " << std::setprecision(2)
            << smallest_jacobian(placed.mesh, surface) << std::setprecision(8) << std::endl;
      // any combination of the functions, weights included
      for (ControlPoint &control : surface.control_points)
      {
        control.position[2] += noise();
        control.weight = 1. + 0.3 * noise();
      }
      const auto jump = jumps(placed.mesh, surface);
      check("continuous", jump[0], 1e-13);
      check("continuous normals", jump[1], 1e-12);
    }
  }

  /// Largest angle of the normals [rad] of a random combination of the functions along the border
  /// of each element, against whatever element of another face or part is there.
  double normal_jump(Surface surface)
  {
    std::vector<Tensor<1, 3>> moved = positions(surface);
    for (Tensor<1, 3> &x : moved)
      x[2] += 0.05 * noise();
    double largest = 0.;
    const std::vector<BezierPatch> patches = [&]()
    {
      std::vector<BezierPatch> all;
      for (unsigned int e = 0; e < surface.elements.size(); ++e)
        all.push_back(bezier_patch(surface, e, moved));
      return all;
    }();
    for (unsigned int e = 0; e < patches.size(); ++e)
      for (unsigned int s = 0; s < 4; ++s)
      {
        const SurfaceJet jet = evaluate(patches[e], side_point(s, 0.37));
        for (unsigned int other = 0; other < patches.size(); ++other)
        {
          if (other == e)
            continue;
          const Projection foot = project(patches[other], jet[value], {0.5, 0.5});
          if (foot.distance > 1e-10)
            continue;
          Tensor<1, 3> a = cross_product_3d(jet[d1], jet[d2]),
                       b = cross_product_3d(foot.foot[d1], foot.foot[d2]);
          largest = std::max(largest, cross_product_3d(a / a.norm(), b / b.norm()).norm());
        }
      }
    return largest;
  }

  /// T-junctions in a grid of faces next to extraordinary points: the same surface, and smooth.
  void t_junctions_beside()
  {
    const PlacedMesh placed = star(3, 9);
    const auto height = [](const Point<2> &x) { return x[0] * x[0] + 0.3 * x[0] * x[1]; };
    const Surface coarse = to_surface(placed.mesh, lifted(placed, height));
    for (const unsigned int turn : {0u, 1u, 2u, 3u})
    {
      // the grid that starts at a corner of face (1, 1) of a sector, seen from any of its corners
      QuadMesh::TurnedFace origin = placed.mesh.up(placed.mesh.right({81, 0}));
      const unsigned int steps[4][2] = {{0, 0}, {7, 0}, {7, 7}, {0, 7}};
      for (unsigned int k = 0; k < steps[turn][0]; ++k)
        origin = placed.mesh.right(origin);
      for (unsigned int k = 0; k < steps[turn][1]; ++k)
        origin = placed.mesh.up(origin);
      origin.turn = (origin.turn + turn) % 4;
      Surface surface = coarse;
      // the outer corner of the mesh, which the turned grid sees elsewhere
      const auto far = [turn](const Point<2> &x)
      {
        const Point<2> seen[4] = {x, {8. - x[1], x[0]}, {8. - x[0], 8. - x[1]}, {x[1], 8. - x[0]}};
        return seen[turn][0] > 6.5 && seen[turn][1] > 6.5;
      };
      refine_region(
          placed.mesh, {origin, {{8, 8}}},
          [&far](const Point<2> &low, const Point<2> &high, const unsigned int level)
          { return level < 2 && far(low) && far(high); },
          surface);
      spline::check(surface, "refined");
      log() << "T-junctions, turn " << turn << ": " << surface.elements.size() << " elements, "
            << surface.control_points.size() << " functions of " << coarse.control_points.size();
      log() << std::endl;
      check("functions sum to one", partition_error(surface), 1e-12);
      double off = 0.;
      for (unsigned int e = 0; e < surface.elements.size(); ++e)
      {
        const auto jet = evaluate(surface, {e, {0.5, 0.5}});
        off = std::max(off, closest_point(coarse, positions(coarse), jet[value]).distance);
      }
      check("same surface", off, 1e-10);
      if (turn == 1)
        check("continuous normals", normal_jump(surface), 1e-9);
    }
  }

  void refused(const std::vector<QuadMesh::Face> &faces, const unsigned int n_vertices)
  {
    try
    {
      QuadMesh(n_vertices, faces);
      log() << "NO COMPLAINT" << std::endl;
    }
    catch (const InputError &error)
    {
      log() << error.what() << std::endl;
    }
  }
} // namespace

int main()
{
  grid();
  for (const unsigned int n : {3u, 5u, 6u})
    around("valence " + std::to_string(n), star(n, 3));
  around("four points of valence 3, sharing faces", rounded_square(2));
  around("eight points of valence 3 and 5", square_with_points(2));
  t_junctions_beside();
  refused({{{0, 1, 2, 3}}, {{0, 1, 4, 5}}}, 6);
  refused({{{0, 1, 2, 3}}}, 5);
  refused({{{0, 1, 2, 7}}}, 4);
  std::vector<QuadMesh::Face> fan;
  for (unsigned int i = 0; i < 5; ++i)
    fan.push_back({{0, 1 + 2 * i, 2 + 2 * i, 1 + (2 * i + 2) % 10}});
  refused(fan, 11);
}
