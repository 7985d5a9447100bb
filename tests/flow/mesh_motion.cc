// SPDX-License-Identifier: LGPL-2.1-or-later
// The mesh of the lumen follows a bent flag in a channel and a bulging tube: quality of its cells,
// planes that stay planes, and a uniform stream that the motion does not disturb.
#include "flow_tests.h"

#include <semilunar/flow/mesh_motion.h>
#include <semilunar/flow/scaled_jacobian.h>
#include <semilunar/mesh/tube.h>

using namespace semilunar;
using namespace semilunar::tests;

namespace
{
  template <int dim>
  Vector positions_of(const Spaces<dim> &spaces, const dealii::Mapping<dim> &mapping)
  {
    Vector x(spaces.velocities());
    const auto &element = spaces.velocity_dofs().get_fe();
    std::vector<dealii::types::global_dof_index> dofs(element.dofs_per_cell);
    for (const auto &cell : spaces.velocity_dofs().active_cell_iterators())
      if (!cell->is_artificial())
      {
        cell->get_dof_indices(dofs);
        for (unsigned int i = 0; i < dofs.size(); ++i)
          if (spaces.nodes()->in_local_range(dofs[i]))
          {
            const auto p =
                mapping.transform_unit_to_real_cell(cell, element.get_unit_support_points()[i]);
            for (unsigned int c = 0; c < dim; ++c)
              x(dim * dofs[i] + c) = p[c];
          }
      }
    spaces.make_readable_velocity(x);
    return x;
  }

  template <int dim>
  struct MovingMesh
  {
    MovingMesh(const Mesh<dim> &mesh, const dealii::Mapping<dim> &mapping,
               const BoundaryConditions<dim> &bc)
        : spaces(mesh, 2), reference(positions_of(spaces, mapping)), nodes(spaces), faces(spaces),
          motion(spaces, nodes, bc)
    {
      nodes.reinit();
      faces.update_geometry(reference);
      motion.reinit(reference, faces);
    }

    /// @param wall displacement of the wall's nodes
    Vector move(const std::function<Tensor<1, dim>(const Point<dim> &)> &wall)
    {
      Vector x(spaces.velocities());
      x.equ(1., reference);
      for (unsigned int i = 0; i < spaces.nodes()->locally_owned_size(); ++i)
        if (nodes.in_wall(i))
        {
          Point<dim> X;
          for (unsigned int c = 0; c < dim; ++c)
            X[c] = reference.local_element(dim * i + c);
          const auto d = wall(X);
          for (unsigned int c = 0; c < dim; ++c)
            x.local_element(dim * i + c) += d[c];
        }
      n_iterations = motion.solve(x);
      return x;
    }

    Spaces<dim> spaces;
    Vector reference;
    WallNodes<dim> nodes;
    BoundaryFaces<dim> faces;
    MeshMotion<dim> motion;
    unsigned int n_iterations = 0;
  };

  /// A flag of length 1 in a channel of height 1, bent to a parabola.
  Tensor<1, 2> bend(const Point<2> &x, const double tip)
  {
    const double s = std::max(0., x[0] - 0.5), slope = 2. * tip * s;
    const double y = x[1] - 0.5;
    return Tensor<1, 2>(
        {-y * slope / std::sqrt(1. + slope * slope) - tip * tip * s * s * s * 2. / 3.,
         tip * s * s + y * (1. / std::sqrt(1. + slope * slope) - 1.)});
  }

