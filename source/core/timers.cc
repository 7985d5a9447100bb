// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/timers.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/timer.h>
#include <deal.II/base/utilities.h>

#include <malloc.h>
#include <sys/resource.h>

#include <chrono>
#include <fstream>
#include <iostream>

namespace semilunar
{
  namespace
  {
    struct Usage
    {
      double cpu_seconds, peak_memory_mib;
    };

    Usage process_usage()
    {
      rusage usage;
      getrusage(RUSAGE_SELF, &usage);
      const auto seconds = [](const timeval &t) { return t.tv_sec + 1e-6 * t.tv_usec; };
      constexpr double kib_per_mib = 1024.; // Linux counts ru_maxrss in KiB
      return {seconds(usage.ru_utime) + seconds(usage.ru_stime), usage.ru_maxrss / kib_per_mib};
    }

    /// The peak of a run must not be that of a larger one before it in the same process. Linux lets
    /// a process reset its own; where that fails, the peak is that of the process.
    void forget_peak_memory()
    {
      malloc_trim(0);
      std::ofstream("/proc/self/clear_refs") << "5";
    }
  } // namespace

  struct Timers::Implementation
  {
    dealii::TimerOutput phases{std::cout, dealii::TimerOutput::never,
                               dealii::TimerOutput::wall_times};
    std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
    double cpu_start = process_usage().cpu_seconds;
  };

  Timers::Scope::Scope(Timers &timers, const std::string &phase) : timers(timers), phase(phase)
  {
    timers.implementation->phases.enter_subsection(phase);
  }

  Timers::Scope::~Scope()
  {
    timers.implementation->phases.leave_subsection(phase);
  }

  Timers::Timers() : implementation(std::make_unique<Implementation>())
  {
    forget_peak_memory();
  }

  Timers::~Timers() = default;

  std::map<std::string, double> Timers::seconds() const
  {
    return implementation->phases.get_summary_data(dealii::TimerOutput::total_wall_time);
  }

  Cost Timers::cost() const
  {
    const std::chrono::duration<double> wall =
        std::chrono::steady_clock::now() - implementation->start;
    const Usage usage = process_usage();
    Cost cost;
    cost.wall_seconds = wall.count();
    cost.cpu_seconds =
        dealii::Utilities::MPI::sum(usage.cpu_seconds - implementation->cpu_start, MPI_COMM_WORLD);
    cost.peak_memory_mib = dealii::Utilities::MPI::sum(usage.peak_memory_mib, MPI_COMM_WORLD);
    return cost;
  }
} // namespace semilunar
