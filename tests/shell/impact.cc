// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Contact during motion: the mean pressure of a step, and two sheets that collide so fast that they
// touch for a few steps only: energy and momenta.

#include "../tests.h"
#include "dynamic_cases.h"

using namespace semilunar;
using namespace semilunar::tests;

namespace
{
  void mean_pressure()
  {
    const ContactPressure law{3e7, 0.01};
    double worst = 0., worst_slope = 0.;
    for (const double from : {-0.05, -1e-9, 0.004, 0.01, 0.05})
      for (const double way : {-0.06, -0.003, -1e-8, 1e-8, 1e-3, 0.02, 0.1})
      {
        const double to = from + way;
        constexpr unsigned int n = 20000;
        double sum = 0.;
        for (unsigned int i = 0; i < n; ++i)
          sum += law.value(from + way * (i + 0.5) / n) / n;
        worst = std::max(worst, std::abs(law.mean(from, to) - sum) / 3e5);
        const double d = 1e-2 * std::abs(way);
        const double quotient = (law.mean(from, to + d) - law.mean(from, to - d)) / (2. * d);
        worst_slope = std::max(worst_slope, std::abs(law.mean_slope(from, to) - quotient) / 3e7);
      }
    check("mean pressure against its integral", worst, 1e-6);
    check("its slope against differences", worst_slope, 1e-3);
  }

  /// Two equal sheets; the upper one is shifted and comes down. Largest gain and loss of energy
  /// relative to all of it, and whether both have bounced in the end.
  void collide(const double spectral_radius, const double dt, const double bound_gain,
               const double bound_loss)
  {
    constexpr double distance = 0.3, speed = 100.;
    Surface surface = plate(1., 1., {{3, 3}}, {{3, 3}});
    append(surface,
           refined(spline::quadrilateral(
                       {{Point<3>(0.05, 0.02, distance), Point<3>(1.05, 0.02, distance),
                         Point<3>(0.05, 1.02, distance), Point<3>(1.05, 1.02, distance)}}),
                   {{3, 3}}, {{3, 3}}),
           -1.);
    TimeIntegratorParameters time;
    time.step = dt;
    time.end_time = 1.;
    time.spectral_radius = spectral_radius;
    time.tolerance = 1e-9;
    time.max_iterations = 40;
    Surroundings around{""};
    around.contact.enabled = true;
    around.contact.distance = 0.06;
    around.contact.stiffness = 1e7;
    around.contact.smoothing = 0.005;
    MovingShell shell(surface, section_of(1e6, 0.3, 0.05), around, time);
    shell.start([](const auto &) { return Tensor<1, 3>(); },
                [&](const auto &x) {
                  return Tensor<1, 3>({0., 0., x[2] < 0.5 * distance ? speed : -speed});
                });
    const TimeIntegrator &integrator = shell.integrator;
    const double energy = shell.integrator.energy_balance().kinetic;
    const auto spin = integrator.angular_momentum();
    const double scale = shell.mass.total() * speed;
    double gain = 0., loss = 0., momentum = 0., turned = 0., touched = 0., imbalance = 0.;
    while (integrator.time() < 3e-3)
    {
      shell.integrator.advance(3e-3, [] { return false; });
      const EnergyBalance b = shell.integrator.energy_balance();
      gain = std::max(gain, (b.kinetic + b.strain + b.contact) / energy - 1.);
      loss = std::max(loss, 1. - (b.kinetic + b.strain + b.contact) / energy);
      touched = std::max(touched, b.contact / energy);
      imbalance = std::max(imbalance, std::abs(b.error) / energy);
      momentum = std::max(momentum, integrator.momentum().norm() / scale);
      turned = std::max(turned, (integrator.angular_momentum() - spin).norm() / scale);
    }
    log() << "rho " << spectral_radius << ", step " << dt << ": touched "
          << (touched > 0.01 ? "hard" : "hardly") << std::endl;
    check("gain of energy", gain, bound_gain);
    check("loss of energy", loss, bound_loss);
    check("balance", imbalance, 1e-7);
    check("momentum", momentum, 1e-12);
    if (spectral_radius == 1.)
      check("angular momentum", turned, 1e-9);
    const ControlVectors x = integrator.positions();
    double height[2] = {0., 0.}; // means over the control points
    for (unsigned int c = 0; c < x.size(); ++c)
      height[c < x.size() / 2 ? 0 : 1] += x[c][2] / (x.size() / 2);
    log() << "apart again: " << (height[0] < height[1]) << std::endl;
  }
} // namespace

int main()
{
  mean_pressure();
  collide(1., 2e-4, 0.01, 0.01);
  collide(1., 5e-5, 0.002, 0.002);
  collide(0., 5e-5, 1e-3, 0.8);
}
