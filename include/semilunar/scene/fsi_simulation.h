// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_scene_fsi_simulation_h
#define semilunar_scene_fsi_simulation_h

#include <semilunar/coupling/fluid_structure.h>
#include <semilunar/mesh/mesh.h>
#include <semilunar/output/cross_section.h>
#include <semilunar/output/time_series.h>
#include <semilunar/output/velocity_dofs.h>
#include <semilunar/scene/flow_through_valve.h>
#include <semilunar/scene/shell_output.h>
#include <semilunar/scene/valve_fsi.h>
#include <semilunar/scene/valve_motion.h>

namespace semilunar::scene
{
  /// A valve in flowing blood from its start to its end, with all output.
  class FsiSimulation
  {
  public:
    FsiSimulation(const ValveFsiParameters &parameters, RunContext &context);

    /// @throws InputError, NumericsError
    void run();

  private:
    const ValveFsiParameters &prm;
    RunContext &context;

    // The structure.
    std::unique_ptr<ShellModel> model;
    const shell::Mass mass;
    const std::unique_ptr<mesh::Mesh<3>> mesh;
    const shell::QuadraturePoints points; ///< at which leaflets and blood hold each other
    coupling::ShellInFlow shell;

    // The blood.
    const dealii::MappingQ<3> mapping;
    const flow::BoundaryConditions<3> conditions;
    flow::FlowSolver<3> flow;
    std::unique_ptr<coupling::FluidStructure> coupled;

    // What is written.
    output::VelocityDofs<3> velocity_dofs;
    std::array<output::CrossSection<3>, 2> sections;
    ValveMotion motion;
    output::TimeSeries series;
    std::unique_ptr<ShellOutput> shell_files;
    std::unique_ptr<output::FlowVtu<3>> flow_files;
    FlowThroughValve flow_through;
    double next_row = 0., next_shell_file = 0., next_flow_file = 0., last_dt = 0.;
    std::string last_file;
    /// Largest relative imbalance of power, and largest penetration [cm], so far.
    double largest_imbalance = 0., largest_penetration = 0.;
    unsigned int n_iterations = 0, n_rejected = 0;

    double cell_width_at_valve() const;
    unsigned int n_points_per_direction(const spline::Surface &surface) const;
    coupling::SurfacePoints stent_points() const;
    void report_size() const;
    coupling::CoupledReport step(double &dt);
    void finish_step(const coupling::CoupledReport &report);
    void add_row(const coupling::CoupledReport &report, double pressure_difference);
    void write_shell();
    void write_flow();
    output::FlowState<3> state() const;
    shell::ControlVectors positions() const { return shell.positions(shell.displacement()); }
    void add_quantities();
  };
} // namespace semilunar::scene

#endif
