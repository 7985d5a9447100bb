// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_coupling_fluid_structure_h
#define semilunar_coupling_fluid_structure_h

#include <semilunar/coupling/cells_near_surfaces.h>
#include <semilunar/coupling/immersed_points.h>
#include <semilunar/coupling/parameters.h>
#include <semilunar/coupling/point_density.h>
#include <semilunar/coupling/shell_in_flow.h>
#include <semilunar/flow/flow_solver.h>

namespace semilunar::coupling
{
  /// Power across the interface, (I6) [erg/s].
  struct InterfacePower
  {
    double fluid = 0.;       ///< of the structures' forces on the fluid
    double structure = 0.;   ///< of the fluid's forces on the structures
    double dissipation = 0.; ///< of penalties and multipliers against the slip
    double imbalance() const { return fluid + structure + dissipation; }
  };

  /// What a coupled step did.
  struct CoupledReport
  {
    flow::StepReport flow;
    unsigned int n_iterations = 0; ///< solutions of fluid and structure
    double residual = 0.;          ///< of the shell, relative to its forces
    double largest_slip = 0.;      ///< difference of the normal velocities [cm/s]
    bool new_points = false;       ///< whether the shell got other points before the step
    InterfacePower power;
    dealii::Tensor<1, 3> force_on_shell, force_on_rigid; ///< of the fluid [dyn]
    dealii::Tensor<1, 3> force_on_supports; ///< of the shell on what holds it, (I11) [dyn]
  };

  /// A shell in the flow: what moves, its surface, and the points at which both hold each other.
  struct ImmersedShell
  {
    ShellInFlow *motion; ///< null: there is no shell
    const spline::Surface &surface;
    const shell::QuadraturePoints &points; ///< at first; elements get more where they need them
    double mass_per_area;                  ///< [g/cm^2]
  };

  /// A flexible shell and a rigid surface in a flow: the dynamic augmented Lagrangian method.
  /// Equations (I1)-(I7) of doc/theory/coupling.md. The shell and everything of the points but
  /// their places in the mesh are the same on all ranks.
  class FluidStructure
  {
  public:
    /// The flow and the shell must outlive the object.
    /// @param rigid   points that do not move; there may be none
    FluidStructure(flow::FlowSolver<3> &flow, const ImmersedShell &immersed,
                   const SurfacePoints &rigid, const flow::Parameters &fluid,
                   const Parameters &parameters, Timers &timers);

    /// One step. @throws NumericsError; then the state is that before the step
    CoupledReport advance(double dt);

    /// lambda of all points, those of the shell first; 0 for points outside of the fluid
    /// [dyn/cm^2].
    const std::vector<double> &multipliers() const { return lambda; }
    /// The same for all points.
    void set_multipliers(const double value) { lambda.assign(lambda.size(), value); }
    /// At which the shell is held at present.
    const shell::QuadraturePoints &gauss_points() const { return *gauss; }
    /// Gauss points of the shell's elements, in its two directions.
    PointNumbers numbers_of_points() const;
    /// Continue with these points and their multipliers.
    void set_points(const PointNumbers &numbers, const std::vector<double> &multipliers);
    /// What comes next depends on nothing but the states of flow and shell and the multipliers, bit
    /// for bit, and not on where points and marked cells were before. Also to be called when the
    /// mesh has changed. Collective. @throws NumericsError for a point of the shell that is lost
    void forget_history();
    /// Where the points of the shell were in the last step [cm].
    std::vector<dealii::Tensor<1, 3>> positions_of_shell_points() const
    {
      return {points.positions.begin(), points.positions.begin() + n_shell_points()};
    }
    const ImmersedPoints *shell_points() const { return in_shell.get(); }
    const ImmersedPoints *rigid_points() const { return in_rigid.get(); }
    const CellsNearSurfaces &marked_cells() const { return near; }

  private:
    using Force = dealii::Tensor<1, 3>;
    using Stiffness = dealii::Tensor<2, 3>;
    using Vector = shell::NonlinearSystem::Vector;

    flow::FlowSolver<3> &flow;
    const MPI_Comm communicator;
    const ImmersedShell immersed;
    ShellInFlow *const shell;
    const SurfacePoints rigid;
    const double density, viscosity; ///< of the fluid [g/cm^3], [g/(cm s)]
    const Parameters prm;
    Timers &timers;

    const shell::QuadraturePoints *gauss; ///< points of the shell
    std::unique_ptr<const shell::QuadraturePoints> own_gauss;
    std::unique_ptr<ImmersedPoints> in_shell, in_rigid;
    CellsNearSurfaces near;
    double weighted_dt = 0.; ///< for which the marked cells have their weights

    // Of all points, those of the shell first.
    SurfacePoints points;
    std::vector<Stiffness> penalties; ///< K
    std::vector<double> lambda;
    std::vector<ImmersedPoints::Local> local; ///< of this rank

    // Of a step.
    Vector y;             ///< displacements of the shell at its end
    std::vector<Force> u; ///< velocities of the fluid at the local points

    unsigned int n_shell_points() const { return shell ? gauss->n_points() : 0; }
    /// Positions, normals and areas of all points with the shell at y.
    SurfacePoints all_points() const;
    /// Width of the smallest cell that each element has points in, on all ranks [cm].
    std::vector<double> cell_widths() const;
    /// Give elements more points where they need them. Collective. @return whether any has changed
    bool adapt_points();
    void renew_points(const PointNumbers &numbers);
    void place_points();
    void make_penalties();
    void mark_cells(double dt);
    /// Tell the fluid about points and penalties, then about the rest of the forces there.
    void set_terms();
    void set_term_forces(const std::vector<Force> &structure_velocities);

    /// N^T (K u + lambda n) of these velocities at the local points, on all ranks.
    shell::ControlVectors forces_on_shell(const std::vector<Force> &velocities,
                                          bool with_multiplier) const;
    void sum_over_ranks(shell::ControlVectors &forces) const;
    /// N of a vector of the shell's equations; zero at the points of the rigid surface.
    std::vector<Force> at_local_points(const Vector &vector) const;
    /// S^-1 N^T K u: how the linearised shell answers velocities of the fluid.
    Vector displacement_response(const std::vector<Force> &velocities) const;
    std::vector<Force> velocity_response(const std::vector<Force> &velocities) const;
    /// Of the state (y, u). @return its norm relative to the forces
    double shell_residual(Vector &r);

    void check_iteration(const CoupledReport &report, const Vector &start) const;
    void quasi_direct(CoupledReport &report);
    void block(CoupledReport &report);
    void finish(CoupledReport &report);
  };
} // namespace semilunar::coupling

#endif
