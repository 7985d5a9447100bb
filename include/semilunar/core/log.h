// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_core_log_h
#define semilunar_core_log_h

#include <chrono>
#include <iosfwd>
#include <string>

namespace semilunar
{
  /// What the program tells the user while it runs. Only the first MPI rank speaks.
  class Log
  {
  public:
    /// To standard output. @param quiet say nothing
    explicit Log(bool quiet);
    /// To any stream, as on a terminal or not.
    Log(std::ostream &out, bool terminal);
    ~Log();

    /// A line of its own.
    void line(const std::string &text);

    /// How much of a task is done (0 to 1), with an estimate of the time left: on a terminal one
    /// line that is rewritten, elsewhere at most one line in progress_interval seconds. The clock
    /// of a task starts with its first call; the call with fraction >= 1 ends it.
    void progress(const std::string &task, double fraction);

    static constexpr double progress_interval = 10.;

  private:
    using Clock = std::chrono::steady_clock;

    void clear_progress();

    std::ostream *out; ///< nullptr: silent
    bool terminal;
    std::string current_task;
    bool progress_shown = false;
    Clock::time_point task_start, last_progress;
  };

  /// "12 s", "3 min 20 s", "2 h 05 min"
  std::string duration(double seconds);
} // namespace semilunar

#endif
