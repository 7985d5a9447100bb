// SPDX-License-Identifier: LGPL-2.1-or-later
// What holds an elastic wall besides itself: tissue around it, against an oscillator of one degree
// of freedom and a thick tube on springs; a prestress, against small changes of a thick tube's
// pressure.
#include "flow_tests.h"

#include <semilunar/core/units.h>
#include <semilunar/mesh/parameters.h>

#include <sstream>

using namespace semilunar;
using namespace semilunar::tests;

namespace
{
  template <int dim>
  Tensor<1, dim> no_traction(const Point<dim> &, const Tensor<1, dim> &, double)
  {
    return Tensor<1, dim>();
  }

  /// A stiff bar [0, 0.5] whose end at 0 stands on springs and dampers, and a column of fluid
  /// [0.5, 1.5] before it, together in motion. @return error of the displacement after half a
  /// period, relative to that of the oscillator
  double column_on_springs(const unsigned int n_steps)
  {
    const double length = 0.5, column = 1., velocity = 1e-2;
    WallParameters wall;
    wall.material = "St.Venant-Kirchhoff";
    wall.youngs_modulus = 1e6;
    wall.poisson_ratio = 0.3;
    wall.density = 2.;
    wall.damping = 0.;
    wall.support_stiffness = 100.;
    wall.support_damping = 5.;
    const double mass = wall.density * length + column;
    const double decay = 0.5 * wall.support_damping / mass;
    const double w = std::sqrt(wall.support_stiffness / mass - decay * decay);

    Mesh<2> mesh(MPI_COMM_WORLD);
    dealii::GridGenerator::subdivided_hyper_rectangle(mesh, {6, 2}, Point<2>(), Point<2>(1.5, 0.5),
                                                      true);
    for (const auto &cell : mesh.active_cell_iterators())
      if (cell->center()[0] < length)
        cell->set_material_id(mesh::wall);
    BoundaryConditions<2> bc;
    bc.set_traction(0, no_traction<2>);
    bc.set_traction(1, no_traction<2>);
    bc.set_slip(2);
    bc.set_slip(3);
    bc.support_wall({0});
    flow::Parameters prm;
    prm.linear_tolerance = 1e-7;
    Timers timers;
    FlowSolver<2> solver(prm, mesh, dealii::MappingQ<2>(2), bc, timers, &wall);
    solver.initialise(0., [=](const Point<2> &, double) { return Point<2>(velocity, 0.); });
    const double end = 0.5 * dealii::numbers::PI / w;
    for (unsigned int step = 0; step < n_steps; ++step)
      solver.advance(end / n_steps);
    const double exact = velocity / w * std::exp(-decay * end);
    double error = 0.;
    for (const unsigned int node : solver.wall()->nodes().owned())
      error =
          std::max(error, std::abs(solver.positions().local_element(2 * node) -
                                   solver.reference_positions().local_element(2 * node) - exact));
    return dealii::Utilities::MPI::max(error, MPI_COMM_WORLD) / exact;
  }

  /// A piece of a thick tube, held along its axis, under pressure from inside.
  struct Tube
  {
    static constexpr double inner = 1., outer = 1.2, modulus = 1e6;

    static WallParameters wall()
    {
      WallParameters result;
      result.youngs_modulus = modulus;
      result.poisson_ratio = 0.4;
      result.damping = 0.;
      return result;
    }

    /// Mean radial displacement inside and outside, and the largest other one.
    struct Displacement
    {
      double inside = 0., outside = 0., other = 0.;
    };

    struct Conditions
    {
      std::function<double(double)> inlet, outlet; ///< pressures over time
      bool free_ends = false; ///< and a ring in the middle that holds the wall; else planes do
    };

    /// Blood and wall of the tube, and what they need to live.
    struct Solver
    {
      Solver(const WallParameters &wall, const Conditions &tube)
          : mesh(make_mesh()), solver(parameters(tube), mesh->triangulation, dealii::MappingQ<3>(2),
                                      conditions(wall, tube, *mesh), timers, &wall)
      {
      }

