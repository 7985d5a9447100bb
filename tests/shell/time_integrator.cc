// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Generalised-alpha: coefficients, order, damping, frequencies of plates, step control.

#include <semilunar/core/exceptions.h>

#include "../tests.h"
#include "dynamic_cases.h"

using namespace semilunar;
using namespace semilunar::tests;

namespace
{
  const auto at_rest = [](const Tensor<1, 3> &) { return Tensor<1, 3>(); };
  const auto never = [] { return false; };

  TimeIntegratorParameters steps(const double dt, const double spectral_radius)
  {
    TimeIntegratorParameters time;
    time.step = dt;
    time.end_time = 1e3;
    time.spectral_radius = spectral_radius;
    time.tolerance = 1e-10;
    return time;
  }

  /// Chung and Hulbert's conditions: second order; all roots at infinity -rho.
  void coefficients()
  {
    for (const double rho : {0., 0.5, 0.9, 1.})
    {
      const GeneralizedAlpha c(rho);
      const double shift = c.alpha_f - c.alpha_m;
      check("second order", c.gamma - 0.5 - shift, 1e-15);
      check("simple root at infinity", c.alpha_f / (c.alpha_f - 1.) + rho, 1e-15);
      check("double root at infinity", (shift - 1.) / (shift + 1.) + rho, 1e-15);
      check("which is double", c.beta - 0.25 * (1. + shift) * (1. + shift), 1e-15);
    }
  }

  /// A free plate, pushed by a dead load against the viscous traction: the exact velocity is
  /// q / c (1 - exp(-c t / (rho h))).
  void free_push(const double spectral_radius)
  {
    constexpr double thickness = 0.1, load = 3., damping = 0.8, end = 0.2;
    double last = 0.;
    for (const double dt : {0.02, 0.01, 0.005})
    {
      TimeIntegratorParameters time = steps(dt, spectral_radius);
      time.damping = damping;
      Surroundings around{""};
      around.area_load[2] = load;
      MovingShell shell(plate(1., 1., {{2, 2}}, {{2, 2}}), section_of(1e4, 0.3, thickness), around,
                        time);
      shell.start(at_rest, at_rest);
      shell.run_to(end);
      const double rate = damping / thickness;
      const double velocity = load / damping * (1. - std::exp(-rate * end));
      const double path = load / damping * (end - (1. - std::exp(-rate * end)) / rate);
      const double error = std::abs(shell.integrator.velocities()[0][2] - velocity) / velocity +
                           std::abs(shell.integrator.positions()[0][2] - path) / path;
      if (last > 0.)
        check("order 2, short by", std::max(0., 2. - std::log2(last / error)), 0.1);
      last = error;
      const EnergyBalance balance = shell.integrator.energy_balance();
      check("work of the load", balance.work_in / (load * path) - 1., 0.03);
      check("balance", balance.error / balance.work_in, 1e-9);
    }
    log() << "rho " << spectral_radius << ": error of the last " << std::setprecision(3) << last
          << std::setprecision(8) << std::endl;
  }

  /// Circular frequency of a plate that starts with a velocity, from the n-th zero of the mean
  /// displacement, without the method's own lengthening of the period (D9).
  double frequency(const std::string &supports, const double dt, const unsigned int n_zeros,
                   const unsigned int n_elements, const Velocity &mode)
  {
    MovingShell shell(plate(1., 1., {{3, 3}}, {{n_elements, n_elements}}),
                      section_of(1e5, 0.3, 0.01), {supports}, steps(dt, 1.));
    shell.start(at_rest, [&](const auto &x) { return 1e-5 * mode(x); });
    const ControlVectors start = shell.integrator.positions();
    ControlVectors shape;
    shell.equations.expand(shell.project(mode), 0., shape);
    shape = shell.mass.momentum(shape);
    double before = 0.;
    for (unsigned int zeros = 0;;)
    {
      shell.integrator.advance(1e3, never);
      const double now = dot(shape, sum(shell.integrator.positions(), -1., start));
      zeros += before * now < 0. ? 1 : 0;
      if (zeros == n_zeros)
      {
        const double time = shell.integrator.time() - dt * now / (now - before);
        return 2. / dt * std::tan(0.5 * dt * M_PI * n_zeros / time);
      }
      before = now;
    }
  }

