// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_flow_flow_solver_h
#define semilunar_flow_flow_solver_h

#include <semilunar/flow/mesh_motion.h>
#include <semilunar/flow/mesh_nodes.h>
#include <semilunar/flow/saddle_point_solver.h>
#include <semilunar/flow/state_transfer.h>

namespace semilunar::flow
{
  /// What a time step did.
  struct StepReport
  {
    double time = 0., dt = 0.;
    unsigned int n_nonlinear = 0, n_linear = 0; ///< iterations
    double residual = 0.;                       ///< of the first linear system at its end [dyn]
    double cfl = 0.;                            ///< largest |u - uhat| dt degree / h
    double cell_reynolds = 0.;                  ///< largest rho |u - uhat| h / (degree mu)
    double time_error = 0.; ///< estimate relative to the largest velocity; 0 in first steps
    double min_scaled_jacobian = 1.; ///< of the cells of the lumen, with an elastic wall
    double interface_error = 0.;     ///< largest distance of wall and mesh at the end [cm]
    unsigned int n_geometry = 0;     ///< solutions on positions of the wall
    std::map<dealii::types::boundary_id, double> flow_rate;     ///< out of open parts [cm^3/s]
    std::map<dealii::types::boundary_id, double> mean_pressure; ///< of open parts [dyn/cm^2]
  };

  /// Blood flow in time on a mesh that may move: everything that one needs to build on.
  ///
  /// advance(dt) makes a step. What is coupled to the flow in iterations uses its parts instead:
  /// start_step(dt); any number of times move_mesh(x) and solve_step(); then accept_step(), or
  /// reject_step() to be where the step began. With an elastic wall, start_step() moves the mesh to
  /// the predicted positions of the wall, and follow_wall() to those that solve_step() has found.
  template <int dim>
  class FlowSolver
  {
  public:
    using Id = dealii::types::boundary_id;
    using Point = dealii::Point<dim>;

    /// @param mapping gives the positions of the nodes, now and when the mesh is refined
    /// @param wall what the wall cells of the mesh consist of; needed if there are any
    /// @throws InputError for wrong parameters and parts of the boundary without a condition
    FlowSolver(const Parameters &parameters,
               dealii::parallel::distributed::Triangulation<dim> &triangulation,
               const dealii::Mapping<dim> &mapping, const BoundaryConditions<dim> &conditions,
               Timers &timers, const WallParameters *wall = nullptr);

    /// Force per volume [dyn/cm^3].
    void set_body_force(const VectorFunction<dim> &force) { body_force = force; }
    /// Where a node that was at x when the solver was made is at a time: moves the mesh in
    /// start_step().
    void set_mesh_motion(const VectorFunction<dim> &motion) { mesh_motion = motion; }

    /// Start at rest.
    void initialise(double time);
    /// Start from velocities, pressures 0 (or as given) [dyn/cm^2]. With a function that holds
    /// before the start as well, and the first step dt, the first step is of second order.
    void initialise(double time, const VectorFunction<dim> &velocity,
                    const std::function<double(const Point &, double)> &pressure = {},
                    double first_dt = 0.);

    /// @throws NumericsError; then the state is that before the step
    StepReport advance(double dt);

    void start_step(double dt);
    /// New positions of the nodes in this step (readable not needed).
    void move_mesh(const Vector &new_positions);
    void solve_step();
    /// Once more from the solution of solve_step(), after forces at points have changed.
    void correct_step();
    /// Move the mesh to where the wall was found, to solve once more.
    /// @return the largest distance of the wall from the mesh before [cm]; 0 without a wall
    double follow_wall();
    StepReport accept_step();
    void reject_step();
    bool step_under_way() const { return in_step; }

    /// The next step as controlled by the parameters: dt itself if fixed.
    double suggested_dt(double dt) const;

    double time() const { return current_time; }
    /// Of the step that was started.
    const Bdf &time_derivative() const { return bdf; }
    const Spaces<dim> &spaces() const { return space; }
    const Vector &velocity() const { return state.velocity; }
    const Vector &pressure() const { return state.pressure; }
    const Vector &positions() const { return nodes.positions(); }
    const Vector &reference_positions() const { return nodes.reference_positions(); }
    /// uhat at the nodes; zero on a mesh that does not move
    const Vector &mesh_velocity() const { return nodes.velocity(); }
    /// One component on velocity_dofs(), ghosted.
    Vector velocity_component(unsigned int c) const;
    /// Of the current positions.
    const dealii::Mapping<dim> &mapping() const { return nodes.mapping(); }

