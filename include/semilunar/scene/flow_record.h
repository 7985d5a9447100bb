// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_scene_flow_record_h
#define semilunar_scene_flow_record_h

#include <semilunar/core/run_context.h>
#include <semilunar/flow/flow_solver.h>
#include <semilunar/output/cross_section.h>
#include <semilunar/output/flow_probe.h>
#include <semilunar/output/time_series.h>
#include <semilunar/scene/flow_scene_parameters.h>

namespace semilunar::scene
{
  /// The time series of a flow scene, and the quantities read off it.
  template <int dim>
  class FlowRecord
  {
  public:
    /// @throws InputError for names that do not exist
    /// @param resume go on with the file of an earlier run; go_on() must follow
    /// @param more columns, after those of the flow
    FlowRecord(const std::filesystem::path &folder, const FlowRecordParameters &parameters,
               const mesh::Mesh<dim> &mesh, bool resume,
               const std::vector<output::TimeSeries::Column> &more = {});

    /// Locate sections and probes: at first, and whenever the mesh has changed or moved.
    /// @throws InputError for probes outside of the mesh
    void reinit(const output::FlowState<dim> &state);

    /// Add a row. Collective.
    /// @param more values, one for each of the additional columns
    void add(const flow::StepReport &report, flow::FlowSolver<dim> &solver,
             const output::FlowState<dim> &state, const std::vector<double> &more = {});

    /// The last value of each column, peaks, oscillations and the flow balance. @throws InputError for peaks of
    /// columns that do not exist
    void add_quantities(RunResults &results) const;

    /// Before the record is saved, after it was restored: how long the file is. Collective.
    void remember_size() { series_size = series->size(); }
    void go_on() { series->go_on_at(series_size); }
    template <class Archive>
    void serialize(Archive &archive, const unsigned int /*version*/)
    {
      for (Column &column : columns)
        archive &column.values;
      archive &last_imbalance &largest_imbalance &largest_flow_rate &series_size;
    }

  private:
    struct Column
    {
      output::TimeSeries::Column title;
      std::vector<double> values{};
    };
    struct NamedProbe
    {
      std::string name;
      output::FlowProbe<dim> probe;
    };

    void declare(const std::string &name, const std::string &unit)
    {
      columns.push_back({{name, unit}});
    }
    void declare_columns();
    /// @throws InputError naming the entry in which the name stands
    const Column &find(const std::string &name, const std::string &entry) const;
    /// Of the lumen against what flowed in and out since the first step.
    double largest_volume_error() const;
    void add_peak(const std::string &name, double sign, RunResults &results) const;
    void add_oscillation(const std::string &name, RunResults &results) const;

    const FlowRecordParameters parameters;
    const mesh::BoundaryIds boundary_ids; ///< of the lumen
    std::vector<dealii::types::boundary_id> force_ids;
    std::vector<output::CrossSection<dim>> sections;
    std::vector<NamedProbe> probes;
    /// Name and the two probes.
    std::vector<std::pair<std::string, std::array<std::size_t, 2>>> differences;
    std::vector<Column> columns;
    double last_imbalance = 0., largest_imbalance = 0., largest_flow_rate = 0.;
    std::unique_ptr<output::TimeSeries> series;
    std::uintmax_t series_size = 0; ///< when it was saved, on the first rank
  };
} // namespace semilunar::scene

#endif