      Timers timers;
      std::unique_ptr<mesh::Mesh<3>> mesh;
      FlowSolver<3> solver;
    };

    static std::unique_ptr<mesh::Mesh<3>> make_mesh()
    {
      mesh::MeshParameters shape;
      shape.shape = mesh::Shape::pipe;
      shape.pipe = mesh::TubeParameters::pipe(inner, 0.6);
      shape.pipe.n_cells_around = 12;
      shape.pipe.n_layers = 1;
      shape.pipe.n_cells_along = 2;
      shape.pipe.wall_thickness = outer - inner;
      shape.pipe.n_wall_layers = 1;
      return mesh::make_mesh<3>(shape, MPI_COMM_WORLD);
    }

    static flow::Parameters parameters(const Conditions &tube)
    {
      flow::Parameters prm;
      prm.linear_tolerance = 1e-8;
      prm.viscosity = tube.free_ends ? 300. : 10.; // no momentum in the flow through it
      return prm;
    }

    static BoundaryConditions<3> conditions(const WallParameters &wall, const Conditions &tube,
                                            const mesh::Mesh<3> &mesh)
    {
      const auto id = [&mesh](const char *name) { return mesh.boundary_id(name, ""); };
      BoundaryConditions<3> bc;
      bc.set_open(id("inlet"), std::make_shared<PrescribedPressure>(tube.inlet));
      bc.set_open(id("outlet"), std::make_shared<PrescribedPressure>(tube.outlet));
      for (const char *name : {"wall_inlet", "wall_outlet"})
        if (tube.free_ends)
          bc.set_traction(id(name), no_traction<3>);
        else
          bc.set_slip(id(name));
      if (tube.free_ends)
        bc.hold_wall([](const Point<3> &x) { return std::abs(x[2]) < 1e-6; });
      bc.set_traction(id("outer_wall"), no_traction<3>);
      if (wall.has_support())
        bc.support_wall({id("outer_wall")});
      return bc;
    }

    /// At rest, after the pressure has gone from one to another value.
    static Displacement settle(const WallParameters &wall, const double before, const double after,
                               const unsigned int n_steps = 4, const double dt = 1.)
    {
      const auto pressure = [after](double) { return after; };
      Solver tube(wall, {pressure, pressure});
      tube.solver.initialise(
          0., [](const Point<3> &, double) { return Tensor<1, 3>(); },
          [before](const Point<3> &, double) { return before; });
      for (unsigned int step = 0; step < n_steps; ++step)
        tube.solver.advance(dt); // the slowest oscillation has a period of a few ms
      return measure(tube.solver);
    }

    /// Along the axis, in a steady flow, per area of the inlet.
    static double force_of_ring(const WallParameters &wall, const Conditions &conditions,
                                const unsigned int n_steps, const double dt)
    {
      Solver tube(wall, conditions);
      tube.solver.initialise(0.);
      for (unsigned int step = 0; step < n_steps; ++step)
        tube.solver.advance(dt);
      return tube.solver.force_of_holds()[2] /
             tube.solver.area(tube.mesh->boundary_id("inlet", ""));
    }

    static Displacement measure(const FlowSolver<3> &solver)
    {
      double sums[4] = {}, other = 0.;
      for (const unsigned int node : solver.wall()->nodes().owned())
      {
        Tensor<1, 3> rest, move;
        for (unsigned int c = 0; c < 3; ++c)
        {
          rest[c] = solver.reference_positions().local_element(3 * node + c);
          move[c] = solver.positions().local_element(3 * node + c) - rest[c];
        }
        const double radius = std::hypot(rest[0], rest[1]);
        const Tensor<1, 3> normal({rest[0] / radius, rest[1] / radius, 0.});
        other = std::max(other, (move - (move * normal) * normal).norm());
        const int place = std::abs(radius - inner) < 1e-8   ? 0
                          : std::abs(radius - outer) < 1e-8 ? 2
                                                            : -1;
        if (place < 0)
          continue;
        sums[place] += 1.;
        sums[place + 1] += move * normal;
      }
      dealii::Utilities::MPI::sum(sums, MPI_COMM_WORLD, sums);
      return {sums[1] / sums[0], sums[3] / sums[2],
              dealii::Utilities::MPI::max(other, MPI_COMM_WORLD)};
    }
  };

