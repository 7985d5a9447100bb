// SPDX-License-Identifier: LGPL-2.1-or-later
// Observed orders of convergence in space on manufactured solutions, cells with curved faces.
#include "flow_tests.h"

using namespace semilunar;
using namespace semilunar::tests;

template <int dim>
Tensor<1, dim> velocity(const Point<dim> &x, double)
{
  const double pi = dealii::numbers::PI;
  if constexpr (dim == 2)
    return Tensor<1, 2>(
        {std::sin(pi * x[0]) * std::cos(pi * x[1]), -std::cos(pi * x[0]) * std::sin(pi * x[1])});
  else
    return Tensor<1, 3>({std::sin(pi * x[0]) * std::cos(pi * x[1]) * std::cos(pi * x[2]),
                         std::cos(pi * x[0]) * std::sin(pi * x[1]) * std::cos(pi * x[2]),
                         -2. * std::cos(pi * x[0]) * std::cos(pi * x[1]) * std::sin(pi * x[2])});
}

template <int dim>
double pressure(const Point<dim> &x, double)
{
  return std::sin(2. * x[0]) * std::cos(x[1] + (dim == 3 ? x[2] : 0.));
}

template <int dim>
void orders(const unsigned int degree, const unsigned int first_level, const double mu)
{
  Errors before;
  for (unsigned int level = first_level; level < first_level + 2; ++level)
  {
    Mesh<dim> mesh(MPI_COMM_WORLD);
    dealii::GridGenerator::hyper_cube(mesh, 0., 1., true);
    mesh.refine_global(level);
    flow::Parameters prm;
    prm.viscosity = mu;
    prm.degree = degree;
    prm.nonlinear = "Newton";
    prm.linear_tolerance = 1e-3;
    prm.nonlinear_tolerance = 1e-9;
    prm.grad_div = 0.1;
    BoundaryConditions<dim> bc;
    for (unsigned int id = 0; id < 2 * dim; ++id)
      bc.set_velocity(id, velocity<dim>);
    Timers timers;
    FlowSolver<dim> solver(prm, mesh, dealii::MappingQ<dim>(degree), bc, timers);
    solver.set_mesh_motion(
        [](const Point<dim> &x, double)
        {
          Point<dim> moved = x;
          for (unsigned int c = 0; c < dim; ++c)
            moved[c] += 0.1 * std::sin(3. * x[(c + 1) % dim]) * x[c] * (1. - x[c]);
          return Tensor<1, dim>(moved);
        });
    solver.set_body_force(force_of<dim>(velocity<dim>, pressure<dim>, 1., mu));
    solver.initialise(0., velocity<dim>);
    for (unsigned int step = 0; step < 6; ++step)
      solver.advance(0.2);
    const Errors errors = errors_of<dim>(solver, velocity<dim>, pressure<dim>, true);
    if (level > first_level && first_rank())
    {
      log() << dim << "D, degree " << degree << ", viscosity " << mu << std::endl;
      check("  velocity: order below the optimal one by",
            std::max(0., degree + 1. - std::log2(before.velocity / errors.velocity)), 0.1);
      check("  pressure: order below the optimal one by",
            std::max(0., degree - std::log2(before.pressure / errors.pressure)), 0.15);
    }
    before = errors;
  }
}

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  orders<2>(2, 4, 1.);
  orders<2>(2, 4, 1e-2);
  orders<2>(3, 3, 1e-1);
  orders<3>(2, 2, 1.);
  orders<3>(2, 2, 1e-2);
}
