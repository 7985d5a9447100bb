// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_scene_immersed_shell_h
#define semilunar_scene_immersed_shell_h

#include <semilunar/coupling/parameters.h>
#include <semilunar/output/surface_vtu.h>
#include <semilunar/scene/flow_scene_parameters.h>
#include <semilunar/scene/scene.h>
#include <semilunar/scene/shell_model.h>
#include <semilunar/scene/surface_source.h>

namespace semilunar::scene
{
  /// All entries of a shell in a flow.
  struct ImmersedShellParameters
  {
    FlowSceneParameters flow;
    SurfaceSource source;
    shell::SectionParameters section;
    shell::SupportParameters supports;
    shell::ContactParameters contact;
    coupling::Parameters coupling;

    bool rigid = false;             ///< the surface does not move
    double foundation = 0.;         ///< [dyn/cm^3]
    std::string load = "(0, 0, 0)"; ///< expressions in x, y, z, t [dyn/cm^2]
    double initial_multiplier = 0.; ///< [dyn/cm^2]
    std::string exact_displacement, exact_velocity;
    std::string probes;
    output::SurfaceVtuParameters vtu;

    void add_parameters(dealii::ParameterHandler &prm);
    void check() const;
  };

  /// A shell of any shape, or a rigid surface, in a flow of any kind: both move each other.
  class ImmersedShell : public Scene
  {
  public:
    void add_parameters(dealii::ParameterHandler &prm) override { parameters.add_parameters(prm); }
    std::string finer() const override
    {
      return "Mesh/Refinements + 1; Surface/Elements * 2; Time/Step / 2";
    }
    bool can_restart() const override { return true; }
    void check() const override { parameters.check(); }
    void run(RunContext &context) override;

  private:
    ImmersedShellParameters parameters;
  };
} // namespace semilunar::scene

#endif
