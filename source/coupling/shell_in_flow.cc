// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/coupling/shell_in_flow.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace semilunar::coupling
{
  using Vector = shell::NonlinearSystem::Vector;
  using dealii::Tensor;
  using shell::ControlVectors;

  namespace
  {
    Tensor<1, 3> sum_up(const double *basis, const std::vector<unsigned int> &control_points,
                        const ControlVectors &x)
    {
      Tensor<1, 3> sum;
      for (unsigned int a = 0; a < control_points.size(); ++a)
        sum += basis[a] * x[control_points[a]];
      return sum;
    }
  } // namespace

  SurfacePoints surface_points(const spline::Surface &surface,
                               const shell::QuadraturePoints &points, const ControlVectors &x)
  {
    const unsigned int n = points.n_points();
    SurfacePoints result{std::vector<Tensor<1, 3>>(n), std::vector<Tensor<1, 3>>(n),
                         std::vector<double>(n)};
    for (unsigned int q = 0; q < n; ++q)
    {
      const auto &control_points = surface.elements[points.element(q)].control_points;
      const auto evaluate = [&](const spline::Derivative derivative)
      { return sum_up(points.basis(q, derivative), control_points, x); };
      result.positions[q] = evaluate(spline::value);
      const Tensor<1, 3> normal = cross_product_3d(evaluate(spline::d1), evaluate(spline::d2));
      const double stretch = normal.norm();
      result.normals[q] = normal / stretch;
      result.areas[q] = stretch * points.weight(q);
    }
    return result;
  }

  unsigned int n_points_per_direction(const spline::Surface &surface, const double spacing)
  {
    // Of the largest element: one side of a square of its area.
    const shell::QuadraturePoints gauss(surface);
    double largest = 0.;
    for (unsigned int e = 0; e < surface.elements.size(); ++e)
    {
      double area = 0.;
      for (unsigned int q = gauss.first_point(e); q < gauss.first_point(e + 1); ++q)
        area += gauss.weight(q);
      largest = std::max(largest, std::sqrt(area));
    }
    constexpr unsigned int fewest = 2;
    return std::max(fewest, static_cast<unsigned int>(std::ceil(largest / spacing)));
  }

  ShellInFlow::ShellInFlow(const spline::Surface &surface, const shell::QuadraturePoints &points,
                           const shell::Equations &equations, shell::Equilibrium &equilibrium,
                           const shell::Mass &mass)
      : surface(surface), points(&points), equations(equations), equilibrium(equilibrium),
        mass(mass), u(equations.n_equations()), u_old(u), v(u), v_old(u), u_history(u),
        v_history(u), given_forces(u), loads(u)
  {
  }

  void ShellInFlow::set_state(const State &state)
  {
    u = state.u;
    u_old = state.u_old;
    v = state.v;
    v_old = state.v_old;
  }

  void ShellInFlow::start_step(const flow::Bdf &new_bdf)
  {
    bdf = new_bdf;
    u_history.equ(bdf.alpha[1], u);
    u_history.add(bdf.alpha[2], u_old);
    v_history.equ(bdf.alpha[1], v);
    v_history.add(bdf.alpha[2], v_old);
  }

  Vector ShellInFlow::predict() const
  {
    // The velocity extrapolated as the fluid's is, then the displacement that belongs to it.
    Vector y = v;
    y.add(bdf.extrapolation, v, -bdf.extrapolation, v_old);
    y -= u_history;
    y *= 1. / bdf.alpha[0];
    return y;
  }

  Vector ShellInFlow::velocity(const Vector &y) const
  {
    Vector result = u_history;
    result.add(bdf.alpha[0], y);
    return result;
  }

  void ShellInFlow::set_penalties(std::vector<Tensor<2, 3>> new_penalties)
  {
    AssertDimension(new_penalties.size(), points->n_points());
    penalties = std::move(new_penalties);
  }

  void ShellInFlow::set_forces(const ControlVectors &forces)
  {
    equations.restrict(forces, given_forces);
  }

  void ShellInFlow::accept_step(const Vector &y)
  {
    std::swap(v, v_old);
    v = velocity(y);
    u_old = u;
    u = y;
    equilibrium.accept(y, 0.);
  }

  double ShellInFlow::kinetic_energy() const
  {
    Vector momentum;
    mass.multiply(equations, v, momentum);
    return 0.5 * (v * momentum);
  }

  Tensor<1, 3> ShellInFlow::momentum_rate(const Vector &y) const
  {
    Vector acceleration = v_history;
    acceleration.add(bdf.alpha[0], velocity(y));
    Tensor<1, 3> sum;
    for (const Tensor<1, 3> &momentum : mass.momentum(expand(acceleration)))
      sum += momentum;
    return sum;
  }

  ControlVectors ShellInFlow::expand(const Vector &vector) const
  {
    ControlVectors result;
    equations.expand(vector, 0., result);
    return result;
  }

  Tensor<1, 3> ShellInFlow::at_point(const unsigned int q, const ControlVectors &vectors) const
  {
    return sum_up(points->basis(q, spline::value),
                  surface.elements[points->element(q)].control_points, vectors);
  }

  void ShellInFlow::add_force(const unsigned int q, const Tensor<1, 3> &force,
                              ControlVectors &forces) const
  {
    const auto &control_points = surface.elements[points->element(q)].control_points;
    const double *basis = points->basis(q, spline::value);
    for (unsigned int a = 0; a < control_points.size(); ++a)
      forces[control_points[a]] += basis[a] * force;
  }

  double ShellInFlow::residual(const Vector &y, double, Vector &r)
  {
    equilibrium.residual(y, 0., r);
    const double internal = r.l2_norm();
    const Vector velocity_now = velocity(y);
    Vector acceleration = v_history, inertia;
    acceleration.add(bdf.alpha[0], velocity_now, foundation / mass.per_area(), y);
    mass.multiply(equations, acceleration, inertia);
    r += inertia;
    r -= loads;

    const ControlVectors velocities = expand(velocity_now);
    ControlVectors drag(surface.control_points.size());
    for (unsigned int q = 0; q < points->n_points(); ++q)
      add_force(q, penalties[q] * at_point(q, velocities), drag);
    equations.restrict(drag, fluid_force);
    fluid_force.sadd(-1., 1., given_forces);
    r -= fluid_force;
    return std::max({internal, inertia.l2_norm(), fluid_force.l2_norm(), loads.l2_norm(),
                     std::numeric_limits<double>::min()});
  }

  void ShellInFlow::add_penalty(shell::SparseSystem &tangent, const double factor) const
  {
    std::vector<double> block;
    for (unsigned int e = 0; e < surface.elements.size(); ++e)
    {
      const auto &control_points = surface.elements[e].control_points;
      const unsigned int n = control_points.size(), stride = 3 * n;
      block.assign(stride * stride, 0.);
      for (unsigned int q = points->first_point(e); q < points->first_point(e + 1); ++q)
      {
        const double *R = points->basis(q, spline::value);
        const Tensor<2, 3> K = factor * penalties[q];
        for (unsigned int a = 0; a < n; ++a)
          for (unsigned int i = 0; i < 3; ++i)
          {
            double *const row = &block[(3 * a + i) * stride];
            const double k0 = R[a] * K[i][0], k1 = R[a] * K[i][1], k2 = R[a] * K[i][2];
            for (unsigned int b = 0; b < n; ++b)
            {
              row[3 * b] += k0 * R[b];
              row[3 * b + 1] += k1 * R[b];
              row[3 * b + 2] += k2 * R[b];
            }
          }
      }
      tangent.add(control_points, block.data());
    }
  }

  void ShellInFlow::linearize(const Vector &y, double, const double shift)
  {
    equilibrium.linearize(y, 0.,
                          [&](shell::SparseSystem &tangent)
                          {
                            mass.add_to(tangent,
                                        bdf.alpha[0] * bdf.alpha[0] + foundation / mass.per_area());
                            add_penalty(tangent, bdf.alpha[0]);
                            if (shift > 0.)
                              tangent.add_diagonal(lumped_area(), shift);
                          });
  }

  void ShellInFlow::load_derivative(const Vector &, double, Vector &derivative)
  {
    derivative.reinit(n_unknowns()); // no load depends on the load factor
  }
} // namespace semilunar::coupling
