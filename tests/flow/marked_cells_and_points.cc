// SPDX-License-Identifier: LGPL-2.1-or-later
// What immersed structures use, in a flow by itself: forces and drag at points against forces per
// volume and Darcy's law, and grad-div that accumulates against a fluid at rest.
#include "flow_tests.h"

using namespace semilunar;
using namespace semilunar::tests;

namespace
{
  std::shared_ptr<PressureModel> constant(const double pressure)
  {
    return std::make_shared<PrescribedPressure>([=](double) { return pressure; });
  }

  /// A point in each Gauss point of all cells, with a force per volume and a drag per volume and
  /// velocity.
  template <int dim>
  std::vector<PointTerm<dim>> points_everywhere(const FlowSolver<dim> &solver,
                                                const VectorFunction<dim> &force, const double drag)
  {
    const auto &dofs = solver.spaces().velocity_dofs();
    const dealii::QGauss<dim> gauss(solver.spaces().degree() + 1);
    dealii::FEValues<dim> values(solver.mapping(), dofs.get_fe(), gauss,
                                 dealii::update_JxW_values | dealii::update_quadrature_points);
    std::vector<PointTerm<dim>> terms;
    for (const auto &cell : dofs.active_cell_iterators())
      if (cell->is_locally_owned())
      {
        values.reinit(cell);
        for (unsigned int q = 0; q < gauss.size(); ++q)
          terms.push_back({cell->active_cell_index(), gauss.point(q),
                           values.JxW(q) * drag * dealii::unit_symmetric_tensor<dim>(),
                           values.JxW(q) * force(values.quadrature_point(q), 0.),
                           values.JxW(q) * drag});
      }
    return terms;
  }

  /// Norm of the velocity in a box that a force stirs, given per volume or at points.
  template <int dim>
  double stirred(const bool at_points)
  {
    Mesh<dim> mesh(MPI_COMM_WORLD);
    dealii::GridGenerator::hyper_cube(mesh, 0., 1.);
    mesh.refine_global(2);
    mesh.begin_active()->set_refine_flag();
    mesh.execute_coarsening_and_refinement();
    flow::Parameters prm;
    prm.linear_tolerance = 1e-11;
    prm.supg = false; // it tests forces per volume as well
    BoundaryConditions<dim> bc;
    bc.set_wall(0);
    Timers timers;
    FlowSolver<dim> solver(prm, mesh, dealii::MappingQ<dim>(2), bc, timers);
    const VectorFunction<dim> force = [](const Point<dim> &x, double)
    {
      Tensor<1, dim> f;
      f[0] = x[1] * x[1];
      return f;
    };
    if (at_points)
      solver.points().set(points_everywhere<dim>(solver, force, 0.));
    else
      solver.set_body_force(force);
    solver.initialise(0.);
    for (unsigned int step = 0; step < 3; ++step)
      solver.advance(0.2);
    return solver.velocity().l2_norm();
  }

  template <int dim>
  void forces()
  {
    const double at_points = stirred<dim>(true), per_volume = stirred<dim>(false);
    if (first_rank())
      check("forces at points and per volume, " + std::to_string(dim) + "D, differ",
            at_points / per_volume - 1., 1e-8);
  }

  /// Plug flow through points that resist: dp/dx = drag u, whatever the drag.
  void darcy(const double drag)
  {
    const double length = 4., dp = 8.;
    Mesh<2> mesh(MPI_COMM_WORLD);
    dealii::GridGenerator::subdivided_hyper_rectangle(mesh, {8, 2}, Point<2>(),
                                                      Point<2>(length, 1.), true);
    flow::Parameters prm;
    prm.linear_tolerance = 1e-8;
    BoundaryConditions<2> bc;
    bc.set_slip(2);
    bc.set_slip(3);
    bc.set_open(0, constant(dp), 0.); // no backflow term: it takes rho u^2 / 2 where fluid enters
    bc.set_open(1, constant(0.), 0.);
    Timers timers;
    FlowSolver<2> solver(prm, mesh, dealii::MappingQ<2>(2), bc, timers);
    const VectorFunction<2> none = [](const Point<2> &, double) { return Tensor<1, 2>(); };
    solver.points().set(points_everywhere<2>(solver, none, drag));
    solver.initialise(0.);
    const double tau = prm.density / drag;
    unsigned int iterations = 0;
    for (unsigned int step = 0; step < 200; ++step)
      iterations = std::max(iterations, solver.advance(0.1 * tau).n_linear);
    const double speed = solver.flow_rate(1);
    if (first_rank())
    {
      check("velocity through points with drag " + std::to_string(int(drag)),
            speed / (dp / (length * drag)) - 1., 1e-6);
      check("  iterations beyond 40", iterations > 40 ? iterations : 0., 0.);
    }
  }

  /// Velocities in a closed box under the gradient of 100 (x^4 + x^2 y^2): the fluid is at rest,
  /// but the pressure space does not hold the potential.
  double at_rest(const double weight)
  {
    Mesh<2> mesh(MPI_COMM_WORLD);
    dealii::GridGenerator::hyper_cube(mesh, 0., 1.);
    mesh.refine_global(2);
    flow::Parameters prm;
    prm.viscosity = 0.1;
    prm.linear_tolerance = 1e-9;
    prm.convective_form = "none";
    BoundaryConditions<2> bc;
    bc.set_wall(0);
    Timers timers;
    FlowSolver<2> solver(prm, mesh, dealii::MappingQ<2>(2), bc, timers);
    solver.set_body_force(
        [](const Point<2> &x, double)
        {
          const double a = x[0], b = x[1];
          return 100. * Tensor<1, 2>({4. * a * a * a + 2. * a * b * b, 2. * a * a * b});
        });
    solver.initialise(0.);
    if (weight > 0.)
      solver.cells().set_accumulated_grad_div(
          std::vector<Lanes>(solver.spaces().n_batches(), Lanes{} + weight));
    for (unsigned int step = 0; step < 30; ++step)
    {
      solver.advance(0.1);
      if (weight > 0.)
        solver.cells().accumulate_divergence(solver.velocity());
    }
    return solver.velocity().l2_norm();
  }

  void accumulated()
  {
    const double without = at_rest(0.), with = at_rest(5.);
    if (first_rank())
      check("spurious velocity that is left under a gradient", with / without, 0.1);
  }
} // namespace

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  forces<2>();
  forces<3>();
  darcy(1.);
  darcy(100.);
  darcy(10000.);
  accumulated();
}
