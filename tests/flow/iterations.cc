// SPDX-License-Identifier: LGPL-2.1-or-later
// Krylov iterations of steps at Re = 10,000 stay bounded under refinement and from small to large
// steps: a duct with cells clustered toward its walls, from a velocity profile with waves on it.
#include "flow_tests.h"

#include <deal.II/grid/grid_tools.h>

using namespace semilunar;
using namespace semilunar::tests;

namespace
{
  constexpr double width = 2.5, length = 8.; // cm

  void make_duct(Mesh<3> &mesh, const unsigned int n)
  {
    dealii::GridGenerator::subdivided_hyper_rectangle(mesh, {n, n, 2 * n}, Point<3>(-1., -1., 0.),
                                                      Point<3>(1., 1., length), true);
    const auto clustered = [](const double s) { return 0.5 * width * s * (1.6 - 0.6 * s * s); };
    dealii::GridTools::transform(
        [&](const Point<3> &x) { return Point<3>(clustered(x[0]), clustered(x[1]), x[2]); }, mesh);
  }

  /// Largest number of iterations in four steps.
  unsigned int iterations(const unsigned int n, const double dt, double &cfl)
  {
    Mesh<3> mesh(MPI_COMM_WORLD);
    make_duct(mesh, n);
    flow::Parameters prm; // Re = 1 * 120 * 2.5 / 0.03 = 10,000
    BoundaryConditions<3> bc;
    for (const unsigned int id : {0, 1, 2, 3})
      bc.set_wall(id);
    bc.set_open(4, std::make_shared<PrescribedPressure>([](double) { return 2e4; }));
    bc.set_open(5, std::make_shared<Resistance>(0., 25.));
    Timers timers;
    FlowSolver<3> solver(prm, mesh, dealii::MappingQ<3>(2), bc, timers);
    solver.initialise(
        0.,
        [](const Point<3> &x, double)
        {
          const double a = 2. * x[0] / width, b = 2. * x[1] / width;
          const double plug = 120. * (1. - std::pow(a, 8)) * (1. - std::pow(b, 8));
          return plug * Tensor<1, 3>({0.1 * std::sin(3. * x[2]), 0.1 * std::cos(2. * x[2]), 1.});
        });
    unsigned int largest = 0;
    for (unsigned int step = 0; step < 4; ++step)
    {
      const StepReport report = solver.advance(dt);
      largest = std::max(largest, report.n_linear);
      cfl = report.cfl;
    }
    return largest;
  }
} // namespace

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const unsigned int n : {4, 8})
    for (const double dt : {1e-4, 1e-3, 1e-2})
    {
      // CFL numbers: below 1 for the small steps, 5 and 10 for the large one.
      const unsigned int bound = dt > 5e-3 ? 45 : 18;
      double cfl = 0.;
      const unsigned int found = iterations(n, dt, cfl);
      if (!first_rank())
        continue;
      std::printf("n = %u, dt = %g: CFL %.2f, %u iterations\n", n, dt, cfl, found);
      check("n = " + std::to_string(n) + ", dt = " + std::to_string(dt) + ": iterations beyond " +
                std::to_string(bound),
            found > bound ? found : 0., 0.);
    }
}
