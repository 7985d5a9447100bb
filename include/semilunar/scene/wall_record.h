// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_scene_wall_record_h
#define semilunar_scene_wall_record_h

#include <semilunar/flow/flow_solver.h>
#include <semilunar/mesh/mesh.h>
#include <semilunar/output/time_series.h>
#include <semilunar/scene/flow_scene_parameters.h>

namespace semilunar::scene
{
  /// What a flow scene records of its elastic wall.
  template <int dim>
  class WallRecord
  {
  public:
    /// @param is_held whether a stent holds the wall
    /// @throws InputError for probes that are none
    WallRecord(const FlowRecordParameters &parameters, const mesh::Mesh<dim> &mesh,
               bool is_held = false);

    std::vector<output::TimeSeries::Column> columns() const;
    /// Values of the columns before the first step: forces, which a step gives, are 0. Collective.
    std::vector<double> row_at_rest(flow::FlowSolver<dim> &solver) const;
    /// After a step. Collective.
    std::vector<double> row(const flow::StepReport &report, flow::FlowSolver<dim> &solver) const;

  private:
    struct Probe
    {
      std::string name;
      dealii::Point<dim> position;
    };

    /// Displacement of the wall's node next to a point at rest.
    dealii::Tensor<1, dim> displacement(const Probe &probe,
                                        const flow::FlowSolver<dim> &solver) const;

    double lumen_volume(flow::FlowSolver<dim> &solver) const;
    double largest_displacement(const flow::FlowSolver<dim> &solver) const;

    const double force_scale;
    const bool is_held;
    std::vector<dealii::types::boundary_id> force_ids;
    std::vector<Probe> probes;
  };
} // namespace semilunar::scene

#endif
