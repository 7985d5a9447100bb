// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_shell_time_integrator_h
#define semilunar_shell_time_integrator_h

#include <semilunar/shell/modified_newton.h>
#include <semilunar/shell/time_step.h>

#include <deal.II/base/parameter_handler.h>

namespace semilunar::shell
{
  struct TimeIntegratorParameters
  {
    double end_time = 1.;
    double step = 1e-4;
    bool adaptive = false;
    double error_tolerance = 1e-4; ///< of the displacements of one step [length]
    double largest_step = 0.;      ///< 0: as Step
    double smallest_step = 1e-9;
    double spectral_radius = 0.5;
    double damping = 0.; ///< c_d [mass/(area time)]
    double tolerance = 1e-6;
    unsigned int max_iterations = 20;

    /// Declare the entries of the sections Time and Solver.
    void add_parameters(dealii::ParameterHandler &prm);
    double step_bound() const { return largest_step > 0. ? largest_step : step; }
    /// @throws InputError for numbers that contradict each other
    void check() const;
  };

  /// An accepted time step.
  struct TimeStepReport
  {
    unsigned int number; ///< counted from 1
    double dt;
    unsigned int iterations;
    unsigned int rejections; ///< attempts with longer steps that failed
    double residual;         ///< relative
    double error;            ///< estimate of the local error [length], NaN for fixed steps
  };

  /// Works of the forces since the start, and energies: (D12).
  struct EnergyBalance
  {
    double kinetic, strain, contact; ///< at the time
    double work_in;                  ///< of the loads
    double damped;                   ///< by the viscous traction
    double numerical;                ///< lost by the method (negative: gained)
    double error;                    ///< what does not close: residuals of Newton's method
  };

  /// Moves a shell in time. All errors are recoverable: a step that fails is repeated with half
  /// the length.
  class TimeIntegrator
  {
  public:
    /// @throws InputError for a shell without mass, moving supports, and parameters that contradict
    /// each other
    TimeIntegrator(Equilibrium &equilibrium, const Equations &equations, const Mass &mass,
                   Contact *contact, const TimeTable &load_factor,
                   const TimeIntegratorParameters &parameters);

    /// Start at time 0 from these displacements and velocities.
    void start(const NonlinearSystem::Vector &u, const NonlinearSystem::Vector &v);

    /// Make one step towards the next time to stop at, which it reaches but does not pass.
    /// @throws NumericsError naming the time if the step falls below its bound
    TimeStepReport advance(double next_stop, const std::function<bool()> &interrupted);

    const Motion &motion() const { return now; }
    double time() const { return now.time; }
    bool at_end() const { return now.time >= parameters.end_time; }
    ControlVectors positions() const;
    ControlVectors velocities() const;
    /// Whether the next steps depend on nothing but motion() and the memory of contact: every so
    /// many steps tangents and orderings are made anew. Only then a run that is restarted from here
    /// goes on bit for bit as the run itself.
    bool has_forgotten() const { return steps % steps_to_remember == 0; }
    static constexpr unsigned int steps_to_remember = 10;

    /// Save or restore the state; the memory of contact has to be saved apart.
    template <class Archive>
    void serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &now.time &now.u &now.v &now.a &next_step &steps;
      archive &sums.start_energy &sums.inertia &sums.internal &sums.external &sums.viscous;
    }

    unsigned int n_factorizations() const { return newton.n_factorizations(); }
    unsigned int n_steps() const { return steps; }

    EnergyBalance energy_balance();
    spline::Tensor<1, 3> momentum() const;
    spline::Tensor<1, 3> angular_momentum() const;

  private:
    /// Everything that the next steps depend on, apart from contact and tangent.
    struct Sums
    {
      double start_energy = 0., inertia = 0., internal = 0., external = 0., viscous = 0.;
    };

    Equilibrium &equilibrium;
    const Equations &equations;
    const Mass &mass;
    Contact *const contact;
    const TimeTable load_factor;
    const TimeIntegratorParameters parameters;
    TimeStep system;
    ModifiedNewton newton;

    Motion now;
    double next_step;
    unsigned int steps = 0;
    Sums sums;

    double step_towards(double stop) const;
    NonlinearSystem::Vector predict(double dt) const;
    void accept(const NonlinearSystem::Vector &w, const Motion &end);
    void choose_next_step(double dt, double error);
    double kinetic_energy() const;
  };
} // namespace semilunar::shell

#endif
