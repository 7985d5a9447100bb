// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_shell_equilibrium_h
#define semilunar_shell_equilibrium_h

#include <semilunar/core/timers.h>
#include <semilunar/shell/assembly.h>
#include <semilunar/shell/contact.h>
#include <semilunar/shell/edge_moments.h>
#include <semilunar/shell/equations.h>
#include <semilunar/shell/nonlinear_system.h>
#include <semilunar/shell/sparse_system.h>

#include <functional>

namespace semilunar::shell
{
  /// Static equilibrium of a shell under follower pressure, dead forces, edge moments, prescribed
  /// displacements and contact, all but contact proportional to the load factor.
  class Equilibrium : public NonlinearSystem
  {
  public:
    /// @param pressure    follower pressure at load factor one
    /// @param dead_forces on the control points at load factor one
    /// @param contact     may be null
    /// @param timers      get the phases "assembly", "contact" and "linear solver"
    /// @param edge_moments at load factor one; may be null
    /// @throws InputError for loads whose norm is not finite
    Equilibrium(const spline::Surface &surface, const QuadraturePoints &points,
                const Equations &equations, const Assembly &assembly, double pressure,
                const ControlVectors &dead_forces, Contact *contact, Timers &timers,
                const EdgeMoments *edge_moments = nullptr);

    unsigned int n_unknowns() const override { return equations.n_equations(); }
    double residual(const Vector &u, double load, Vector &r) override;
    void linearize(const Vector &u, double load, double shift) override;
    /// The same with what @p add adds to the tangent, as the inertia of a time step.
    void linearize(const Vector &u, double load, const std::function<void(SparseSystem &)> &add);
    void linearize_predicted(const Vector &u, double load) override;
    void solve(Vector &right_hand_side) const override;
    const Vector &lumped_area() const override { return area; }
    void load_derivative(const Vector &u, double load, Vector &derivative) override;
    double largest_change() const override;
    double smallest_change() const override;
    void accept(const Vector &u, double load) override;

    /// From now on, residuals are those of a time step, of which u is the state at this share.
    /// Contact pressures are means over the step.
    /// @param conserve_energy whether the internal forces are those of the energy-momentum method,
    /// for which u must be in the middle
    /// @param start positions of the control points at the start
    void begin_step(const ControlVectors &start, double share, bool conserve_energy);
    /// Back to statics.
    void end_step();

    /// Positions of the control points.
    ControlVectors positions(const Vector &u, double load) const;
    /// Strain energy at the last residual().
    double strain_energy() const { return energy; }
    /// Forces of pressure and dead loads on the control points at x: what the residual subtracts.
    ControlVectors external_forces(const ControlVectors &x, double load) const;

    /// Forget which elements have touched and how the matrix was ordered: what comes next depends
    /// on the state alone, bit for bit.
    void forget_history() { matrix.forget(); }

  private:
    const Equations &equations;
    const Assembly &assembly;
    const double pressure;
    const ControlVectors &dead_forces;
    Contact *const contact;
    const EdgeMoments *const edge_moments;
    const spline::Surface &surface;
    const ControlVectors undeformed;
    ControlVectors start_of_step; // none: static
    ControlVectors linearized_at; // positions
    SparseSystem matrix;
    Vector area;
    const double load_norm; // of the external forces at load factor one
    double energy = 0.;
    /// Forces on the control points at x but for contact.
    ControlVectors internal_minus_external(const ControlVectors &x, double load);
    std::vector<std::pair<unsigned int, unsigned int>> touching_elements() const;
    void linearize(const Vector &u, double load, const std::function<void(SparseSystem &)> &add,
                   const std::vector<Resultants> *predicted);
    const QuadraturePoints &points;
    Timers &timers;
  };
} // namespace semilunar::shell

#endif
