// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/log.h>

#include <deal.II/base/mpi.h>

#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <iostream>

namespace semilunar
{
  namespace
  {
    double seconds_since(const std::chrono::steady_clock::time_point &start)
    {
      return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }

    std::string two_digits(const long number)
    {
      return (number < 10 ? "0" : "") + std::to_string(number);
    }
  } // namespace

  Log::Log(const bool quiet)
      : out(quiet || dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0 ? nullptr
                                                                                   : &std::cout),
        terminal(isatty(fileno(stdout)) != 0)
  {
  }

  Log::Log(std::ostream &out, const bool terminal) : out(&out), terminal(terminal) {}

  Log::~Log()
  {
    clear_progress();
  }

  void Log::line(const std::string &text)
  {
    if (out == nullptr)
      return;
    clear_progress();
    *out << text << std::endl;
  }

  void Log::progress(const std::string &task, const double fraction)
  {
    if (out == nullptr)
      return;
    if (task != current_task)
    {
      current_task = task;
      task_start = last_progress = Clock::now();
    }
    if (fraction >= 1.)
    {
      clear_progress();
      current_task.clear();
      return;
    }
    const double minimal_interval = terminal ? 0.1 : progress_interval;
    if (seconds_since(last_progress) < minimal_interval)
      return;
    last_progress = Clock::now();
    std::string text = task + ": " + std::to_string(std::lround(100. * fraction)) + " %";
    if (fraction > 0.)
      text += ", " + duration(seconds_since(task_start) * (1. - fraction) / fraction) + " left";
    clear_progress();
    *out << text << (terminal ? "" : "\n") << std::flush;
    progress_shown = terminal;
  }

  void Log::clear_progress()
  {
    if (progress_shown)
      *out << "\r\033[K" << std::flush; // back to the first column, erase to the end of the line
    progress_shown = false;
  }

  std::string duration(const double seconds)
  {
    const long s = std::lround(seconds);
    if (s < 60)
      return std::to_string(s) + " s";
    if (s < 3600)
      return std::to_string(s / 60) + " min " + two_digits(s % 60) + " s";
    return std::to_string(s / 3600) + " h " + two_digits(s / 60 % 60) + " min";
  }
} // namespace semilunar