  /// Plane strain: u = a r + b / r, sigma_rr = 2 (lambda + mu) a - 2 mu b / r^2.
  Tube::Displacement tube_on_springs(const WallParameters &wall, const double pressure)
  {
    const double la = wall.lame(), mu = wall.shear_modulus(), k = wall.support_stiffness;
    const double ri = Tube::inner, ro = Tube::outer;
    dealii::FullMatrix<double> matrix(2, 2);
    matrix(0, 0) = 2. * (la + mu);
    matrix(0, 1) = -2. * mu / (ri * ri);
    matrix(1, 0) = 2. * (la + mu) + k * ro;
    matrix(1, 1) = -2. * mu / (ro * ro) + k / ro;
    matrix.gauss_jordan();
    const double a = -pressure * matrix(0, 0), b = -pressure * matrix(1, 0);
    return {a * ri + b / ri, a * ro + b / ro, 0.};
  }
  /// A change of the pressure in a tube that balances another one: small displacements u(r) with
  /// stress C : grad u + grad u S0, S0 those of Lame's tube, and the normals that follow. By
  /// shooting with the Runge-Kutta method, the unknowns being u and the change of P_rr.
  Tube::Displacement prestressed_tube(const WallParameters &wall, const double balanced,
                                      const double change)
  {
    using State = dealii::Tensor<1, 2>;
    const double la = wall.lame(), mu = wall.shear_modulus(), ri = Tube::inner, ro = Tube::outer;
    const double area = ri * ri / (ro * ro - ri * ri);
    const auto derivative = [=](const double r, const State &y)
    {
      const double radial = balanced * area * (1. - ro * ro / (r * r)),
                   hoop = balanced * area * (1. + ro * ro / (r * r));
      State result;
      result[0] = (y[1] - la * y[0] / r) / (la + 2. * mu + radial);
      result[1] = ((la + 2. * mu + hoop) * y[0] / r + la * result[0] - y[1]) / r;
      return result;
    };
    const auto at_end = [&](State y)
    {
      const unsigned int n = 100;
      const double h = (ro - ri) / n;
      for (unsigned int i = 0; i < n; ++i)
      {
        const double r = ri + i * h;
        const State k1 = derivative(r, y), k2 = derivative(r + 0.5 * h, y + 0.5 * h * k1),
                    k3 = derivative(r + 0.5 * h, y + 0.5 * h * k2),
                    k4 = derivative(r + h, y + h * k3);
        y += h / 6. * (k1 + 2. * k2 + 2. * k3 + k4);
      }
      return y;
    };
    const State of_displacement = at_end(State({1., -balanced / ri})),
                of_pressure = at_end(State({0., -change}));
    const double inside = -of_pressure[1] / of_displacement[1];
    return {inside, inside * of_displacement[0] + of_pressure[0], 0.};
  }

