// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/spline/evaluation.h>
#include <semilunar/spline/fit.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_direct.h>
#include <deal.II/lac/sparse_matrix.h>

namespace semilunar::spline
{
  namespace
  {
    dealii::SparsityPattern sparsity(const Surface &surface)
    {
      const unsigned int n = surface.control_points.size();
      dealii::DynamicSparsityPattern pattern(n, n);
      for (const BezierElement &element : surface.elements)
        for (const unsigned int i : element.control_points)
          for (const unsigned int j : element.control_points)
            pattern.add(i, j);
      dealii::SparsityPattern result;
      result.copy_from(pattern);
      return result;
    }

    /// The normal equations of the least-squares problem.
    class NormalEquations
    {
    public:
      NormalEquations(const Surface &surface, const TargetShape &target)
          : surface(surface), target(target), pattern(sparsity(surface)),
            matrix(pattern), right_hand_sides{{Column(surface.control_points.size()),
                                               Column(surface.control_points.size()),
                                               Column(surface.control_points.size())}}
      {
      }

      void add(const SurfacePoint &point, const double weight)
      {
        const Point<3> x = target(point);
        evaluate_basis(surface, point.element, point.xi, basis);
        const std::vector<unsigned int> &points = surface.elements[point.element].control_points;
        const std::vector<double> &R = basis.values[value];
        for (unsigned int a = 0; a < points.size(); ++a)
        {
          for (unsigned int b = 0; b < points.size(); ++b)
            matrix.add(points[a], points[b], weight * R[a] * R[b]);
          for (unsigned int d = 0; d < 3; ++d)
            right_hand_sides[d][points[a]] += weight * R[a] * x[d];
        }
      }

      std::vector<Point<3>> solve() const
      {
        dealii::SparseDirectUMFPACK inverse;
        inverse.initialize(matrix);
        std::vector<Point<3>> result(surface.control_points.size());
        for (unsigned int d = 0; d < 3; ++d)
        {
          Column x(right_hand_sides[d].size());
          inverse.vmult(x, right_hand_sides[d]);
          for (unsigned int i = 0; i < result.size(); ++i)
            result[i][d] = x[i];
        }
        return result;
      }

    private:
      using Column = dealii::Vector<double>;
      const Surface &surface;
      const TargetShape &target;
      const dealii::SparsityPattern pattern;
      dealii::SparseMatrix<double> matrix;
      std::array<Column, 3> right_hand_sides;
      BasisValues basis;
    };
  } // namespace

  void fit(Surface &surface, const TargetShape &target,
           const std::vector<std::array<unsigned int, 2>> &edges)
  {
    NormalEquations equations(surface, target);
    constexpr double edge_weight = 100.;
    for (unsigned int e = 0; e < surface.elements.size(); ++e)
    {
      const dealii::QGauss<2> gauss(surface.elements[e].degree[0] + 1);
      for (unsigned int q = 0; q < gauss.size(); ++q)
        equations.add({e, gauss.point(q)}, gauss.weight(q));
    }
    for (const auto &[element, side] : edges)
    {
      const dealii::QGauss<1> gauss(surface.elements[element].degree[1 - side / 2] + 1);
      for (unsigned int q = 0; q < gauss.size(); ++q)
      {
        Point<2> xi;
        xi[side / 2] = side % 2;
        xi[1 - side / 2] = gauss.point(q)[0];
        equations.add({element, xi}, edge_weight * gauss.weight(q));
      }
    }
    const std::vector<Point<3>> positions = equations.solve();
    for (unsigned int i = 0; i < positions.size(); ++i)
      surface.control_points[i].position = positions[i];
  }
} // namespace semilunar::spline
