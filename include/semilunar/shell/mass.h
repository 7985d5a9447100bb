// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_shell_mass_h
#define semilunar_shell_mass_h

#include <semilunar/shell/assembly.h>
#include <semilunar/shell/sparse_system.h>

namespace semilunar::shell
{
  /// The consistent mass matrix of a shell, (D2) of doc/theory/dynamics.md: one scalar matrix on
  /// the control points for each of the three components.
  class Mass
  {
  public:
    /// The surface must outlive the object.
    /// @param mass_per_area density times thickness, per undeformed area
    Mass(const spline::Surface &surface, const QuadraturePoints &points, double mass_per_area);

    double per_area() const { return mass_per_area; }
    double total() const { return total_mass; }

    /// Momentum of each control point, M v.
    ControlVectors momentum(const ControlVectors &velocities) const;
    /// The same for the equations: components without an equation do not move.
    void multiply(const Equations &equations, const dealii::Vector<double> &velocities,
                  dealii::Vector<double> &momentum) const;
    /// Solve M x = right-hand side among the equations, by conjugate gradients.
    /// @throws NumericsError if they do not converge
    void solve(const Equations &equations, const dealii::Vector<double> &right_hand_side,
               dealii::Vector<double> &x) const;
    void add_to(SparseSystem &matrix, double factor) const;

    /// Integral of the mass times functions times values at the quadrature points.
    ControlVectors load(const std::function<spline::Tensor<1, 3>(unsigned int q)> &values) const;

  private:
    const spline::Surface &surface;
    const QuadraturePoints &points;
    const double mass_per_area;
    double total_mass = 0.;
    std::vector<std::vector<double>> blocks; // of each element: n x n, row by row
  };
} // namespace semilunar::shell

#endif
