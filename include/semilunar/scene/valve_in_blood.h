// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_scene_valve_in_blood_h
#define semilunar_scene_valve_in_blood_h

#include <semilunar/coupling/fluid_structure.h>
#include <semilunar/coupling/refinement_near_points.h>
#include <semilunar/mesh/mesh.h>
#include <semilunar/output/flow_state.h>
#include <semilunar/output/velocity_dofs.h>
#include <semilunar/scene/valve_fsi.h>

#include <deal.II/fe/mapping_q.h>

namespace semilunar::scene
{
  /// Leaflets, stent and blood in an artery with rigid or elastic walls: what moves, and its
  /// checkpoints.
  class ValveInBlood
  {
  public:
    /// @throws InputError for parameters that do not fit each other
    ValveInBlood(const ValveFsiParameters &parameters, Log &log, Timers &timers);
    ValveInBlood(const ValveInBlood &) = delete;

    /// One step. @throws NumericsError; then the state is that before the step
    coupling::CoupledReport advance(double dt);

    /// After a step: let the mesh follow the leaflets if they have left its fine cells. Collective.
    /// @return whether the mesh has changed
    bool adapt_mesh(unsigned int step);

    /// What a step would report of the state at the start. Collective.
    coupling::CoupledReport at_rest() const;

    double time() const { return flow.time(); }
    /// Length of the last step [s].
    double last_step() const { return last_dt; }
    ShellModel &leaflets() const { return *model; }
    /// Of the control points of the leaflets.
    shell::ControlVectors positions() const { return shell.positions(shell.displacement()); }
    double kinetic_energy() const { return shell.kinetic_energy(); }
    output::FlowState<3> blood() const;
    const mesh::Mesh<3> &artery() const { return *mesh; }
    flow::FlowSolver<3> &solver() { return flow; }
    bool has_elastic_wall() const { return flow.wall() != nullptr; }
    /// Of the blood [cm^3]. Collective.
    double volume();

    unsigned long long n_unknowns() const;
    /// Immersed points of the leaflets.
    unsigned int n_points() const { return coupled->shell_points()->n_points(); }
    /// Lines about the sizes of all parts.
    void report_size() const;

    /// Tell checkpoints about the state.
    void add_to(Checkpoints &checkpoints);
    /// What a checkpoint must have in common with this valve.
    std::string fit() const;
    /// From here on everything depends on what checkpoints hold alone, bit for bit: to be called
    /// after one was written, and after one was restored. Collective.
    void forget_history();

  private:
    const ValveFsiParameters &prm;
    Log &log;
    Timers &timers;

    // The structure.
    const std::unique_ptr<ShellModel> model;
    const shell::Mass mass;
    const std::unique_ptr<mesh::Mesh<3>> mesh;
    coupling::RefinementNearPoints refinement;
    const shell::QuadraturePoints points; ///< at which leaflets and blood hold each other at first
    coupling::ShellInFlow shell;

    // The blood.
    const dealii::MappingQ<3> mapping;
    const flow::BoundaryConditions<3> conditions;
    flow::FlowSolver<3> flow;
    std::unique_ptr<coupling::FluidStructure> coupled;
    std::unique_ptr<output::VelocityDofs<3>> velocity_dofs;
    double last_dt = 0.;

    double cell_width_at_valve() const;
    unsigned int n_points_per_direction(const spline::Surface &surface) const;
    coupling::SurfacePoints stent_points() const;
    void renew_dofs();
  };
} // namespace semilunar::scene

#endif
