// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_shell_time_step_h
#define semilunar_shell_time_step_h

#include <semilunar/core/time_table.h>
#include <semilunar/shell/equilibrium.h>
#include <semilunar/shell/mass.h>

namespace semilunar::shell
{
  /// Motion of a shell at a time: displacements, velocities and accelerations of the equations.
  /// The acceleration belongs to the generalised-alpha method: see (D5).
  struct Motion
  {
    double time = 0.;
    NonlinearSystem::Vector u, v, a;
  };

  /// Coefficients of the generalised-alpha method, (D6): J. Chung and G.M. Hulbert, J. Appl. Mech.
  /// 60 (1993) 371-375.
  struct GeneralizedAlpha
  {
    /// @param spectral_radius rho_infinity in [0, 1]: share of the fastest oscillations that a step
    /// leaves; 1: the implicit midpoint rule, which damps nothing
    explicit GeneralizedAlpha(double spectral_radius);

    double alpha_m, alpha_f, beta, gamma;
    /// Without damping, internal forces are those of the energy-momentum method.
    bool conserves_energy() const { return alpha_f == 0.5; }
    /// The local error of the displacements is this times dt^2 times the change of acceleration,
    /// (D10).
    double error_constant() const;
  };

  /// The equations of one time step, (D7), as a nonlinear system. Its unknown w is the displacement
  /// at the time t + (1 - alpha_f) dt, at which the forces balance: there, contact and strain are
  /// evaluated once per iteration.
  class TimeStep : public NonlinearSystem
  {
  public:
    /// @param damping_rate viscous force per momentum [1/time], (D3)
    /// @param load_factor  of the loads, over time
    TimeStep(Equilibrium &equilibrium, const Equations &equations, const Mass &mass,
             const GeneralizedAlpha &method, double damping_rate, const TimeTable &load_factor);

    /// Begin a step. The motion must outlive it. Until finish(), the residuals of the equilibrium
    /// are those of the step.
    void begin(const Motion &start, double dt);
    void finish() { equilibrium.end_step(); }
    /// The motion at the end of the step from a solution w.
    Motion end(const Vector &w) const;
    /// The w that belongs to displacements at the end of the step.
    Vector from_end(const Vector &u_end) const;

    /// Load factor at the time of the balance.
    double load() const { return load_of_step; }
    /// The load factor given to the functions of the interface is ignored for that of the step.
    double residual(const Vector &w, double, Vector &r) override;
    void linearize(const Vector &w, double, double shift) override;
    unsigned int n_unknowns() const override { return equations.n_equations(); }
    void solve(Vector &right_hand_side) const override { equilibrium.solve(right_hand_side); }
    const Vector &lumped_area() const override { return equilibrium.lumped_area(); }
    void load_derivative(const Vector &w, double, Vector &derivative) override;
    double largest_change() const override;
    double smallest_change() const override { return equilibrium.smallest_change(); }
    void accept(const Vector &, double) override {}

    /// The initial acceleration that balances the forces on this motion.
    Vector initial_acceleration(const Motion &motion);
    /// Estimate of the local error of the displacements of a step, filtered of motions that the
    /// step does not resolve, (D11): largest component. Uses the last linearisation.
    double error_estimate(const Motion &start, const Motion &end) const;

    /// Work of the forces in a solved step: (D12).
    struct Work
    {
      double inertia;  ///< against inertia
      double viscous;  ///< against damping
      double internal; ///< against strain and contact
      double external; ///< of the loads
    };
    Work work(const Vector &w);

    const Equations &equations;
    const Mass &mass;
    const GeneralizedAlpha method;
    const double damping_rate;

  private:
    Equilibrium &equilibrium;
    const TimeTable &load_factor;
    const Motion *start = nullptr;
    double dt = 0., load_of_step = 0.;

    Vector acceleration(const Vector &w) const;
    Vector velocity(const Vector &end_acceleration) const;
    double inertia_coefficient() const;
  };
} // namespace semilunar::shell

#endif
