// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/flow/hessenberg_least_squares.h>
#include <semilunar/flow/saddle_point_solver.h>

#include <deal.II/base/mpi.h>

#include <cmath>

namespace semilunar::flow
{
  namespace
  {
    /// Directions that are kept before GMRES starts again.
    constexpr unsigned int max_basis = 60;

    /// r += factor v
    void add(FlowVector &r, const double factor, const FlowVector &v)
    {
      r.velocity.add(factor, v.velocity);
      r.pressure.add(factor, v.pressure);
    }

    void scale(FlowVector &v, const double factor)
    {
      v.velocity *= factor;
      v.pressure *= factor;
    }

    double product(const double *a, const double *b, const std::size_t n)
    {
      double sum[4] = {};
      std::size_t i = 0;
      for (; i + 4 <= n; i += 4)
        for (int k = 0; k < 4; ++k)
          sum[k] += a[i + k] * b[i + k];
      for (; i < n; ++i)
        sum[0] += a[i] * b[i];
      return sum[0] + sum[1] + sum[2] + sum[3];
    }
  } // namespace

  template <int dim>
  SaddlePointSolver<dim>::SaddlePointSolver(const Equations<dim> &equations,
                                            const Parameters &parameters, Timers &timers)
      : equations(equations), prm(parameters), timers(timers), momentum(equations.spaces())
  {
    if (equations.wall())
      wall = std::make_unique<WallMatrix<dim>>(equations.spaces(), equations.wall()->nodes(), true);
  }

  template <int dim>
  void SaddlePointSolver<dim>::reinit()
  {
    momentum.reinit();
    if (wall)
      wall->reinit();
    work.reinit(equations.spaces());
    response.reinit(equations.spaces());
    outflow.reinit(equations.spaces().velocities());
    basis.clear();
    directions.clear();
    momentum_age.invalidate();
    wall_age.invalidate();
    schur_is_valid = false;
    iterations_of_step = 0;
  }

  template <int dim>
  void SaddlePointSolver<dim>::start_step()
  {
    if (iterations_of_step > 0)
      for (FactorAge *age : {&momentum_age, &wall_age})
        age->add_solution(iterations_of_step);
    iterations_of_step = 0;
  }

  template <int dim>
  bool SaddlePointSolver<dim>::due(const FactorAge &age) const
  {
    return age.unfit(equations.inertia()) || (iterations_of_step == 0 && age.stale());
  }

  template <int dim>
  std::vector<double> SaddlePointSolver<dim>::products(const FlowVector &v,
                                                       const unsigned int n) const
  {
    // In pieces that stay in the cache while all products are formed.
    constexpr std::size_t piece = 2048;
    std::vector<double> sums(n + 1, 0.);
    const auto add_products = [&](const Vector FlowVector::*part, const double factor)
    {
      const std::size_t size = (v.*part).locally_owned_size();
      for (std::size_t begin = 0; begin < size; begin += piece)
        for (unsigned int i = 0; i <= n; ++i)
          sums[i] += factor * product((v.*part).begin() + begin,
                                      ((i < n ? basis[i] : v).*part).begin() + begin,
                                      std::min(piece, size - begin));
    };
    add_products(&FlowVector::velocity, 1.);
    add_products(&FlowVector::pressure, weight * weight);
    dealii::Utilities::MPI::sum(sums, equations.spaces().communicator(), sums);
    return sums;
  }

  template <int dim>
  double SaddlePointSolver<dim>::norm(const FlowVector &residual) const
  {
    return std::sqrt(products(residual, 0)[0]);
  }