    /// Refine and coarsen the cells that are flagged and carry the state over, between two steps.
    /// Points and marked cells have to be set again; what was accumulated in cells is carried over.
    void refine();

    /// Before Triangulation::save(): attach the state to the mesh. The run goes on as one does that
    /// loads the file. @return numbers that load_state() needs
    std::vector<double> save_state();
    /// After Triangulation::load() on the mesh that the solver was made with: continue from there.
    void load_state(const std::vector<double> &numbers);

    /// Integrals over a part of the boundary, collective: of u.n, mean of p, its area.
    double flow_rate(Id id) const;
    double mean_pressure(Id id) const;
    double area(Id id) const { return equations.faces().part(id).area; }
    /// Force of the boundary on the fluid [dyn]: the residual of the momentum equation there. Of
    /// the state after a step. Collective.
    dealii::Tensor<1, dim> force(Id id);
    /// Force on the blood of parts of the boundary, with that of an elastic wall, each node once.
    dealii::Tensor<1, dim> force_on_blood(const std::vector<Id> &ids, bool of_wall);

    /// Force on wall and blood of what holds nodes of the wall (BoundaryConditions::hold_wall)
    /// [dyn]. Of the state after a step. Collective.
    dealii::Tensor<1, dim> force_of_holds();

    /// Where immersed structures and marked cells enter. After changes of points or marked cells
    /// call preconditioner().invalidate_momentum().
    PointTerms<dim> &points() { return equations.points(); }
    CellForms<dim> &cells() { return equations.cells(); }
    SaddlePointSolver<dim> &preconditioner() { return linear_solver; }
    /// nullptr if no wall is elastic
    const WallEquations<dim> *wall() const { return equations.wall(); }

  private:
    void reinit_vectors();
    Vector positions_at(double time) const;
    /// Equation (7) of doc/theory/wall.md: the mesh with the wall where a velocity takes it.
    /// @param positions a first guess of those of the other nodes
    void move_with_wall(const Vector &velocity, Vector positions);
    /// Put the nodes of the wall where a velocity takes them.
    void take_wall_positions(const Vector &velocity, Vector &positions) const;
    double distance_of_wall() const;
    void iterate_geometry();
    void finish_wall();
    void reinit_motion();
    void evaluate_geometry();
    /// Weights, linearisation and first guess. @return the norm of residuals that are rounding
    double prepare_solution();
    void first_guess();
    /// The old state, but for the velocity of a wall: the extrapolated one.
    void start_from_old_state();
    void iterate(double target);
    /// Linear-implicit in the lumen, Newton's method in the wall.
    void iterate_in_wall();
    /// @throws NumericsError if the wall found has cells that are turned over
    void check_wall() const;
    /// Solve for the change of the state with its residual.
    void add_linear_solution(double target);
    typename StateTransfer<dim>::State transferred_state(bool mesh_moves);
    /// The state was transferred to the space on a new mesh.
    void renew(bool mesh_moves, bool from_displacements);

    const Parameters prm;
    Timers &timers;
    const BoundaryConditions<dim> conditions;
    dealii::parallel::distributed::Triangulation<dim> &triangulation;
    Spaces<dim> space;
    StateTransfer<dim> transfer;
    MeshNodes<dim> nodes;
    Equations<dim> equations;
    SaddlePointSolver<dim> linear_solver;
    std::unique_ptr<MeshMotion<dim>> motion; ///< of blood in an elastic wall, or nullptr
    VectorFunction<dim> body_force, mesh_motion;

    // Velocities and pressures at the new time (equal to the old one between steps), at the old
    // time and before.
    FlowVector state, old_state, older_state;
    Vector history, advecting;
    double linear_target = 0.; ///< norm of the residual that a linear solution of the step reaches
    FlowVector residual, change;
    double current_time = 0., old_dt = 0.;
    unsigned int n_steps = 0; ///< accepted since the start, or since the mesh began to count
    Bdf bdf;
    bool in_step = false;
    StepReport current;
  };
} // namespace semilunar::flow

#endif
