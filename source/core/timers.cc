// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/timers.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/timer.h>
#include <deal.II/base/utilities.h>

#include <sys/resource.h>

#include <chrono>
#include <iostream>

namespace semilunar
{
  struct Timers::Implementation
  {
    dealii::TimerOutput phases{std::cout, dealii::TimerOutput::never,
                               dealii::TimerOutput::wall_times};
    std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
  };

  Timers::Scope::Scope(Timers &timers, const std::string &phase) : timers(timers), phase(phase)
  {
    timers.implementation->phases.enter_subsection(phase);
  }

  Timers::Scope::~Scope()
  {
    timers.implementation->phases.leave_subsection(phase);
  }

  Timers::Timers() : implementation(std::make_unique<Implementation>()) {}

  Timers::~Timers() = default;

  std::map<std::string, double> Timers::seconds() const
  {
    return implementation->phases.get_summary_data(dealii::TimerOutput::total_wall_time);
  }

  Cost Timers::cost() const
  {
    const std::chrono::duration<double> wall =
        std::chrono::steady_clock::now() - implementation->start;
    rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval &t) { return t.tv_sec + 1e-6 * t.tv_usec; };
    constexpr double kib_per_mib = 1024.; // Linux counts ru_maxrss in KiB
    Cost cost;
    cost.wall_seconds = wall.count();
    cost.cpu_seconds = dealii::Utilities::MPI::sum(
        seconds(usage.ru_utime) + seconds(usage.ru_stime), MPI_COMM_WORLD);
    cost.peak_memory_mib =
        dealii::Utilities::MPI::sum(usage.ru_maxrss / kib_per_mib, MPI_COMM_WORLD);
    return cost;
  }
} // namespace semilunar
