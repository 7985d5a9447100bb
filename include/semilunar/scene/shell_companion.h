// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_scene_shell_companion_h
#define semilunar_scene_shell_companion_h

#include <semilunar/coupling/fluid_structure.h>
#include <semilunar/scene/flow_companion.h>
#include <semilunar/scene/immersed_shell.h>
#include <semilunar/scene/probes.h>
#include <semilunar/scene/shell_output.h>

namespace semilunar::scene
{
  /// A shell or a rigid surface that moves with the blood around it.
  class ShellCompanion : public FlowCompanion<3>
  {
  public:
    /// @throws InputError for a surface of which no point is in the mesh
    ShellCompanion(const ImmersedShellParameters &parameters, flow::FlowSolver<3> &flow,
                   const mesh::Mesh<3> &mesh, RunContext &context);

    void report_size(Log &log) const override;
    unsigned int n_unknowns() const override;
    flow::StepReport advance(double dt) override;
    std::vector<output::TimeSeries::Column> columns() const override;
    std::vector<double> row() override;
    void write(double time) override;
    void add_quantities(RunResults &results) const override;
    std::string fit() const override;
    void add_to(Checkpoints &checkpoints) override;
    void forget_history() override;

  private:
    /// What there is of a shell that can move.
    struct Moving
    {
      Moving(const ImmersedShellParameters &prm, const spline::Surface &surface,
             const shell::QuadraturePoints &points, Timers &timers);

      ShellModel model;
      shell::Mass mass;
      coupling::ShellInFlow motion;
      Probes probes;
    };

    const ImmersedShellParameters &prm;
    RunContext &context;
    const flow::FlowSolver<3> &flow;
    const spline::Surface surface;
    const shell::QuadraturePoints points; ///< at which shell and blood hold each other at first
    const std::unique_ptr<Moving> shell;  ///< null: it is rigid
    const VectorField<3> load, displacement, velocity;
    coupling::FluidStructure coupled;
    coupling::CoupledReport last;
    double largest_imbalance = 0.;
    const std::unique_ptr<ShellOutput> files; ///< null: it is rigid

    void initialise();
    /// The equations' vector nearest to a field of the undeformed surface.
    shell::NonlinearSystem::Vector project(const VectorField<3> &field, double time) const;
    shell::ControlVectors load_at(double time) const;
    dealii::Point<3> undeformed(unsigned int q) const; ///< a point of the model
    double displacement_error() const;
    shell::ControlVectors positions() const
    {
      return shell->motion.positions(shell->motion.displacement());
    }
  };
} // namespace semilunar::scene

#endif
