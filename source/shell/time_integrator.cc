// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/core/parameters.h>
#include <semilunar/shell/time_integrator.h>

#include <cmath>
#include <limits>

namespace semilunar::shell
{
  using Vector = NonlinearSystem::Vector;

  namespace
  {
    /// A step shorter than the distance to the next stop by less than this, relative, goes there.
    constexpr double rounding = 1e-9;
    /// Step control: the aim as a share of the tolerance, and how much a step may change at a time.
    /// Steps that could grow by less than the last stay as they are: their tangent can be kept.
    constexpr double safety = 0.9, smallest_factor = 0.3, largest_factor = 2.,
                     worthwhile_factor = 1.2;
    /// Steps are chosen so that, at the velocity of their start, nothing moves further than this
    /// share of what contact can follow.
    constexpr double share_of_reach = 0.8;
    /// After a step that failed and was halved, fixed steps grow back by this factor at a time.
    constexpr double regrowth_factor = 1.5;
    /// The error of a step is of the third order in its length.
    constexpr double error_order = 3.;

    const Equations &check_motion(const Equations &equations, const Mass &mass)
    {
      if (!(mass.per_area() > 0.))
        throw InputError("Shell/Density", std::to_string(mass.per_area()),
                         "a shell without mass has no motion", "give a positive density");
      if (equations.moves_supports())
        throw InputError("Supports/Supports", "move", "supports cannot move in time yet",
                         "hold them with fix, and move the shell by loads");
      return equations;
    }
  } // namespace

  void TimeIntegratorParameters::add_parameters(dealii::ParameterHandler &prm)
  {
    using namespace dealii;
    prm.enter_subsection("Time");
    prm.add_parameter("End time", end_time, "The run ends here [time].", positive_number());
    prm.add_parameter("Step", step, "Time step, the first one if they adapt [time].",
                      positive_number());
    prm.add_parameter("Adaptive", adaptive,
                      "Choose steps by their error. Otherwise they keep their length, but for "
                      "steps that fail and are repeated with half of it.");
    prm.add_parameter("Error tolerance", error_tolerance,
                      "Largest estimated error of the displacements in one adaptive step [length].",
                      positive_number());
    prm.add_parameter("Largest step", largest_step,
                      "Adaptive steps grow up to this; 0: up to Step [time].",
                      Patterns::Double(0.));
    prm.add_parameter("Smallest step", smallest_step, "The run gives up below this [time].",
                      positive_number());
    prm.add_parameter("Spectral radius", spectral_radius,
                      "rho_infinity of the generalised-alpha method: share of the fastest "
                      "oscillations that a step leaves. 1: none is damped (implicit midpoint "
                      "rule), 0: they vanish at once.",
                      Patterns::Double(0., 1.));
    prm.leave_subsection();
    prm.enter_subsection("Shell");
    prm.add_parameter("Damping", damping,
                      "Viscous traction per velocity, on the undeformed area "
                      "[mass/(area time), g/(cm^2 s)].",
                      Patterns::Double(0.));
    prm.leave_subsection();
    prm.enter_subsection("Solver");
    prm.add_parameter("Tolerance", tolerance,
                      "Norm of the residual relative to that of the forces of the step.",
                      Patterns::Double(1e-14, 1e-2));
    prm.add_parameter("Iterations", max_iterations, "Newton iterations per step at most.",
                      Patterns::Integer(1));
    prm.leave_subsection();
  }

  void TimeIntegratorParameters::check() const
  {
    if (largest_step > 0. && largest_step < step)
      throw InputError("Time/Largest step", std::to_string(largest_step),
                       "the largest step is shorter than the first one",
                       "make it at least as long as Step, or 0");
    if (smallest_step > step)
      throw InputError("Time/Smallest step", std::to_string(smallest_step),
                       "the smallest step is longer than the first one",
                       "make it shorter than Step");
  }

  TimeIntegrator::TimeIntegrator(Equilibrium &equilibrium, const Equations &equations,
                                 const Mass &mass, Contact *const contact,
                                 const TimeTable &load_factor,
                                 const TimeIntegratorParameters &parameters)
      : equilibrium(equilibrium), equations(check_motion(equations, mass)), mass(mass),
        contact(contact), load_factor(load_factor), parameters(parameters),
        system(equilibrium, equations, mass, GeneralizedAlpha(parameters.spectral_radius),
               parameters.damping / mass.per_area(), this->load_factor),
        next_step(parameters.step)
  {
    parameters.check();
  }

  void TimeIntegrator::start(const Vector &u, const Vector &v)
  {
    now.time = 0.;
    now.u = u;
    now.v = v;
    now.a = system.initial_acceleration(now);
    equilibrium.accept(now.u, load_factor.value(0.));
    sums = Sums();
    const EnergyBalance balance = energy_balance();
    sums.start_energy = balance.kinetic + balance.strain + balance.contact;
  }

