// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_scene_flow_scene_parameters_h
#define semilunar_scene_flow_scene_parameters_h

#include <semilunar/core/checkpoint.h>
#include <semilunar/flow/parameters.h>
#include <semilunar/flow/wall_parameters.h>
#include <semilunar/mesh/parameters.h>
#include <semilunar/output/flow_vtu.h>
#include <semilunar/scene/flow_boundaries.h>

namespace semilunar::scene
{
  /// What a flow scene records.
  struct FlowRecordParameters
  {
    output::FlowVtuParameters vtu;
    std::string section_axis = "z";
    std::vector<double> sections; ///< positions along the axis [cm]
    std::vector<std::string> forces;
    double force_scale = 1.;
    std::string probes, pressure_differences, wall_probes;
    std::vector<std::string> peaks, oscillations;

    void add_parameters(dealii::ParameterHandler &prm);
  };

  /// All entries of a flow scene.
  struct FlowSceneParameters
  {
    unsigned int dimension = 3;
    mesh::MeshParameters mesh;
    mesh::AdaptivityParameters adaptivity;
    flow::Parameters flow;
    flow::WallParameters wall;
    FlowBoundaries boundaries;
    double end = 1., step = 1e-2; ///< [s]
    double steady_tolerance = 0.; ///< [1/s]
    Constants constants;
    std::string initial_velocity, body_force, exact_velocity, exact_pressure, displacement;
    FlowRecordParameters record;
    CheckpointParameters checkpoints;

    void add_parameters(dealii::ParameterHandler &prm);
    void check() const;
  };
} // namespace semilunar::scene

#endif
