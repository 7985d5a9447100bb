// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Tables over time: interpolation, derivatives, periods, and what is refused.

#include <semilunar/core/exceptions.h>
#include <semilunar/core/time_table.h>

#include "../tests.h"

using namespace semilunar;
using tests::check;
using tests::log;

namespace
{
  using Interpolation = TimeTable::Interpolation;

  /// Transvalvular pressure of a cycle [s, mmHg].
  const std::string cycle =
      "0: 0, .02:12, .10: 6, .20: 1, .24: -8, .28: -40, .32: -80, .36: -95, .50: -98, "
      ".65: -88, .78: -80, .83: -45, .86: 0";

  TimeTable make(const std::string &values, const std::string &interpolation, const bool periodic)
  {
    TimeTableParameters parameters;
    parameters.values = values;
    parameters.interpolation = interpolation;
    parameters.periodic = periodic;
    return TimeTable(parameters, "Loads/Pressure table");
  }

  void linear()
  {
    const TimeTable table = make(cycle, "linear", true);
    log() << "linear " << table.value(0.01) << ' ' << table.value(0.22) << ' '
          << table.derivative(0.22) << ' ' << table.derivative(0.02) << std::endl;
    check("a period later", table.value(0.22 + 5 * 0.86) - table.value(0.22), 1e-12);
    check("a period before", table.value(0.22 - 0.86) - table.value(0.22), 1e-12);
    check("the end is the start", table.value(0.86), 0.);
    log() << "corners " << table.next_corner(0.) << ' ' << table.next_corner(0.05) << ' '
          << table.next_corner(0.84) << ' ' << table.next_corner(0.86 + 0.05) << std::endl;
    const TimeTable once = make("1: 2, 3: 6", "linear", false);
    log() << "once " << once.value(0.) << ' ' << once.value(2.) << ' ' << once.value(3.) << ' '
          << once.value(9.) << ' ' << once.derivative(0.) << ' ' << once.derivative(1.) << ' '
          << once.derivative(3.) << ' ' << once.next_corner(0.) << ' ' << once.next_corner(1.)
          << ' ' << once.next_corner(3.) << std::endl;
    log() << "constant " << TimeTable(7.).value(3.) << ' ' << TimeTable(7.).derivative(3.) << ' '
          << make("4: 5", "monotone cubic", false).value(8.) << std::endl;
  }

  /// Interpolates, has the derivative it says, is smooth, and stays between neighboring values.
  void monotone()
  {
    for (const bool periodic : {false, true})
    {
      const TimeTable table = make(cycle, "monotone cubic", periodic);
      const auto &points = table.points();
      double missed = 0., wrong_slope = 0., jump = 0., overshoot = 0.;
      for (std::size_t i = 0; i + 1 < points.size(); ++i)
      {
        const auto &[t0, v0] = points[i];
        const auto &[t1, v1] = points[i + 1];
        missed = std::max(missed, std::abs(table.value(t0) - v0));
        if (i > 0)
          jump = std::max(jump, std::abs(table.derivative(t0 - 1e-9) - table.derivative(t0)));
        for (double s = 0.01; s < 1.; s += 0.01)
        {
          const double t = t0 + s * (t1 - t0), d = 1e-6;
          const double difference = (table.value(t + d) - table.value(t - d)) / (2. * d);
          wrong_slope = std::max(wrong_slope, std::abs(difference - table.derivative(t)));
          overshoot = std::max(
              {overshoot, table.value(t) - std::max(v0, v1), std::min(v0, v1) - table.value(t)});
        }
      }
      check("misses a point by", missed, 1e-12);
      check("derivative against differences, of 1000 mmHg/s", wrong_slope / 1e3, 1e-6);
      check("jump of the derivative, of 1000 mmHg/s", jump / 1e3, 1e-6);
      check("overshoot", overshoot, 1e-12);
      log() << "slope at the start " << table.derivative(0.) << std::endl;
    }
    const TimeTable table = make(cycle, "monotone cubic", true);
    check("smooth over the period", table.derivative(0.86 - 1e-10) - table.derivative(0.86), 1e-4);
  }

  /// Third order in smooth data (Steffen: second order at extrema; here there are none).
  void order()
  {
    double last = 0.;
    for (const unsigned int n : {16, 32, 64})
    {
      TimeTable::Points points;
      for (unsigned int i = 0; i <= n; ++i)
        points.emplace_back(double(i) / n, std::exp(double(i) / n));
      const TimeTable table(points, Interpolation::monotone_cubic, false, "");
      double error = 0.;
      for (double t = 0.; t < 1.; t += 1e-3)
        error = std::max(error, std::abs(table.value(t) - std::exp(t)));
      if (last > 0.)
        check("order 3 short of", std::max(0., 3. - std::log2(last / error)), 0.1);
      last = error;
    }
  }

  void from_file()
  {
    std::ofstream("table.csv") << "time [s], p [mmHg]\n0, 1 # start\n\n# nothing\n0.5, 3\n";
    TimeTableParameters parameters;
    parameters.file = "table.csv";
    log() << "file " << TimeTable(parameters, "Inflow").value(0.25) << std::endl;
  }

  template <typename Make>
  void refuse(const Make &make)
  {
    try
    {
      make();
      log() << "not refused" << std::endl;
    }
    catch (const InputError &error)
    {
      log() << error.what() << std::endl;
    }
  }

  void refusals()
  {
    for (const std::string values :
         {"", "0: 1, 1", "0: 1, 1: 2x", "0: 1, 0: 2", "1: 1, 0: 2", "0: 1, 1: nan", "0: 1, 1: 2,"})
      refuse([&] { make(values, "linear", false); });
    refuse([] { make("0: 1, 1: 2", "linear", true); });
    refuse([] { make("0: 1", "linear", true); });
    TimeTableParameters parameters;
    parameters.file = "no.csv";
    refuse([&] { TimeTable(parameters, "Inflow"); });
    std::ofstream("bad.csv") << "0, 1\n1; 2\n";
    parameters.file = "bad.csv";
    refuse([&] { TimeTable(parameters, "Inflow"); });
    parameters.values = "0: 1";
    refuse([&] { TimeTable(parameters, "Inflow"); });
  }
} // namespace

int main()
{
  linear();
  monotone();
  order();
  from_file();
  refusals();
}