  void plates()
  {
    const double D = 1e5 * 1e-6 / (12. * (1. - 0.09)), unit = std::sqrt(D / 0.01);
    const std::string edges[] = {"left", "right", "bottom", "top"};
    std::string simple, clamped;
    for (const auto &edge : edges)
    {
      simple += "fix " + edge + " z; ";
      clamped += "clamp " + edge + "; ";
    }
    for (const auto &[m, n] : {std::pair<int, int>{1, 1}, {2, 1}, {2, 2}})
    {
      const double exact = M_PI * M_PI * (m * m + n * n) * unit;
      const double found = frequency(
          simple, 0.04 * 2. * M_PI / exact, 3, 8,
          [m = m, n = n](const auto &x) {
            return Tensor<1, 3>({0., 0., std::sin(m * M_PI * x[0]) * std::sin(n * M_PI * x[1])});
          });
      check("simply supported plate, frequency " + std::to_string(m) + std::to_string(n),
            found / exact - 1., 5e-4);
    }
    // A.W. Leissa, J. Sound Vib. 31 (1973) 257-293: lambda = omega a^2 sqrt(rho h / D) = 35.992
    const double exact = 35.992 * unit;
    const double found =
        frequency(clamped, 0.02 * 2. * M_PI / exact, 12, 8,
                  [](const auto &x)
                  {
                    const auto bump = [](const double s) { return s * s * (1. - s) * (1. - s); };
                    return Tensor<1, 3>({0., 0., bump(x[0]) * bump(x[1])});
                  });
    check("clamped plate, frequency", found / exact - 1., 5e-4);
  }

  /// Steps follow the tolerance: an eighth of it halves them, and quarters the error.
  void adaptive()
  {
    const auto run = [](const double tolerance, double &error)
    {
      TimeIntegratorParameters time = steps(1e-3, 0.5);
      time.adaptive = tolerance > 0.;
      time.error_tolerance = tolerance;
      time.largest_step = 1.;
      MovingShell shell(plate(1., 1., {{2, 2}}, {{2, 2}}), section_of(1e4, 0.3, 0.1),
                        {"", 2.,
                         TimeTable({{0., 0.}, {0.3, 1.}, {1., -2.}},
                                   TimeTable::Interpolation::linear, false, "")},
                        time);
      shell.start(at_rest, at_rest);
      shell.run_to(1.5);
      error = shell.integrator.positions()[0][2];
      return shell.integrator.n_steps();
    };
    double reference, coarse, fine;
    run(0., reference);
    const double n_coarse = run(8e-4, coarse), n_fine = run(1e-4, fine);
    // rounding decides over a step or two
    check("adaptive steps, about 50", n_coarse - 50., 3.);
    check("and about 91", n_fine - 91., 5.);
    check("twice as many", n_fine / n_coarse - 2., 0.5);
    log() << "errors within 5e-3 and 1.25e-3: " << (std::abs(coarse - reference) < 5e-3) << ' '
          << (std::abs(fine - reference) < 1.25e-3) << std::endl;
  }

  void refusals()
  {
    const auto refuse = [](const SectionParameters &section, const std::string &supports,
                           const TimeIntegratorParameters &time)
    {
      try
      {
        MovingShell shell(plate(1., 1., {{2, 2}}, {{2, 2}}), section, {supports}, time);
        shell.start(at_rest, [](const auto &x) { return 5. * x; });
        shell.run_to(1.);
        log() << "not refused" << std::endl;
      }
      catch (const std::runtime_error &error)
      {
        log() << error.what() << std::endl;
      }
    };
    SectionParameters section = section_of(1e4, 0.3, 0.1);
    TimeIntegratorParameters time = steps(0.1, 0.5);
    refuse(section, "clamp left; move right x 1", time);
    time.max_iterations = 1;
    time.smallest_step = 0.09;
    refuse(section, "", time);
    time.largest_step = 0.01;
    refuse(section, "", time);
    section.density = 0.;
    refuse(section, "", steps(0.1, 0.5));
  }
} // namespace

int main()
{
  coefficients();
  for (const double rho : {0., 0.5, 1.})
    free_push(rho);
  plates();
  adaptive();
  refusals();
}
