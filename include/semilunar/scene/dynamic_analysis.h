// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_scene_dynamic_analysis_h
#define semilunar_scene_dynamic_analysis_h

#include <semilunar/core/checkpoint.h>
#include <semilunar/core/run_context.h>
#include <semilunar/output/surface_vtu.h>
#include <semilunar/output/time_series.h>
#include <semilunar/scene/shell_model.h>
#include <semilunar/shell/time_integrator.h>

namespace semilunar::scene
{
  /// What a scene watches in a moving shell besides what all shells have.
  class MotionObserver
  {
  public:
    virtual ~MotionObserver() = default;
    /// Columns of the time series, and their values at a time.
    virtual std::vector<output::TimeSeries::Column> columns() const { return {}; }
    virtual std::vector<double> row(double /*time*/, const shell::ControlVectors & /*x*/)
    {
      return {};
    }
    /// The parts of its state that a checkpoint needs.
    virtual void add_to(Checkpoints &) {}
  };

  /// The motion of a shell, whatever the surface: time steps, files, energies, checkpoints.
  struct DynamicAnalysis
  {
    ShellParameters shell;
    shell::TimeIntegratorParameters time;
    CheckpointParameters checkpoints;
    output::SurfaceVtuParameters vtu;
    std::string initial_velocity = "0; 0; 0";
    std::string probes;
    double series_interval = 0., vtu_interval = 0.;

    /// Declare all entries but those of the section Loads.
    void add_parameters(dealii::ParameterHandler &prm);
    void check() const;

    /// Report the size of the model; unless this is a dry run, move it to the end time and add the
    /// general quantities of a moving shell.
    /// @param load_factor over time, of all loads
    /// @throws NumericsError naming the last good state
    void run(ShellModel &model, const TimeTable &load_factor, RunContext &context,
             MotionObserver &observer) const;
  };
} // namespace semilunar::scene

#endif
