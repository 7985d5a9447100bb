// SPDX-License-Identifier: LGPL-2.1-or-later
// Blood and elastic wall in one system: a column of fluid on an elastic bar, whose frequency is
// known for all ratios of the densities (added mass).
#include "flow_tests.h"

#include <semilunar/mesh/mesh.h>

using namespace semilunar;
using namespace semilunar::tests;

namespace
{
  /// Lowest root of rho_s c cot(w Ls/c) = rho_f L w.
  double bar_frequency(const double modulus, const double rho_s, const double length,
                       const double mass)
  {
    const double c = std::sqrt(modulus / rho_s);
    double low = 0., high = 0.5 * dealii::numbers::PI * c / length;
    for (unsigned int i = 0; i < 200; ++i)
    {
      const double w = 0.5 * (low + high);
      (rho_s * c / std::tan(w * length / c) > mass * w ? low : high) = w;
    }
    return low;
  }

  struct Result
  {
    double displacement_error = 0.;   ///< relative to the amplitude
    double pressure = 0., force = 0.; ///< of the interface, relative to the exact ones
    double n_linear = 0.;             ///< mean number of iterations of a step
  };

  /// The bar [0, 0.5] is fixed at 0, the fluid fills [0.5, 1.5], free at its end; the sides slip.
  template <int dim>
  Result column_on_bar(const double rho_s, const unsigned int n_steps_a_period,
                       const unsigned int n_steps, const unsigned int n_geometry = 1,
                       const std::string &prediction = "extrapolated")
  {
    const double length = 0.5, column = 1., velocity = 1e-2;
    WallParameters wall;
    wall.material = "St.Venant-Kirchhoff";
    wall.youngs_modulus = 100.;
    wall.poisson_ratio = 0.3;
    wall.density = rho_s;
    wall.damping = 0.;
    wall.max_geometry_iterations = n_geometry;
    wall.geometry_tolerance = 1e-12;
    wall.prediction = prediction;
    const double modulus = wall.lame() + 2. * wall.shear_modulus(), c = std::sqrt(modulus / rho_s);
    const double w = bar_frequency(modulus, rho_s, length, column);
    const double dt = 2. * dealii::numbers::PI / (w * n_steps_a_period);

    Mesh<dim> mesh(MPI_COMM_WORLD);
    Point<dim> end;
    std::vector<unsigned int> n(dim, 2);
    for (unsigned int d = 0; d < dim; ++d)
      end[d] = d == 0 ? length + column : 0.5;
    n[0] = 6;
    dealii::GridGenerator::subdivided_hyper_rectangle(mesh, n, Point<dim>(), end, true);
    for (const auto &cell : mesh.active_cell_iterators())
      if (cell->center()[0] < length)
        cell->set_material_id(mesh::wall);
    mesh.refine_global(dim == 2 ? 1 : 0);
    BoundaryConditions<dim> bc;
    bc.set_wall(0);
    bc.set_traction(1, [](const Point<dim> &, const Tensor<1, dim> &, double)
                    { return Tensor<1, dim>(); });
    for (unsigned int id = 2; id < 2 * dim; ++id)
      bc.set_slip(id);
    flow::Parameters prm;
    prm.linear_tolerance = 1e-8;
    Timers timers;
    FlowSolver<dim> solver(prm, mesh, dealii::MappingQ<dim>(2), bc, timers, &wall);
    solver.initialise(0.,
                      [=](const Point<dim> &x, double)
                      {
                        const double s =
                            x[0] < length ? std::sin(w * x[0] / c) / std::sin(w * length / c) : 1.;
                        return velocity * s * Point<dim>::unit_vector(0);
                      });
    Result result;
    const double amplitude = velocity / w;
    for (unsigned int step = 0; step < n_steps; ++step)
      result.n_linear += double(solver.advance(dt).n_linear) / n_steps;
    const double t = solver.time();
    double interface = 0.;
    for (unsigned int i = 0; i < solver.spaces().nodes()->locally_owned_size(); ++i)
      if (solver.wall()->nodes().at_interface(i))
        interface = std::max(interface, std::abs(solver.positions().local_element(dim * i) -
                                                 length - amplitude * std::sin(w * t)));
    result.displacement_error = dealii::Utilities::MPI::max(interface, MPI_COMM_WORLD) / amplitude;
    // rho w^2 displacement: the pressure at the interface, linear along the column.
    double largest = 0.;
    for (const double p : solver.pressure())
      largest = std::max(largest, std::abs(p));
    result.pressure = dealii::Utilities::MPI::max(largest, MPI_COMM_WORLD) /
                      (amplitude * w * w * column * std::abs(std::sin(w * t)));
    const double force = solver.force_on_blood({}, true)[0] / std::pow(0.5, dim - 1);
    result.force = -force / (amplitude * w * w * column * std::sin(w * t));
    return result;
  }
} // namespace

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::vector<double> ratios = {10., 1., 0.1, 0.001};
  if (dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1)
    ratios = {0.1};
  for (const double rho_s : ratios)
  {
    // At 1.25 periods the displacement is largest, at 1.125 both it and the velocity count.
    const Result coarse = column_on_bar<2>(rho_s, 40, 45), fine = column_on_bar<2>(rho_s, 80, 90);
    const Result tiny_steps = column_on_bar<2>(rho_s, 4000, 100);
    if (first_rank())
    {
      std::fprintf(stderr, "%g: %g %g %g, %g %g %g, p %g %g, f %g %g\n", rho_s,
                   coarse.displacement_error, fine.displacement_error,
                   tiny_steps.displacement_error, coarse.n_linear, fine.n_linear,
                   tiny_steps.n_linear, coarse.pressure, fine.pressure, coarse.force, fine.force);
      log() << "density of the bar " << rho_s << " times that of the fluid" << std::endl;
      check("  displacement: order in time below 2 by",
            std::max(0., 2. - std::log2(coarse.displacement_error / fine.displacement_error)), 0.2);
      check("  displacement", fine.displacement_error, 0.015);
      check("  displacement after 100 steps of a period's 4000th", tiny_steps.displacement_error,
            1e-4);
      check("  pressure at the interface", fine.pressure - 1., 0.02);
      check("  force on the interface", fine.force - fine.pressure, 1e-3);
    }
  }
  const Result plane = column_on_bar<2>(1., 40, 10), solid = column_on_bar<3>(1., 40, 10),
               iterated = column_on_bar<2>(1., 40, 10, 4),
               predicted = column_on_bar<2>(1., 40, 45, 1, "old velocity"),
               predicted_fine = column_on_bar<2>(1., 80, 90, 1, "old velocity");
  if (first_rank())
  {
    std::fprintf(stderr, "%g %g %g\n", plane.displacement_error, solid.displacement_error,
                 iterated.displacement_error);
    check("error in space against that in the plane",
          solid.displacement_error / plane.displacement_error - 1., 1e-3);
    check("geometry at the end of the step against the predicted one",
          iterated.displacement_error / plane.displacement_error - 1., 2e-2);
    check("mesh predicted with old velocities: order in time below 2 by",
          std::max(
              0., 2. - std::log2(predicted.displacement_error / predicted_fine.displacement_error)),
          0.2);
  }
}
