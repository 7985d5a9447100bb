// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Mean, amplitude and frequency of series that are known.
#include <semilunar/output/oscillation.h>

#include <cmath>

#include "../tests.h"

using namespace semilunar;

/// Values of a function with steps of 0.01 up to an end.
output::Oscillation of(const std::function<double(double)> &function, const double end)
{
  std::vector<double> times, values;
  for (unsigned int i = 0; 0.01 * i <= end; ++i)
  {
    times.push_back(0.01 * i);
    values.push_back(function(times.back()));
  }
  return output::last_oscillation(times, values);
}

int main()
{
  constexpr double pi = 3.14159265358979323846, f = 1.3;
  const auto wave = [](const double t, const double n = 1.)
  { return std::sin(2. * pi * n * f * t); };

  const auto pure = of([&](const double t) { return 3. + 2. * wave(t); }, 10.);
  tests::check("sine: mean", pure.mean - 3., 1e-5);
  tests::check("sine: amplitude", pure.amplitude - 2., 1e-5);
  tests::check("sine: frequency", pure.frequency - f, 1e-4);
  tests::check("sine: change", pure.amplitude_change, 1e-5);

  // max and min of sin a + b cos 2a are at a = 90 and 270 degrees for small b.
  const auto two =
      of([&](const double t) { return wave(t) + 0.2 * std::cos(4. * pi * f * t); }, 10.);
  tests::check("second harmonic: mean", two.mean + 0.2, 1e-4);
  tests::check("second harmonic: amplitude", two.amplitude - 1., 1e-4);
  tests::check("second harmonic: frequency", two.frequency - f, 1e-4);

  // Every second period is a smaller one: max and min of b sin a - cos 2a are at a = 90 degrees and
  // where sin a = -b / 4.
  const auto unlike =
      of([&](const double t) { return 0.4 * wave(t) - std::cos(4. * pi * f * t); }, 10.);
  tests::check("unlike periods: mean", unlike.mean - 0.5 * (1.4 - 1.02), 1e-4);
  tests::check("unlike periods: amplitude", unlike.amplitude - 0.5 * (1.4 + 1.02), 1e-4);
  tests::check("unlike periods: frequency", unlike.frequency / (2. * f) - 1., 1e-2);
  tests::check("unlike periods: change", unlike.amplitude_change, 1e-4);

  // A start with another mean that dies out, and ripple around the mean.
  const auto start =
      of([&](const double t) { return 5. * std::exp(-t) + (1. - std::exp(-t)) * wave(t); }, 12.);
  tests::check("start: amplitude", start.amplitude - 1., 1e-3);
  tests::check("start: frequency", start.frequency - f, 1e-3);
  const auto ripple = of([&](const double t) { return wave(t) + 0.05 * wave(t, 15.); }, 10.);
  tests::check("ripple: frequency", ripple.frequency / f - 1., 5e-3);

  // A damped swing: the amplitude falls by exp(-0.1 / f) a period.
  const auto damped = of([&](const double t) { return std::exp(-0.1 * t) * wave(t); }, 10.);
  tests::check("damped: change", damped.amplitude_change / (std::exp(-0.1 / f) - 1.) - 1., 1e-2);

  const auto once = of([&](const double t) { return wave(t); }, 2.);
  tests::check("too few periods", std::isnan(once.mean) ? 0. : 1., 0.);
  const auto still = of([](const double) { return 1.; }, 10.);
  tests::check("no oscillation", std::isnan(still.frequency) ? 0. : 1., 0.);
}
