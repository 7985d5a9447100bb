// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_flow_saddle_point_solver_h
#define semilunar_flow_saddle_point_solver_h

#include <semilunar/core/timers.h>
#include <semilunar/flow/factor_age.h>
#include <semilunar/flow/momentum_matrix.h>
#include <semilunar/flow/schur_preconditioner.h>

namespace semilunar::flow
{
  /// Flexible GMRES for velocity and pressure together, right preconditioned with the block
  /// triangular matrix of equation (14) and the correction (17), with which the flow through the
  /// boundary balances to rounding, whatever the tolerance. What it is preconditioned with is kept
  /// as long as that pays.
  template <int dim>
  class SaddlePointSolver
  {
  public:
    SaddlePointSolver(const Equations<dim> &equations, const Parameters &parameters,
                      Timers &timers);

    /// The mesh was refined: everything is made anew.
    void reinit();
    /// What acts at points or the weights of marked cells have changed: factorise before the next
    /// solution.
    void invalidate_momentum() { momentum_age.invalidate(); }

    /// A time step begins.
    void start_step();

    /// Norm of residuals with the weight of the continuity equation. Collective.
    double norm(const FlowVector &residual) const;
    /// Weight of continuity residuals against momentum residuals [dyn s/cm^3]; set before norm().
    void set_continuity_weight(const double w) { weight = w; }

    /// Solve J x = b with the derivative J that the equations were linearised to.
    /// @param target norm of b - J x to reach
    /// @return iterations
    /// @throws NumericsError after the largest number of iterations
    unsigned int solve(FlowVector &x, const FlowVector &b, double target);

  private:
    void prepare();
    void assemble_momentum(bool with_wall);
    bool due(const FactorAge &age) const;
    void precondition(FlowVector &z, const FlowVector &r) const;
    /// Equation (14).
    void solve_blocks(FlowVector &z, const FlowVector &r) const;
    /// Whether there is blood, and boundaries let it out.
    bool has_balance() const
    {
      return equations.spaces().has_lumen() && !equations.conditions().closed();
    }
    /// Make what equation (17) needs of the current mesh and factors. Collective.
    void prepare_balance(bool new_factors);
    /// The surplus of volume of r that z leaves, 1^T r_p - g^T z_u, as multiple of the response to
    /// a uniform source. Collective.
    double surplus(const FlowVector &z, const FlowVector &r) const;
    /// x = the response that balances b, r = b - J x. Collective.
    void start_balanced(FlowVector &x, FlowVector &r, const FlowVector &b) const;
    void remove_mean(Vector &pressure) const;
    /// GMRES until it starts again; size: norm of the residual r, then of what is left.
    unsigned int iterate(FlowVector &x, const FlowVector &r, double target,
                         unsigned int max_iterations, double &size);
    /// Make v orthogonal to the first n vectors of the basis and a unit vector.
    /// @return its coefficients in the basis and its norm: a column of the Hessenberg matrix.
    /// Collective.
    std::vector<double> orthonormalise(FlowVector &v, unsigned int n) const;
    /// Scalar products of v with the first n vectors of the basis, and with itself. Collective.
    std::vector<double> products(const FlowVector &v, unsigned int n) const;

    const Equations<dim> &equations;
    const Parameters &prm;
    Timers &timers;
    MomentumMatrix<dim> momentum;
    std::unique_ptr<WallMatrix<dim>> wall; ///< nullptr if there is none
    Ilu ilu;
    SchurPreconditioner<dim> schur;
    mutable FlowVector work;
    Vector outflow;            ///< g of equation (17): outflow of the free velocities
    FlowVector response;       ///< y of equation (17)
    double response_flow = 0.; ///< g^T y_u
    std::vector<FlowVector> basis, directions;
    double weight = 1.;
    bool schur_is_valid = false;
    bool advection_rules = false; ///< in the Schur complement, as of the last factorisation
    /// Age in solutions; with a wall, of which the first of a step is not like the others, in
    /// steps.
    FactorAge momentum_age = {10, 2, FactorAge::any};
    /// Factors of the wall cost as much as ten iterations and more.
    FactorAge wall_age = {50, FactorAge::any, 10};
    unsigned int iterations_of_step = 0; ///< with a wall
  };
} // namespace semilunar::flow

#endif
