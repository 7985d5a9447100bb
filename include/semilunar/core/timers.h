// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_core_timers_h
#define semilunar_core_timers_h

#include <map>
#include <memory>
#include <string>

namespace semilunar
{
  /// What a run has cost so far.
  struct Cost
  {
    double wall_seconds = 0.;
    double cpu_seconds = 0.;     ///< all threads of all ranks
    double peak_memory_mib = 0.; ///< largest resident memory, summed over the ranks
  };

  /// Wall time of the phases of a run, by name (deal.II's TimerOutput behind a light header).
  class Timers
  {
  public:
    /// Phase that lasts as long as this object. Phases with different names may be nested; each
    /// counts its own time, including what happens inside.
    class Scope
    {
    public:
      Scope(Timers &timers, const std::string &phase);
      ~Scope();
      Scope(const Scope &) = delete;
      Scope &operator=(const Scope &) = delete;

    private:
      Timers &timers;
      const std::string phase;
    };

    Timers();
    ~Timers();

    /// Seconds by phase.
    std::map<std::string, double> seconds() const;

    /// Since the construction of this object; memory includes what the process kept from before.
    /// Collective: all ranks call it.
    Cost cost() const;

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation;
  };
} // namespace semilunar

#endif
