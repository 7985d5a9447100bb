// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_scene_shell_statics_h
#define semilunar_scene_shell_statics_h

#include <semilunar/scene/scene.h>
#include <semilunar/scene/static_analysis.h>
#include <semilunar/scene/surface_source.h>

namespace semilunar::scene
{
  /// Any shell under static loads.
  class ShellStatics : public Scene
  {
  public:
    void add_parameters(dealii::ParameterHandler &prm) override;
    std::string finer() const override { return "Surface/Elements * 2"; }
    void run(RunContext &context) override;

  private:
    SurfaceSource source;
    StaticAnalysis analysis;
  };
} // namespace semilunar::scene

#endif