  double TimeIntegrator::step_towards(const double stop) const
  {
    const double left = stop - now.time;
    // a step in which something would move further than contact can follow will fail
    const double followed = share_of_reach * equilibrium.largest_change() / now.v.linfty_norm();
    const double step = std::min(next_step, std::max(followed, parameters.smallest_step));
    if (step >= left * (1. - rounding))
      return left;
    // not a long step and then a tiny one
    return parameters.adaptive && step > 0.5 * left ? 0.5 * left : step;
  }

  /// Guess of the step's unknown: the velocity goes on, unless contact cannot follow so far.
  Vector TimeIntegrator::predict(const double dt) const
  {
    Vector end = now.u;
    if (dt * now.v.linfty_norm() < equilibrium.largest_change())
      end.add(dt, now.v);
    return system.from_end(end);
  }

  TimeStepReport TimeIntegrator::advance(const double next_stop,
                                         const std::function<bool()> &interrupted)
  {
    if (has_forgotten())
    {
      newton.forget_tangent();
      equilibrium.forget_history();
    }
    double stop = std::min(next_stop, parameters.end_time);
    if (parameters.end_time - stop < rounding * parameters.step)
      stop = parameters.end_time; // no step that is nothing but rounding
    if (parameters.adaptive)
      stop = std::min(stop, load_factor.next_corner(now.time * (1. + rounding)));
    TimeStepReport report{steps + 1, 0., 0, 0, 0., std::nan("")};
    for (;; ++report.rejections)
    {
      const double dt = step_towards(stop);
      system.begin(now, dt);
      Vector w = predict(dt);
      const IterationResult result = newton.solve(
          system, now.u, w,
          {parameters.tolerance, parameters.max_iterations, interrupted, [](double) {}});
      report.iterations += result.iterations;
      if (result.converged)
      {
        Motion end = system.end(w);
        if (dt == stop - now.time)
          end.time = stop; // without rounding
        if (parameters.adaptive)
          report.error = system.error_estimate(now, end);
        if (!parameters.adaptive || report.error <= parameters.error_tolerance)
        {
          report.dt = dt;
          report.residual = result.residual;
          accept(w, end);
          choose_next_step(dt, report.error);
          return report;
        }
        choose_next_step(dt, report.error);
      }
      else
        next_step = 0.5 * dt;
      newton.forget_tangent();
      system.finish();
      if (next_step < parameters.smallest_step || interrupted())
        throw NumericsError("the time step fell below its bound: " +
                                (result.converged ? "its error is too large" : result.failure),
                            "time " + std::to_string(now.time), "");
    }
  }

  void TimeIntegrator::choose_next_step(const double dt, const double error)
  {
    if (!parameters.adaptive)
    {
      next_step = std::min(parameters.step, std::max(regrowth_factor * dt, next_step));
      return;
    }
    const double bound = parameters.step_bound();
    const double factor =
        std::clamp(safety * std::pow(parameters.error_tolerance / error, 1. / error_order),
                   smallest_factor, largest_factor);
    if (error > parameters.error_tolerance)
      next_step = factor * dt;
    else if (factor * dt > worthwhile_factor * next_step || factor * dt < next_step)
      next_step = std::min(bound, std::max(factor, 0.5) * dt);
  }

  void TimeIntegrator::accept(const Vector &w, const Motion &end)
  {
    const TimeStep::Work work = system.work(w);
    sums.inertia += work.inertia;
    sums.internal += work.internal;
    sums.external += work.external;
    sums.viscous += work.viscous;
    system.finish();
    now = end;
    ++steps;
    equilibrium.accept(now.u, 1.);
  }

  ControlVectors TimeIntegrator::positions() const
  {
    return equilibrium.positions(now.u, 1.);
  }

  ControlVectors TimeIntegrator::velocities() const
  {
    ControlVectors v;
    equations.expand(now.v, 0., v);
    return v;
  }

  double TimeIntegrator::kinetic_energy() const
  {
    Vector momentum;
    mass.multiply(equations, now.v, momentum);
    return 0.5 * (momentum * now.v);
  }

  EnergyBalance TimeIntegrator::energy_balance()
  {
    Vector forces;
    equilibrium.residual(now.u, 1., forces);
    EnergyBalance balance{};
    balance.kinetic = kinetic_energy();
    balance.strain = equilibrium.strain_energy();
    balance.contact = contact == nullptr ? 0. : contact->energy();
    balance.work_in = sums.external;
    balance.damped = sums.viscous;
    const double gained = balance.kinetic + balance.strain + balance.contact - sums.start_energy;
    balance.numerical = sums.inertia + sums.internal - gained;
    balance.error = gained + balance.damped + balance.numerical - balance.work_in;
    return balance;
  }

  spline::Tensor<1, 3> TimeIntegrator::momentum() const
  {
    spline::Tensor<1, 3> sum;
    for (const auto &p : mass.momentum(velocities()))
      sum += p;
    return sum;
  }

  spline::Tensor<1, 3> TimeIntegrator::angular_momentum() const
  {
    const ControlVectors x = positions(), p = mass.momentum(velocities());
    spline::Tensor<1, 3> sum;
    for (unsigned int c = 0; c < x.size(); ++c)
      sum += cross_product_3d(x[c], p[c]);
    return sum;
  }
} // namespace semilunar::shell