  void flag()
  {
    Mesh<2> mesh(MPI_COMM_WORLD);
    dealii::GridGenerator::subdivided_hyper_rectangle(mesh, {24, 10}, Point<2>(), Point<2>(2.4, 1.),
                                                      true);
    mesh.refine_global(1);
    // Cells that hang at the interface and elsewhere.
    for (const auto &cell : mesh.active_cell_iterators())
      if (cell->is_locally_owned() && cell->center().distance(Point<2>(1.5, 0.5)) < 0.2)
        cell->set_refine_flag();
    mesh.execute_coarsening_and_refinement();
    const auto set_material = [&mesh](const dealii::types::material_id id)
    {
      for (const auto &cell : mesh.active_cell_iterators())
        if (!cell->is_artificial() && std::abs(cell->center()[1] - 0.5) < 0.05 &&
            cell->center()[0] > 0.5 && cell->center()[0] < 1.5)
          cell->set_material_id(id);
    };
    set_material(mesh::wall);
    const Tensor<1, 2> stream({1., 0.5});
    const VectorFunction<2> u = [=](const Point<2> &, double) { return stream; };
    BoundaryConditions<2> bc;
    for (const unsigned int id : {0, 2, 3})
      bc.set_velocity(id, u);
    bc.set_open(1, std::make_shared<PrescribedPressure>([](double) { return 3.; }));
    const dealii::MappingQ<2> mapping(2);
    MovingMesh<2> moving(mesh, mapping, bc);

    // The flow sees the same cells as lumen.
    set_material(mesh::lumen);
    flow::Parameters prm;
    prm.viscosity = 1.; // the mesh moves by several cells in a step
    prm.linear_tolerance = 1e-11;
    Timers timers;
    FlowSolver<2> solver(prm, mesh, mapping, bc, timers);
    solver.initialise(0., u);
    double smallest = 1.;
    unsigned int n = 0;
    for (unsigned int step = 1; step <= 6; ++step)
    {
      const double tip = 0.2 * std::sin(step * 0.25 * dealii::numbers::PI);
      const Vector x = moving.move([tip](const Point<2> &X) { return bend(X, tip); });
      smallest = std::min(smallest, min_scaled_jacobian(moving.spaces, x));
      n = std::max(n, moving.n_iterations);
      solver.move_mesh(x);
      solver.solve_step();
      solver.accept_step();
    }
    const Errors e = errors_of<2>(
        solver, u, [](const Point<2> &, double) { return 3.; }, false);
    if (first_rank())
    {
      std::fprintf(stderr, "flag: %g, %u iterations\n", smallest, n);
      log() << "bent flag" << std::endl;
      check("  smallest scaled Jacobian below 0.3 by", std::max(0., 0.3 - smallest), 0.);
      check("  iterations beyond 25", std::max(0., n - 25.), 0.);
      check("  velocity error of a uniform stream", e.velocity, 1e-8);
      check("  pressure error", e.pressure, 1e-7);
    }
  }

  /// An elastic tube that bulges by 30 percent in its middle.
  void tube()
  {
    mesh::TubeParameters tube = mesh::TubeParameters::pipe(1., 6.);
    tube.n_cells_around = 18;
    tube.wall_thickness = 0.1;
    tube.n_wall_layers = 1;
    mesh::Mesh<3> mesh(MPI_COMM_WORLD);
    mesh::make_tube(mesh, tube, "Mesh/Pipe");
    BoundaryConditions<3> bc;
    for (const auto &[name, id] : mesh.boundary_ids)
      bc.set_slip(id);
    const dealii::MappingQ<3> mapping(2);
    MovingMesh<3> moving(mesh.triangulation, mapping, bc);
    const double before = min_scaled_jacobian(moving.spaces, moving.reference);
    const Vector x = moving.move(
        [](const Point<3> &X)
        {
          const double bulge = 0.3 * std::exp(-X[2] * X[2]);
          return Tensor<1, 3>({bulge * X[0], bulge * X[1], 0.});
        });
    const double after = min_scaled_jacobian(moving.spaces, x);
    double off = 0., inside = 0., moved = 0.;
    for (unsigned int i = 0; i < moving.spaces.nodes()->locally_owned_size(); ++i)
    {
      const double Z = moving.reference.local_element(3 * i + 2);
      const double z = x.local_element(3 * i + 2);
      if (std::abs(std::abs(Z) - 3.) < 1e-10)
        off = std::max(off, std::abs(z - Z));
      const double R = std::hypot(moving.reference.local_element(3 * i),
                                  moving.reference.local_element(3 * i + 1));
      const double r = std::hypot(x.local_element(3 * i), x.local_element(3 * i + 1));
      if (std::abs(Z) < 1e-10 && R > 1e-10)
      {
        inside = std::max(inside, r / R);
        moved = std::max(moved, 1. / (r / R));
      }
    }
    off = dealii::Utilities::MPI::max(off, MPI_COMM_WORLD);
    inside = dealii::Utilities::MPI::max(inside, MPI_COMM_WORLD);
    moved = dealii::Utilities::MPI::max(moved, MPI_COMM_WORLD);
    if (first_rank())
    {
      std::fprintf(stderr, "tube: %g to %g, %g %g\n", before, after, inside, moved);
      log() << "bulging tube" << std::endl;
      check("  loss of the smallest scaled Jacobian", before - after, 0.15);
      check("  planes of the ends", off, 1e-12);
      check("  largest stretch of a radius beyond the wall's", std::max(0., inside - 1.3), 0.05);
      check("  a radius that does not grow", std::max(0., moved - 1.), 0.);
    }
  }
} // namespace

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  flag();
  tube();
}
