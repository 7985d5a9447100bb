// SPDX-License-Identifier: LGPL-2.1-or-later
// Poiseuille flow, which the elements hold exactly, stays exact while the mesh is refined and
// coarsened; a run that is saved and loaded goes on bit for bit; numbers at Gauss points are
// carried.
#include "flow_tests.h"

using namespace semilunar;
using namespace semilunar::tests;

namespace
{
  constexpr double mu = 0.1, drop = 1.6; // pressure drop per length 2, profile 4 y (1-y)

  template <int dim>
  Tensor<1, dim> velocity(const Point<dim> &x, double)
  {
    return 4. * x[1] * (1. - x[1]) * Point<dim>::unit_vector(0);
  }

  template <int dim>
  double pressure(const Point<dim> &x, double)
  {
    return drop / 2. * (2. - x[0]);
  }

  template <int dim>
  std::unique_ptr<FlowSolver<dim>> make_solver(Mesh<dim> &mesh, Timers &timers)
  {
    flow::Parameters prm;
    prm.viscosity = mu;
    prm.viscous_form = "Laplacian";
    prm.linear_tolerance = 1e-11;
    BoundaryConditions<dim> bc;
    bc.set_velocity(0, velocity<dim>);
    bc.set_open(1, std::make_shared<PrescribedPressure>([](double) { return 0.; }));
    bc.set_wall(2);
    bc.set_wall(3);
    for (unsigned int id = 4; id < 2 * dim; ++id)
      bc.set_slip(id);
    return std::make_unique<FlowSolver<dim>>(prm, mesh, dealii::MappingQ<dim>(2), bc, timers);
  }

  template <int dim>
  void make_mesh(Mesh<dim> &mesh)
  {
    std::vector<unsigned int> cells(dim, 2);
    cells[0] = 4;
    Point<dim> corner = dim == 2 ? Point<dim>::unit_vector(1) : Point<dim>();
    for (unsigned int c = 0; c < dim; ++c)
      corner[c] = c == 0 ? 2. : 1.;
    dealii::GridGenerator::subdivided_hyper_rectangle(mesh, cells, Point<dim>(), corner, true);
  }

  /// Refine left of x = 0.9, coarsen to the right of it.
  template <int dim>
  void flag(Mesh<dim> &mesh, const bool left)
  {
    for (const auto &cell : mesh.active_cell_iterators())
      if (cell->is_locally_owned())
      {
        if ((cell->center()[0] < 0.9) == left)
          cell->set_refine_flag();
        else
          cell->set_coarsen_flag();
      }
  }

  template <int dim>
  void refine_and_coarsen()
  {
    Mesh<dim> mesh(MPI_COMM_WORLD);
    make_mesh(mesh);
    Timers timers;
    const auto solver = make_solver(mesh, timers);
    solver->initialise(0., velocity<dim>, pressure<dim>);
    Errors worst;
    for (unsigned int cycle = 0; cycle < 3; ++cycle)
    {
      flag(mesh, cycle % 2 == 0);
      solver->refine();
      const Errors carried = errors_of<dim>(*solver, velocity<dim>, pressure<dim>, false);
      for (const double dt : {0.1, 0.05})
        solver->advance(dt);
      const Errors after = errors_of<dim>(*solver, velocity<dim>, pressure<dim>, false);
      worst.velocity = std::max({worst.velocity, carried.velocity, after.velocity});
      worst.pressure = std::max({worst.pressure, carried.pressure, after.pressure});
    }
    if (!first_rank())
      return;
    log() << dim << "D, refined and coarsened to " << mesh.n_global_active_cells() << " cells"
          << std::endl;
    check("  velocity error", worst.velocity, 1e-9);
    check("  pressure error", worst.pressure, 1e-9);
  }

  /// What was accumulated in marked cells, quadratic in space, survives refinement.
  void numbers_at_points()
  {
    Mesh<2> mesh(MPI_COMM_WORLD);
    make_mesh(mesh);
    Timers timers;
    const auto solver = make_solver(mesh, timers);
    const auto shear = [](const Point<2> &x, double) {
      return Tensor<1, 2>({x[0] * x[0] * x[0] / 3. + x[0] * x[1] * x[1], 0.});
    };
    solver->initialise(0., velocity<2>, pressure<2>);
    auto &cells = solver->cells();
    cells.set_accumulated_grad_div(std::vector<Lanes>(solver->spaces().n_batches(), Lanes{} + 2.));
    // div u of this field is x^2 + y^2, of degree 2; the elements hold its interpolant.
    FlowSolver<2> &s = *solver;
    s.initialise(0., [&](const Point<2> &x, double t) { return shear(x, t); });
    cells.accumulate_divergence(s.velocity());
    const auto integral = [&]()
    {
      double sum = 0.;
      const auto &numbers = *cells.accumulated_pressure();
      const unsigned int n = 9;
      const dealii::QGauss<2> gauss(3);
      for (const auto &cell : mesh.active_cell_iterators())
        if (cell->is_locally_owned())
        {
          const CellLane where = s.spaces().lane_of(cell->active_cell_index());
          for (unsigned int q = 0; q < n; ++q)
            sum += numbers[where.batch * n + q][where.lane] * gauss.weight(q) * cell->measure();
        }
      return dealii::Utilities::MPI::sum(sum, MPI_COMM_WORLD);
    };
    const double before = integral();
    flag(mesh, true);
    s.refine();
    const double after = integral();
    if (!first_rank())
      return;
    log() << "accumulated at Gauss points: integral " << before << std::endl;
    check("  after refinement", after / before - 1., 1e-12);
  }

  void save_and_load()
  {
    const auto start = [](const Point<2> &x, double)
    { return velocity<2>(x, 0.) * (1. + 0.3 * std::sin(3. * x[0])); };
    double expected = 0., found = 0.;
    std::vector<double> numbers;
    {
      Mesh<2> mesh(MPI_COMM_WORLD);
      make_mesh(mesh);
      Timers timers;
      const auto solver = make_solver(mesh, timers);
      solver->initialise(0., start);
      flag(mesh, true);
      solver->refine();
      solver->advance(0.1);
      solver->advance(0.05);
      numbers = solver->save_state();
      mesh.save("flow_state");
      solver->advance(0.07);
      solver->advance(0.1);
      expected = solver->velocity().l2_norm() + solver->pressure().l2_norm();
    }
    {
      Mesh<2> mesh(MPI_COMM_WORLD);
      make_mesh(mesh);
      Timers timers;
      const auto solver = make_solver(mesh, timers);
      mesh.load("flow_state");
      solver->load_state(numbers);
      solver->advance(0.07);
      solver->advance(0.1);
      found = solver->velocity().l2_norm() + solver->pressure().l2_norm();
    }
    if (first_rank())
    {
      log() << "saved and loaded" << std::endl;
      check("  difference", found - expected, 0.);
    }
  }
} // namespace

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  refine_and_coarsen<2>();
  refine_and_coarsen<3>();
  numbers_at_points();
  save_and_load();
}
