// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_scene_shell_dynamics_h
#define semilunar_scene_shell_dynamics_h

#include <semilunar/scene/dynamic_analysis.h>
#include <semilunar/scene/scene.h>
#include <semilunar/scene/surface_source.h>

namespace semilunar::scene
{
  /// Any shell in motion.
  class ShellDynamics : public Scene
  {
  public:
    void add_parameters(dealii::ParameterHandler &prm) override;
    std::string finer() const override { return "Surface/Elements * 2; Time/Step / 2"; }
    bool can_restart() const override { return true; }
    void check() const override;
    void run(RunContext &context) override;

  private:
    SurfaceSource source;
    DynamicAnalysis analysis;
    TimeTableParameters load_factor;

    TimeTable load_table() const;
  };
} // namespace semilunar::scene

#endif