  void compare(const std::string &what, const Tube::Displacement &found,
               const Tube::Displacement &exact)
  {
    if (!first_rank())
      return;
    std::fprintf(stderr, "%s: %g %g, %g %g, %g\n", what.c_str(), found.inside,
                 found.inside / exact.inside - 1., found.outside,
                 found.outside / exact.outside - 1., found.other / exact.inside);
    log() << what << std::endl;
    check("  radial displacement inside", found.inside / exact.inside - 1., 3e-4);
    check("  and outside, relative to that inside", (found.outside - exact.outside) / exact.inside,
          3e-4);
    check("  displacement along the wall", found.other / exact.inside, 1e-2);
  }
  /// A tube with free ends that is held by a ring: what drives the blood pulls at the ring.
  void held_tube(const WallParameters &wall, const unsigned int n_steps, const double dt)
  {
    const double pressure = 10.;
    Tube::Conditions conditions;
    conditions.inlet = [=](double) { return pressure; };
    conditions.outlet = [](double) { return 0.; };
    conditions.free_ends = true;
    const double pull = Tube::force_of_ring(wall, conditions, n_steps, dt);
    if (!first_rank())
      return;
    std::fprintf(stderr, "pull %g %g\n", pull, pull / pressure + 1.);
    log() << "Tube that a ring holds" << std::endl;
    check("  force of the ring", pull / pressure + 1., 1e-4);
  }
} // namespace

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::array<double, 3> error;
  for (unsigned int i = 0; i < 3; ++i)
    error[i] = column_on_springs(20 << i);
  if (first_rank())
  {
    std::fprintf(stderr, "column %g %g %g\n", error[0], error[1], error[2]);
    log() << "Column of fluid on a bar on springs and dampers" << std::endl;
    // the column becomes shorter by a thousandth as the bar moves into it
    check("  displacement", error[2], 1e-3);
    check("  order in time against 2",
          std::log2((error[0] - error[1]) / (error[1] - error[2])) - 2., 0.2);
  }
  const double pressure = 10.;
  if (dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1)
  {
    // Each rank factorises its part of the wall: too little for steps a thousand times as long as
    // an oscillation.
    WallParameters wall = Tube::wall();
    wall.support_stiffness = 1e5;
    wall.damping = 1e4;
    compare("Tube on springs", Tube::settle(wall, 0., pressure, 30, 5e-3),
            tube_on_springs(wall, pressure));
    wall.support_stiffness = 0.;
    held_tube(wall, 30, 5e-3);
    return 0;
  }
  for (const double stiffness : {0., 1e5, 1e8})
  {
    WallParameters wall = Tube::wall();
    wall.support_stiffness = stiffness;
    std::ostringstream what;
    what << "Tube on springs of " << stiffness << " dyn/cm^3";
    compare(what.str(), Tube::settle(wall, 0., pressure), tube_on_springs(wall, pressure));
  }

  WallParameters wall = Tube::wall();
  wall.prestress = 80.;
  const double balanced = mmHg * wall.prestress, change = 10.;
  const auto still = Tube::settle(wall, balanced, balanced);
  const auto exact = prestressed_tube(wall, balanced, change);
  const auto unstressed = tube_on_springs(wall, change);
  if (first_rank())
  {
    std::fprintf(stderr, "still %g %g, exact %g %g\n", still.inside, still.other, exact.inside,
                 unstressed.inside);
    log() << "Tube in balance with 80 mmHg" << std::endl;
    const double without = balanced / change * unstressed.inside;
    check("  displacement relative to that without prestress", still.inside / without, 1e-8);
    check("  displacement along the wall", still.other / without, 1e-8);
    check("  shooting without prestress against Lame",
          prestressed_tube(wall, 0., change).inside / unstressed.inside - 1., 1e-7);
    // else the next comparison would say nothing
    log() << "  prestress changes the stiffness: "
          << (std::abs(exact.inside / unstressed.inside - 1.) > 0.02 ? "yes" : "no") << std::endl;
  }
  // The area under pressure is that of the mesh that each step predicts: in long steps, its ovals
  // would grow. This damping comes to rest within 10 ms.
  wall.damping = 1e4;
  compare("  and 10 dyn/cm^2 more", Tube::settle(wall, balanced, balanced + change, 30, 5e-3),
          exact);
  held_tube(Tube::wall(), 4, 1.);
}
