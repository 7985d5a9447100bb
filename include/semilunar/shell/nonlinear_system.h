// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_shell_nonlinear_system_h
#define semilunar_shell_nonlinear_system_h

#include <deal.II/lac/vector.h>

namespace semilunar::shell
{
  /// What a solver of r(u, load) = 0 needs to know. Solvers know no physics beyond this.
  class NonlinearSystem
  {
  public:
    using Vector = dealii::Vector<double>;

    virtual ~NonlinearSystem() = default;

    virtual unsigned int n_unknowns() const = 0;

    /// The residual r(u, load). May hold numbers that are not finite where u is inadmissible.
    /// @return a force that the norm of the residual is to be compared with
    virtual double residual(const Vector &u, double load, Vector &r) = 0;

    /// Factorise dr/du + shift M at (u, load), M a positive diagonal (lumped area).
    virtual void linearize(const Vector &u, double load, double shift) = 0;
    /// The same without shift for iterations that take whole steps: where the tangent depends on
    /// the stress, it may take the one that the last linearisation predicts here instead of the one
    /// of this state.
    virtual void linearize_predicted(const Vector &u, double load) { linearize(u, load, 0.); }
    /// Solve with what linearize() made.
    virtual void solve(Vector &right_hand_side) const = 0;
    virtual const Vector &lumped_area() const = 0;

    /// dr/dload at (u, load).
    virtual void load_derivative(const Vector &u, double load, Vector &derivative) = 0;

    /// The largest change of any unknown that one step may make (infinite if there is no bound).
    virtual double largest_change() const = 0;

    /// Changes of all unknowns up to this size are lost in rounding: no better solution exists.
    virtual double smallest_change() const { return 0.; }

    /// The state (u, load) is a solution: remember what depends on history.
    virtual void accept(const Vector &u, double load) = 0;
  };
} // namespace semilunar::shell

#endif
