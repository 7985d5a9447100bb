// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_scene_flow_simulation_h
#define semilunar_scene_flow_simulation_h

#include <semilunar/core/run_context.h>
#include <semilunar/output/velocity_dofs.h>
#include <semilunar/scene/flow_companion.h>
#include <semilunar/scene/flow_record.h>
#include <semilunar/scene/wall_record.h>

#include <deal.II/fe/mapping_q.h>

namespace semilunar::scene
{
  /// A flow from its start to its end, with all output.
  template <int dim>
  class FlowSimulation
  {
  public:
    /// @param make_companion of what takes part besides the blood; empty if there is nothing
    FlowSimulation(const FlowSceneParameters &parameters, RunContext &context,
                   const MakeCompanion<dim> &make_companion = {});

    /// @throws InputError, NumericsError
    void run();

  private:
    std::unique_ptr<flow::FlowSolver<dim>> make_solver();
    /// What the wall and the companion record in addition.
    std::vector<output::TimeSeries::Column> more_columns() const;
    std::vector<double> more_values(const flow::StepReport &report);
    void initialise();
    void add_to(Checkpoints &checkpoints);
    void begin();
    void go_on();
    void save_if_due();
    bool at_end() const;
    /// The mesh has other cells now.
    void renew_dofs();
    void report_size() const;
    /// What cells are reported: those of the lumen, or of a solid alone.
    mesh::Material measured() const;
    /// A step of at most this size, smaller if steps are controlled and it fails.
    flow::StepReport step(double dt);
    double next_dt(double dt) const;
    /// After a step: rows, files, a new mesh.
    void finish_step(const flow::StepReport &report);
    void adapt_mesh();
    void write();
    /// Relative change of the velocity within a unit of time.
    double rate_of_change(double dt);
    void add_quantities();
    unsigned int n_unknowns() const;
    output::FlowState<dim> state() const;
    std::string describe(const flow::StepReport &report) const;

    const FlowSceneParameters &prm;
    RunContext &context;
    const VectorField<dim> exact_velocity; ///< empty if there is none
    const std::unique_ptr<mesh::Mesh<dim>> mesh;
    const flow::BoundaryConditions<dim> conditions;
    const dealii::MappingQ<dim> mapping;
    const std::unique_ptr<flow::FlowSolver<dim>> solver;
    const std::unique_ptr<FlowCompanion<dim>> companion; ///< null: there is only blood
    std::unique_ptr<WallRecord<dim>> wall;               ///< null: no wall is elastic
    std::unique_ptr<output::VelocityDofs<dim>> velocity_dofs;
    FlowRecord<dim> record;
    output::FlowVtu<dim> files;
    std::unique_ptr<Checkpoints> checkpoints; ///< null on a dry run
    output::FlowVector last_velocity;

    struct Progress
    {
      double dt, last_dt = 0., next_output = 0.; ///< next step, last step, time of the next file
      unsigned int n_steps = 0, n_nonlinear = 0;
      std::string last_file{};

      template <class Archive>
      void serialize(Archive &archive, const unsigned int /*version*/)
      {
        archive &dt &last_dt &next_output &n_steps &n_nonlinear &last_file;
      }
    } progress;
  };
} // namespace semilunar::scene

#endif
