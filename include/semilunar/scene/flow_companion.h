// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_scene_flow_companion_h
#define semilunar_scene_flow_companion_h

#include <semilunar/core/checkpoint.h>
#include <semilunar/core/log.h>
#include <semilunar/core/run_context.h>
#include <semilunar/flow/flow_solver.h>
#include <semilunar/mesh/mesh.h>
#include <semilunar/output/time_series.h>

#include <functional>
#include <memory>
#include <vector>

namespace semilunar::scene
{
  /// What takes part in a flow besides the blood: it makes the steps together with it and has
  /// results of its own.
  template <int dim>
  class FlowCompanion
  {
  public:
    virtual ~FlowCompanion() = default;

    virtual void report_size(Log &log) const = 0;
    virtual unsigned int n_unknowns() const = 0;
    /// A step of both. @throws NumericsError; then the state is that before the step
    virtual flow::StepReport advance(double dt) = 0;
    /// Columns of the time series, and their values at the end of the last step. Collective.
    virtual std::vector<output::TimeSeries::Column> columns() const = 0;
    virtual std::vector<double> row() = 0;
    /// Write the state. Collective.
    virtual void write(double time) = 0;
    virtual void add_quantities(RunResults &results) const = 0;
    /// What a checkpoint must have in common with it, in words.
    virtual std::string fit() const = 0;
    /// Tell checkpoints about the state; that of the flow is told afterwards.
    virtual void add_to(Checkpoints &checkpoints) = 0;
    /// From here on everything depends on what checkpoints hold alone, bit for bit: to be called
    /// after one was written or restored, and when the mesh has changed. Collective.
    virtual void forget_history() = 0;
  };

  /// Makes a companion of a flow that has not begun.
  template <int dim>
  using MakeCompanion = std::function<std::unique_ptr<FlowCompanion<dim>>(
      flow::FlowSolver<dim> &flow, const mesh::Mesh<dim> &mesh)>;
} // namespace semilunar::scene

#endif
