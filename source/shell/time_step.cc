// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/shell/time_step.h>

#include <cmath>
#include <limits>

namespace semilunar::shell
{
  using Vector = NonlinearSystem::Vector;

  GeneralizedAlpha::GeneralizedAlpha(const double rho)
      : alpha_m((2. * rho - 1.) / (rho + 1.)), alpha_f(rho / (rho + 1.)),
        beta(0.25 * (1. - alpha_m + alpha_f) * (1. - alpha_m + alpha_f)),
        gamma(0.5 - alpha_m + alpha_f)
  {
  }

  double GeneralizedAlpha::error_constant() const
  {
    return std::abs(1. / 6. - beta - 0.5 * (alpha_f - alpha_m));
  }

  TimeStep::TimeStep(Equilibrium &equilibrium, const Equations &equations, const Mass &mass,
                     const GeneralizedAlpha &method, const double damping_rate,
                     const TimeTable &load_factor)
      : equations(equations), mass(mass), method(method), damping_rate(damping_rate),
        equilibrium(equilibrium), load_factor(load_factor)
  {
  }

  void TimeStep::begin(const Motion &motion, const double length)
  {
    start = &motion;
    dt = length;
    load_of_step = load_factor.value(motion.time + (1. - method.alpha_f) * dt);
    equilibrium.begin_step(equilibrium.positions(start->u, load_of_step), 1. - method.alpha_f,
                           method.conserves_energy());
  }

  Vector TimeStep::acceleration(const Vector &w) const
  {
    Vector a = w;
    a -= start->u;
    a *= 1. / ((1. - method.alpha_f) * method.beta * dt * dt);
    a.add(-1. / (method.beta * dt), start->v, 1. - 0.5 / method.beta, start->a);
    return a;
  }

  Vector TimeStep::velocity(const Vector &end_acceleration) const
  {
    Vector v = start->v;
    v.add((1. - method.gamma) * dt, start->a, method.gamma * dt, end_acceleration);
    return v;
  }

  Motion TimeStep::end(const Vector &w) const
  {
    Motion motion;
    motion.time = start->time + dt;
    motion.u = start->u;
    motion.u.sadd(1. - 1. / (1. - method.alpha_f), 1. / (1. - method.alpha_f), w);
    motion.a = acceleration(w);
    motion.v = velocity(motion.a);
    return motion;
  }

  Vector TimeStep::from_end(const Vector &u_end) const
  {
    Vector w = start->u;
    w.sadd(method.alpha_f, 1. - method.alpha_f, u_end);
    return w;
  }

  double TimeStep::residual(const Vector &w, double, Vector &r)
  {
    const double static_scale = equilibrium.residual(w, load_of_step, r);
    const double static_norm = r.l2_norm();
    Vector a = acceleration(w), v = velocity(a), inertia;
    a.sadd(1. - method.alpha_m, method.alpha_m, start->a);
    v.sadd(1. - method.alpha_f, method.alpha_f, start->v);
    a.add(damping_rate, v);
    mass.multiply(equations, a, inertia);
    r += inertia;
    return std::max({std::abs(load_of_step) * static_scale, static_norm, inertia.l2_norm(),
                     std::numeric_limits<double>::min()});
  }

  double TimeStep::inertia_coefficient() const
  {
    return ((1. - method.alpha_m) / (method.beta * dt * dt) +
            damping_rate * (1. - method.alpha_f) * method.gamma / (method.beta * dt)) /
           (1. - method.alpha_f);
  }

  void TimeStep::linearize(const Vector &w, double, const double shift)
  {
    equilibrium.linearize(w, load_of_step,
                          [&](SparseSystem &tangent)
                          {
                            mass.add_to(tangent, inertia_coefficient());
                            if (shift > 0.)
                              tangent.add_diagonal(lumped_area(), shift);
                          });
  }

  void TimeStep::load_derivative(const Vector &w, double, Vector &derivative)
  {
    equilibrium.load_derivative(w, load_of_step, derivative);
  }

  double TimeStep::largest_change() const
  {
    return (1. - method.alpha_f) * equilibrium.largest_change();
  }

  Vector TimeStep::initial_acceleration(const Motion &motion)
  {
    Vector forces, momentum, a;
    equilibrium.residual(motion.u, load_factor.value(motion.time), forces);
    mass.multiply(equations, motion.v, momentum);
    forces.sadd(-1., -damping_rate, momentum);
    mass.solve(equations, forces, a);
    return a;
  }

  double TimeStep::error_estimate(const Motion &from, const Motion &to) const
  {
    Vector change = to.a, error;
    change -= from.a;
    change *= method.error_constant() * dt * dt * inertia_coefficient();
    mass.multiply(equations, change, error);
    equilibrium.solve(error);
    return error.linfty_norm();
  }

  TimeStep::Work TimeStep::work(const Vector &w)
  {
    Vector forces, external, momentum;
    equilibrium.residual(w, load_of_step, forces);
    equations.restrict(
        equilibrium.external_forces(equilibrium.positions(w, load_of_step), load_of_step),
        external);
    Vector du = w;
    du -= start->u;
    du *= 1. / (1. - method.alpha_f);
    Vector a = acceleration(w), v = velocity(a);
    a.sadd(1. - method.alpha_m, method.alpha_m, start->a);
    v.sadd(1. - method.alpha_f, method.alpha_f, start->v);

    Work result;
    result.external = external * du;
    result.internal = forces * du + result.external;
    mass.multiply(equations, a, momentum);
    result.inertia = momentum * du;
    mass.multiply(equations, v, momentum);
    result.viscous = damping_rate * (momentum * du);
    return result;
  }
} // namespace semilunar::shell
