// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Names, durations, progress, timers and interrupts.

#include <semilunar/core/interrupt.h>
#include <semilunar/core/log.h>
#include <semilunar/core/nearest_name.h>
#include <semilunar/core/timers.h>

#include <deal.II/base/mpi.h>

#include <chrono>
#include <csignal>
#include <regex>
#include <sstream>
#include <thread>

#include "../tests.h"

using namespace semilunar;
using tests::log;

namespace
{
  void wait(const double seconds)
  {
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
  }

  void names()
  {
    const std::vector<std::string> known = {"Thickness", "Degree", "Source"};
    log() << nearest_name("thicknes", known) << ' ' << nearest_name("Dgeree", known) << ' '
          << nearest_name("Viscosity", known) << '.' << std::endl
          << suggest("Surce", known) << std::endl
          << suggest("Viscosity", known) << std::endl;
  }

  void progress()
  {
    for (const double seconds : {0.4, 59.4, 61., 3599., 7500.})
      log() << duration(seconds) << std::endl;
    std::ostringstream terminal, file;
    for (std::ostringstream *out : {&terminal, &file})
    {
      Log messages(*out, out == &terminal);
      messages.progress("load", 0.);
      wait(0.15);
      messages.progress("load", 0.5);
      messages.line("step 1");
      wait(0.15);
      messages.progress("load", 0.75);
      messages.progress("load", 1.);
    }
    log() << "file: " << file.str() << "terminal: ";
    // how long the waits really took is not for the reference
    const std::string shown =
        std::regex_replace(terminal.str(), std::regex("[0-9]+ s left"), "# s left");
    for (const char c : shown)
      c < ' ' ? log() << '<' << static_cast<int>(c) << '>' : log() << c;
    log() << std::endl;
  }

  void timers()
  {
    Timers timers;
    {
      const Timers::Scope outer(timers, "solve");
      const Timers::Scope inner(timers, "assembly");
      wait(0.05);
    }
    wait(0.05);
    const auto seconds = timers.seconds();
    const Cost cost = timers.cost();
    log() << "phases: " << seconds.size() << ", assembly within solve: "
          << (seconds.at("assembly") >= 0.05 && seconds.at("solve") >= seconds.at("assembly"))
          << ", wall includes all: " << (cost.wall_seconds >= 0.1)
          << ", memory plausible: " << (cost.peak_memory_mib > 1. && cost.peak_memory_mib < 1e4)
          << std::endl;
  }

  void interrupts()
  {
    catch_interrupts();
    log() << "interrupted: " << interrupted();
    std::raise(SIGTERM);
    log() << ", after a signal: " << interrupted() << std::endl;
  }
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  names();
  progress();
  timers();
  interrupts();
}
