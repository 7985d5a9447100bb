// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_scene_valve_dynamics_h
#define semilunar_scene_valve_dynamics_h

#include <semilunar/scene/dynamic_analysis.h>
#include <semilunar/scene/scene.h>
#include <semilunar/scene/valve_source.h>

namespace semilunar::scene
{
  /// The leaflets of a valve design, opening and closing under a transvalvular pressure; the blood
  /// is a pressure and a damping traction.
  class ValveDynamics : public Scene
  {
  public:
    void add_parameters(dealii::ParameterHandler &prm) override;
    std::string finer() const override
    {
      return "Valve/Elements along * 2; Valve/Elements across * 2; Time/Step / 2";
    }
    bool can_restart() const override { return true; }
    void check() const override;
    void run(RunContext &context) override;

  private:
    ValveSource source;
    DynamicAnalysis analysis;
    TimeTableParameters pressure;

    TimeTable pressure_table() const;
  };
} // namespace semilunar::scene

#endif