  template <int dim>
  void SaddlePointSolver<dim>::prepare()
  {
    const bool wall_due = wall && due(wall_age);
    if (!due(momentum_age) && !wall_due)
    {
      if (equations.is_moving())
        prepare_balance(false);
      return;
    }
    const double inertia = equations.inertia();
    assemble_momentum(wall_due);
    // Above this CFL number the second V-cycle of equation (16) pays. The momentum matrix has only
    // the lumen in it: no elastic wall.
    constexpr double large_cfl = 2.;
    advection_rules =
        !equations.wall() &&
        dealii::Utilities::MPI::max(equations.cells().largest_rates().advection,
                                    equations.spaces().communicator()) > large_cfl * inertia;
    momentum_age.start(inertia);
    {
      Timers::Scope scope(timers, "flow: Schur complement");
      if (!schur_is_valid && equations.spaces().has_lumen())
        schur.build(equations, momentum.diagonal());
      schur_is_valid = true;
    }
    prepare_balance(true);
  }

  template <int dim>
  void SaddlePointSolver<dim>::prepare_balance(const bool new_factors)
  {
    if (!has_balance())
      return;
    FlowVector source;
    source.reinit(equations.spaces());
    source.pressure = 1.;
    equations.gradient(outflow, source.pressure);
    if (new_factors)
    {
      schur.volume_source(source.pressure);
      solve_blocks(response, source);
    }
    response_flow = outflow * response.velocity;
  }

  template <int dim>
  double SaddlePointSolver<dim>::surplus(const FlowVector &z, const FlowVector &r) const
  {
    double sum = -product(outflow.begin(), z.velocity.begin(), outflow.locally_owned_size());
    for (unsigned int i = 0; i < r.pressure.locally_owned_size(); ++i)
      sum += r.pressure.local_element(i);
    return dealii::Utilities::MPI::sum(sum, equations.spaces().communicator()) / response_flow;
  }

  template <int dim>
  void SaddlePointSolver<dim>::start_balanced(FlowVector &x, FlowVector &r,
                                              const FlowVector &b) const
  {
    // Where old states are extrapolated on a mesh at rest, nothing but rounding is out of balance.
    constexpr double rounding = 1e-8; // of what single cells have too much or too little
    const double factor = surplus(x, b);
    if (std::abs(factor * response_flow) <= rounding * b.pressure.l1_norm())
      return;
    add(x, factor, response);
    equations.vmult(r, x);
    r.velocity.sadd(-1., 1., b.velocity);
    r.pressure.sadd(-1., 1., b.pressure);
  }

  template <int dim>
  void SaddlePointSolver<dim>::assemble_momentum(const bool with_wall)
  {
    if (with_wall)
    {
      Timers::Scope scope(timers, "flow: wall matrix");
      wall->assemble(equations.wall()->solid());
      equations.wall()->support_matrix(
          [this](const unsigned int row, const unsigned int column, const double entry)
          { wall->add(row, column, entry); });
    }
    {
      Timers::Scope scope(timers, "flow: momentum matrix");
      momentum.assemble(equations, with_wall ? wall.get() : nullptr);
    }
    if (with_wall)
    {
      Timers::Scope scope(timers, "flow: wall factorisation");
      wall->factorise(equations.constraints());
      wall_age.start(equations.inertia());
    }
    Timers::Scope scope(timers, "flow: factorisation");
    ilu.factorise(momentum.rows());
  }

  template <int dim>
  void SaddlePointSolver<dim>::remove_mean(Vector &pressure) const
  {
    const auto &hanging = equations.spaces().pressure_hanging();
    double sum[2] = {};
    for (unsigned int i = 0; i < pressure.locally_owned_size(); ++i)
      if (!hanging.hangs(i))
      {
        sum[0] += pressure.local_element(i);
        sum[1] += 1.;
      }
    dealii::Utilities::MPI::sum(sum, equations.spaces().communicator(), sum);
    for (unsigned int i = 0; i < pressure.locally_owned_size(); ++i)
      if (!hanging.hangs(i))
        pressure.local_element(i) -= sum[0] / sum[1];
  }

  template <int dim>
  void SaddlePointSolver<dim>::precondition(FlowVector &z, const FlowVector &r) const
  {
    solve_blocks(z, r);
    if (has_balance())
      add(z, surplus(z, r), response);
  }

