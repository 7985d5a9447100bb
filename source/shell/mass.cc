// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/shell/mass.h>

#include <deal.II/lac/precondition.h>
#include <deal.II/lac/solver_cg.h>

namespace semilunar::shell
{
  namespace
  {
    /// Of the norm of the right-hand side: what double precision allows.
    constexpr double tolerance = 1e-14;

    /// The mass matrix as conjugate gradients see it.
    struct Operator
    {
      const Mass &mass;
      const Equations &equations;
      void vmult(dealii::Vector<double> &result, const dealii::Vector<double> &x) const
      {
        mass.multiply(equations, x, result);
      }
    };
  } // namespace

  Mass::Mass(const spline::Surface &surface, const QuadraturePoints &points,
             const double mass_per_area)
      : surface(surface), points(points), mass_per_area(mass_per_area)
  {
    for (unsigned int e = 0; e < surface.elements.size(); ++e)
    {
      const unsigned int n = surface.elements[e].n_functions();
      std::vector<double> block(n * n, 0.);
      for (unsigned int q = points.first_point(e); q < points.first_point(e + 1); ++q)
      {
        const double *R = points.basis(q, spline::value);
        const double weight = mass_per_area * points.weight(q);
        total_mass += weight;
        for (unsigned int a = 0; a < n; ++a)
          for (unsigned int b = 0; b < n; ++b)
            block[a * n + b] += weight * R[a] * R[b];
      }
      blocks.push_back(std::move(block));
    }
  }

  ControlVectors Mass::momentum(const ControlVectors &velocities) const
  {
    ControlVectors result(velocities.size());
    for (unsigned int e = 0; e < blocks.size(); ++e)
    {
      const auto &control_points = surface.elements[e].control_points;
      const unsigned int n = control_points.size();
      for (unsigned int a = 0; a < n; ++a)
      {
        spline::Tensor<1, 3> sum;
        for (unsigned int b = 0; b < n; ++b)
          sum += blocks[e][a * n + b] * velocities[control_points[b]];
        result[control_points[a]] += sum;
      }
    }
    return result;
  }

  void Mass::multiply(const Equations &equations, const dealii::Vector<double> &velocities,
                      dealii::Vector<double> &result) const
  {
    ControlVectors all;
    equations.expand(velocities, 0., all);
    equations.restrict(momentum(all), result);
  }

  void Mass::solve(const Equations &equations, const dealii::Vector<double> &right_hand_side,
                   dealii::Vector<double> &x) const
  {
    ControlVectors diagonals(equations.n_control_points());
    for (unsigned int e = 0; e < blocks.size(); ++e)
    {
      const auto &control_points = surface.elements[e].control_points;
      for (unsigned int a = 0; a < control_points.size(); ++a)
        for (unsigned int i = 0; i < 3; ++i)
          diagonals[control_points[a]][i] += blocks[e][a * (control_points.size() + 1)];
    }
    dealii::DiagonalMatrix<dealii::Vector<double>> inverse_diagonal;
    equations.restrict(diagonals, inverse_diagonal.get_vector());
    for (double &entry : inverse_diagonal.get_vector())
      entry = 1. / entry;

    x.reinit(right_hand_side.size());
    if (right_hand_side.l2_norm() == 0.)
      return;
    dealii::SolverControl control(10 * right_hand_side.size() + 100,
                                  tolerance * right_hand_side.l2_norm());
    dealii::SolverCG<dealii::Vector<double>> solver(control);
    try
    {
      solver.solve(Operator{*this, equations}, x, right_hand_side, inverse_diagonal);
    }
    catch (const dealii::SolverControl::NoConvergence &)
    {
      throw NumericsError("the mass matrix cannot be inverted", "initial acceleration", "");
    }
  }

  void Mass::add_to(SparseSystem &matrix, const double factor) const
  {
    std::vector<double> block;
    for (unsigned int e = 0; e < blocks.size(); ++e)
    {
      const auto &control_points = surface.elements[e].control_points;
      const unsigned int n = control_points.size();
      block.assign(9 * n * n, 0.);
      for (unsigned int a = 0; a < n; ++a)
        for (unsigned int b = 0; b < n; ++b)
          for (unsigned int i = 0; i < 3; ++i)
            block[(3 * a + i) * 3 * n + 3 * b + i] = factor * blocks[e][a * n + b];
      matrix.add(control_points, block.data());
    }
  }

  ControlVectors Mass::load(const std::function<spline::Tensor<1, 3>(unsigned int q)> &values) const
  {
    ControlVectors result(surface.control_points.size());
    for (unsigned int q = 0; q < points.n_points(); ++q)
    {
      const auto &element = surface.elements[points.element(q)];
      const double *R = points.basis(q, spline::value);
      const spline::Tensor<1, 3> value = mass_per_area * points.weight(q) * values(q);
      for (unsigned int a = 0; a < element.n_functions(); ++a)
        result[element.control_points[a]] += R[a] * value;
    }
    return result;
  }
} // namespace semilunar::shell
