// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_scene_valve_fsi_h
#define semilunar_scene_valve_fsi_h

#include <semilunar/core/checkpoint.h>
#include <semilunar/coupling/parameters.h>
#include <semilunar/coupling/refinement_near_points.h>
#include <semilunar/flow/parameters.h>
#include <semilunar/flow/wall_parameters.h>
#include <semilunar/mesh/parameters.h>
#include <semilunar/output/flow_vtu.h>
#include <semilunar/output/surface_vtu.h>
#include <semilunar/scene/flow_boundaries.h>
#include <semilunar/scene/scene.h>
#include <semilunar/scene/shell_model.h>
#include <semilunar/scene/valve_source.h>

#include <array>

namespace semilunar::scene
{
  /// All entries of a valve in flowing blood.
  struct ValveFsiParameters
  {
    ValveSource source;
    bool has_stent = true;
    shell::SectionParameters section;
    shell::SupportParameters supports;
    shell::ContactParameters contact;
    mesh::MeshParameters mesh;
    flow::Parameters flow;
    flow::WallParameters wall;
    double held_wall = 0.1;  ///< [cm]
    std::string wall_probes; ///< places at rest
    FlowBoundaries boundaries;
    coupling::Parameters coupling;
    coupling::RefinementParameters refinement;
    CheckpointParameters checkpoints;

    double initial_pressure = 80.;                        ///< [mmHg]
    double end = 0.86, step = 5e-4, smallest_step = 1e-6; ///< [s]

    output::SurfaceVtuParameters shell_vtu;
    output::FlowVtuParameters flow_vtu;
    double shell_interval = 0.;                ///< between files of the leaflets [s]
    double series_interval = 0.;               ///< between rows of the time series [s]
    std::array<double, 2> sections{{-1., 3.}}; ///< z before and behind the valve [cm]

    void add_parameters(dealii::ParameterHandler &prm);
    void check() const;
  };

  /// A valve in an artery with rigid or elastic walls: leaflets, stent and blood move each other.
  class ValveFsi : public Scene
  {
  public:
    void add_parameters(dealii::ParameterHandler &prm) override { parameters.add_parameters(prm); }
    std::string finer() const override
    {
      return "Mesh/Artery/Cells around * 2; Valve/Elements along * 2; Valve/Elements across * 2; "
             "Time/Step / 2";
    }
    bool can_restart() const override { return true; }
    void check() const override { parameters.check(); }
    void run(RunContext &context) override;

  private:
    ValveFsiParameters parameters;
  };
} // namespace semilunar::scene

#endif
