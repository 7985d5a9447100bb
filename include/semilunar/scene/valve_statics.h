// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_scene_valve_statics_h
#define semilunar_scene_valve_statics_h

#include <semilunar/scene/adaptivity.h>
#include <semilunar/scene/scene.h>
#include <semilunar/scene/static_analysis.h>
#include <semilunar/scene/valve_source.h>

namespace semilunar::scene
{
  /// The leaflets of a valve design under static pressure, touching each other.
  class ValveStatics : public Scene
  {
  public:
    void add_parameters(dealii::ParameterHandler &prm) override;
    std::string finer() const override
    {
      return "Valve/Elements along * 2; Valve/Elements across * 2";
    }
    void check() const override;
    void run(RunContext &context) override;

  private:
    ValveSource source;
    StaticAnalysis analysis;
    AdaptivityParameters adaptivity;

    void add_quantities(ShellModel &model, const shell::ControlVectors &x,
                        RunResults &results) const;
  };
} // namespace semilunar::scene

#endif