  template <int dim>
  void SaddlePointSolver<dim>::solve_blocks(FlowVector &z, const FlowVector &r) const
  {
    if (!equations.spaces().has_lumen())
      z.pressure = 0.;
    else if (advection_rules)
      schur.vmult(z.pressure, r.pressure, momentum.rows());
    else
      schur.vmult(z.pressure, r.pressure);
    z.pressure *= -1.;
    if (equations.conditions().closed())
      remove_mean(z.pressure);
    equations.gradient(work.velocity, z.pressure);
    work.velocity.sadd(-1., 1., r.velocity);
    if (wall)
    {
      // The wall first, then the lumen with its velocity: the rows of the wall are the identity.
      wall->solve(work.velocity, work.velocity);
      momentum.subtract_interface(work.velocity);
    }
    ilu.solve<dim>(work.velocity.begin(), z.velocity.begin());
    equations.constraints().mask(z.velocity);
  }

  template <int dim>
  unsigned int SaddlePointSolver<dim>::solve(FlowVector &x, const FlowVector &b,
                                             const double target)
  {
    prepare();
    Timers::Scope scope(timers, "flow: Krylov iterations");
    x.velocity = 0.;
    x.pressure = 0.;
    FlowVector r = b;
    if (equations.conditions().closed())
      remove_mean(r.pressure);
    if (has_balance())
      start_balanced(x, r, b);
    unsigned int n = 0;
    double size = norm(r);
    while (size > target)
    {
      if (n > 0) // GMRES starts again
      {
        equations.vmult(r, x);
        r.velocity.sadd(-1., 1., b.velocity);
        r.pressure.sadd(-1., 1., b.pressure);
        size = norm(r);
      }
      if (n >= prm.max_linear || !std::isfinite(size))
        throw NumericsError(
            "the linear solver for velocity and pressure did not converge: residual " +
                std::to_string(size / target) + " times the target after " + std::to_string(n) +
                " iterations",
            "", "");
      n += iterate(x, r, target, prm.max_linear - n, size);
    }
    if (wall)
      iterations_of_step += n;
    else
      momentum_age.add_solution(n);
    return n;
  }

  template <int dim>
  std::vector<double> SaddlePointSolver<dim>::orthonormalise(FlowVector &v,
                                                             const unsigned int n) const
  {
    // Classical Gram-Schmidt: one reduction for all products, twice where digits were lost.
    std::vector<double> column(n + 1, 0.);
    double before, after;
    do
    {
      const std::vector<double> h = products(v, n);
      before = h[n];
      after = before;
      for (unsigned int i = 0; i < n; ++i)
      {
        add(v, -h[i], basis[i]);
        column[i] += h[i];
        after -= h[i] * h[i];
      }
    } while (after < 1e-2 * before && after > 1e-28 * before);
    column[n] = norm(v);
    scale(v, 1. / column[n]);
    return column;
  }

  template <int dim>
  unsigned int SaddlePointSolver<dim>::iterate(FlowVector &x, const FlowVector &r,
                                               const double target,
                                               const unsigned int max_iterations, double &size)
  {
    const unsigned int m = std::min(max_basis, max_iterations);
    if (basis.empty())
      basis.push_back(work);
    basis[0] = r;
    scale(basis[0], 1. / size);
    HessenbergLeastSquares projected(size);
    unsigned int n = 0;
    while (n < m && projected.residual() > target)
    {
      if (directions.size() <= n)
        directions.push_back(work);
      if (basis.size() <= n + 1)
        basis.push_back(work);
      precondition(directions[n], basis[n]);
      equations.vmult(basis[n + 1], directions[n]);
      projected.add_column(orthonormalise(basis[n + 1], n + 1));
      ++n;
    }
    size = projected.residual();
    const std::vector<double> y = projected.solution();
    for (unsigned int i = 0; i < n; ++i)
      add(x, y[i], directions[i]);
    return n;
  }

  template class SaddlePointSolver<2>;
  template class SaddlePointSolver<3>;
} // namespace semilunar::flow
