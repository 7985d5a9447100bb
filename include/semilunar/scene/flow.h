// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_scene_flow_h
#define semilunar_scene_flow_h

#include <semilunar/scene/flow_scene_parameters.h>
#include <semilunar/scene/scene.h>

namespace semilunar::scene
{
  /// Blood flow through a mesh that is at rest or moves as given, in two or three dimensions.
  class Flow : public Scene
  {
  public:
    void add_parameters(dealii::ParameterHandler &prm) override;
    std::string finer() const override;
    bool can_restart() const override { return true; }
    void check() const override;
    void run(RunContext &context) override;

  private:
    FlowSceneParameters parameters;
  };
} // namespace semilunar::scene

#endif
