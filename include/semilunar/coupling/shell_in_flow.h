// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_coupling_shell_in_flow_h
#define semilunar_coupling_shell_in_flow_h

#include <semilunar/flow/bdf.h>
#include <semilunar/shell/equilibrium.h>
#include <semilunar/shell/mass.h>

namespace semilunar::coupling
{
  /// Where the points of a surface are and how they lie: (I1) of doc/theory/coupling.md.
  struct SurfacePoints
  {
    std::vector<dealii::Tensor<1, 3>> positions; ///< [cm]
    std::vector<dealii::Tensor<1, 3>> normals;   ///< unit vectors
    std::vector<double> areas;                   ///< that a point stands for [cm^2]
  };

  SurfacePoints surface_points(const spline::Surface &surface,
                               const shell::QuadraturePoints &points,
                               const shell::ControlVectors &x);

  /// How many Gauss points an element needs in each direction that those of the largest element are
  /// no farther from each other than this [cm].
  unsigned int n_points_per_direction(const spline::Surface &surface, double spacing);

  /// A shell during a time step, (I4): inertia, strain and contact, and at given points the force
  /// K (u - v) + lambda n of the fluid around it, of which K v is part of the unknowns and the rest
  /// is given. Discretised as the fluid is, by backward differentiation, so that both balance at
  /// the end of the step. The unknown are the displacements there.
  class ShellInFlow : public shell::NonlinearSystem
  {
  public:
    /// @param points at which the fluid acts
    ShellInFlow(const spline::Surface &surface, const shell::QuadraturePoints &points,
                const shell::Equations &equations, shell::Equilibrium &equilibrium,
                const shell::Mass &mass);

    /// From now on the fluid acts at these points, which must outlive the object.
    void set_points(const shell::QuadraturePoints &new_points) { points = &new_points; }

    void start_step(const flow::Bdf &bdf);
    /// The displacements at the end of the step if accelerations were those of the last ones.
    Vector predict() const;
    /// K of every point [g/s] for this step.
    void set_penalties(std::vector<dealii::Tensor<2, 3>> penalties);
    /// What else holds the shell: springs of this stiffness per undeformed area [dyn/cm^3], which
    /// are at rest where the shell is undeformed.
    void set_foundation(double stiffness) { foundation = stiffness; }
    /// Forces on the control points in this step [dyn].
    void set_loads(const shell::ControlVectors &forces) { equations.restrict(forces, loads); }
    /// K u + lambda n of all points, as forces on the control points [dyn].
    void set_forces(const shell::ControlVectors &forces);
    /// The step ends with these displacements.
    void accept_step(const Vector &y);

    Vector velocity(const Vector &y) const;
    /// d velocity / d displacement [1/s].
    double rate() const { return bdf.alpha[0]; }
    shell::ControlVectors positions(const Vector &y) const { return equilibrium.positions(y, 0.); }
    const Vector &displacement() const { return u; }
    const Vector &velocity() const { return v; }
    double kinetic_energy() const;
    /// Rate of the momentum if the step ends with these displacements [dyn].
    dealii::Tensor<1, 3> momentum_rate(const Vector &y) const;
    /// Power of the fluid on the shell in the state of the last residual [erg/s].
    double power(const Vector &y) const { return fluid_force * velocity(y); }

    unsigned int n_unknowns() const override { return equations.n_equations(); }
    double residual(const Vector &y, double, Vector &r) override;
    void linearize(const Vector &y, double, double shift) override;
    void solve(Vector &right_hand_side) const override { equilibrium.solve(right_hand_side); }
    const Vector &lumped_area() const override { return equilibrium.lumped_area(); }
    void load_derivative(const Vector &, double, Vector &derivative) override;
    double largest_change() const override { return equilibrium.largest_change(); }
    double smallest_change() const override { return equilibrium.smallest_change(); }
    void accept(const Vector &y, double) override { equilibrium.accept(y, 0.); }

    /// Vectors of the equations as vectors of the control points, and at a point.
    shell::ControlVectors expand(const Vector &vector) const;
    dealii::Tensor<1, 3> at_point(unsigned int q, const shell::ControlVectors &vectors) const;
    /// The transpose of both: a force at a point, and forces on the control points.
    void add_force(unsigned int q, const dealii::Tensor<1, 3> &force,
                   shell::ControlVectors &forces) const;
    void restrict(const shell::ControlVectors &forces, Vector &result) const
    {
      equations.restrict(forces, result);
    }

    /// All that the next steps depend on but contact.
    struct State
    {
      Vector u, u_old, v, v_old;

      template <class Archive>
      void serialize(Archive &archive, const unsigned int /*version*/)
      {
        archive &u &u_old &v &v_old;
      }
    };
    State state() const { return {u, u_old, v, v_old}; }
    void set_state(const State &state);

  private:
    const spline::Surface &surface;
    const shell::QuadraturePoints *points;
    const shell::Equations &equations;
    shell::Equilibrium &equilibrium;
    const shell::Mass &mass;
    flow::Bdf bdf;
    Vector u, u_old, v, v_old; // at the last two times
    Vector u_history, v_history, given_forces, loads;
    double foundation = 0.;
    Vector fluid_force; ///< on the equations, at the last residual
    std::vector<dealii::Tensor<2, 3>> penalties;

    void add_penalty(shell::SparseSystem &tangent, double factor) const;
  };
} // namespace semilunar::coupling

#endif
