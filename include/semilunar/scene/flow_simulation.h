// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_scene_flow_simulation_h
#define semilunar_scene_flow_simulation_h

#include <semilunar/core/run_context.h>
#include <semilunar/output/velocity_dofs.h>
#include <semilunar/scene/flow_record.h>

#include <deal.II/fe/mapping_q.h>

namespace semilunar::scene
{
  /// A flow from its start to its end, with all output.
  template <int dim>
  class FlowSimulation
  {
  public:
    FlowSimulation(const FlowSceneParameters &parameters, RunContext &context);

    /// @throws InputError, NumericsError
    void run();

  private:
    std::unique_ptr<flow::FlowSolver<dim>> make_solver();
    void initialise();
    void report_size() const;
    /// A step of at most this size, smaller if steps are controlled and it fails.
    flow::StepReport step(double dt);
    /// After a step: rows, files.
    void finish_step(const flow::StepReport &report);
    void write();
    /// Relative change of the velocity within a unit of time.
    double rate_of_change(double dt);
    void add_quantities();
    output::FlowState<dim> state() const;
    std::string describe(const flow::StepReport &report) const;

    const FlowSceneParameters &prm;
    RunContext &context;
    const VectorField<dim> exact_velocity; ///< empty if there is none
    const std::unique_ptr<mesh::Mesh<dim>> mesh;
    const flow::BoundaryConditions<dim> conditions;
    const dealii::MappingQ<dim> mapping;
    const std::unique_ptr<flow::FlowSolver<dim>> solver;
    std::unique_ptr<output::VelocityDofs<dim>> velocity_dofs;
    FlowRecord<dim> record;
    output::FlowVtu<dim> files;
    output::FlowVector last_velocity;
    std::string last_file;
    double last_dt = 0., next_output = 0.;
  };
} // namespace semilunar::scene

#endif
