// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_scene_fsi_simulation_h
#define semilunar_scene_fsi_simulation_h

#include <semilunar/scene/fsi_record.h>

namespace semilunar::scene
{
  /// A run of a valve in flowing blood: steps, their control, and checkpoints.
  class FsiSimulation
  {
  public:
    FsiSimulation(const ValveFsiParameters &parameters, RunContext &context);

    /// @throws InputError, NumericsError
    void run();

  private:
    const ValveFsiParameters &prm;
    RunContext &context;
    ValveInBlood valve;
    std::unique_ptr<FsiRecord> record;        ///< null on a dry run
    std::unique_ptr<Checkpoints> checkpoints; ///< null on a dry run
    double next_dt;                           ///< [s]

    void prepare_record();
    void go_on();
    bool at_end() const;
    coupling::CoupledReport step();
    void save_if_due();
  };
} // namespace semilunar::scene

#endif
