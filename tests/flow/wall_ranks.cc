// SPDX-License-Identifier: LGPL-2.1-or-later
// An elastic wall that stiffness holds together over several cells takes about as many Krylov
// iterations on several ranks as on one: a channel between an elastic plate and a rigid one.
#include "flow_tests.h"

#include <semilunar/mesh/mesh.h>

using namespace semilunar;
using namespace semilunar::tests;

namespace
{
  /// Largest number of iterations in four steps of 1 ms: a pressure sets in at one end.
  unsigned int iterations(const unsigned int n_cells_along)
  {
    const double thickness = 0.15, height = 1., length = 4.;
    const std::vector<std::vector<double>> spacing = {
        std::vector<double>(n_cells_along, length / n_cells_along),
        {height / 2., height / 4., height / 4., thickness}};
    Mesh<2> mesh(MPI_COMM_WORLD);
    dealii::GridGenerator::subdivided_hyper_rectangle(mesh, spacing, Point<2>(),
                                                      Point<2>(length, height + thickness), true);
    constexpr unsigned int clamped = 4;
    for (const auto &cell : mesh.active_cell_iterators())
    {
      const bool solid = cell->center()[1] > height;
      cell->set_material_id(solid ? mesh::wall : mesh::lumen);
      for (const auto &face : cell->face_iterators())
        if (solid && face->at_boundary() && face->boundary_id() < 2)
          face->set_boundary_id(clamped);
    }
    BoundaryConditions<2> bc;
    bc.set_open(0, std::make_shared<PrescribedPressure>([](double) { return 1e4; }));
    bc.set_open(1, std::make_shared<PrescribedPressure>([](double) { return 0.; }));
    bc.set_wall(2);
    bc.set_traction(3,
                    [](const Point<2> &, const Tensor<1, 2> &, double) { return Tensor<1, 2>(); });
    bc.set_wall(clamped);
    WallParameters wall; // of the artery: stiffness rules over lengths of about 1 cm
    wall.youngs_modulus = 1e7;
    wall.poisson_ratio = 0.45;
    wall.density = 1.;
    wall.damping = 1e4;
    flow::Parameters prm;
    prm.linear_tolerance = 1e-4;
    Timers timers;
    FlowSolver<2> solver(prm, mesh, dealii::MappingQ<2>(2), bc, timers, &wall);
    solver.initialise(0.);
    unsigned int largest = 0;
    for (unsigned int step = 0; step < 4; ++step)
      largest = std::max(largest, solver.advance(1e-3).n_linear);
    return largest;
  }
} // namespace

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const auto &[n_cells_along, bound] : {std::pair(8u, 15u), std::pair(16u, 18u)})
  {
    const unsigned int found = iterations(n_cells_along);
    if (!first_rank())
      continue;
    std::fprintf(stderr, "%u cells along: %u iterations\n", n_cells_along, found);
    check(std::to_string(n_cells_along) + " cells along: iterations beyond " +
              std::to_string(bound),
          found > bound ? found : 0., 0.);
  }
}
