// SPDX-License-Identifier: LGPL-2.1-or-later
// The wall's solid by itself: stress from energy, tangent from stress, rigid motions, patch test,
// and the flag of the Turek-Hron benchmark under its weight (CSM1, CSM2).
#include "flow_tests.h"

#include <semilunar/flow/wall_matrix.h>
#include <semilunar/mesh/mesh.h>

using namespace semilunar;
using namespace semilunar::tests;

namespace
{
  template <int dim>
  void make_solid(Mesh<dim> &mesh, const std::vector<unsigned int> &n, const Point<dim> &corner)
  {
    dealii::GridGenerator::subdivided_hyper_rectangle(mesh, n, Point<dim>(), corner, true);
    for (const auto &cell : mesh.active_cell_iterators())
      cell->set_material_id(mesh::wall);
  }

  /// Fields of the nodes of a mesh.
  template <int dim>
  struct Nodes
  {
    Nodes(const Mesh<dim> &mesh, const unsigned int degree)
        : spaces(mesh, degree), reference(spaces.velocities())
    {
      const auto &element = spaces.velocity_dofs().get_fe();
      const dealii::MappingQ<dim> mapping(degree);
      std::vector<dealii::types::global_dof_index> dofs(element.dofs_per_cell);
      for (const auto &cell : spaces.velocity_dofs().active_cell_iterators())
        if (cell->is_locally_owned())
        {
          cell->get_dof_indices(dofs);
          for (unsigned int i = 0; i < dofs.size(); ++i)
            if (spaces.nodes()->in_local_range(dofs[i]))
            {
              const auto x =
                  mapping.transform_unit_to_real_cell(cell, element.get_unit_support_points()[i]);
              for (unsigned int c = 0; c < dim; ++c)
                reference(dim * dofs[i] + c) = x[c];
            }
        }
      spaces.make_readable_velocity(reference);
    }

    Vector map(const std::function<Tensor<1, dim>(const Point<dim> &)> &function) const
    {
      Vector result(spaces.velocities());
      for (unsigned int i = 0; i < spaces.nodes()->locally_owned_size(); ++i)
      {
        Point<dim> x;
        for (unsigned int c = 0; c < dim; ++c)
          x[c] = reference.local_element(dim * i + c);
        const auto y = function(x);
        for (unsigned int c = 0; c < dim; ++c)
          result.local_element(dim * i + c) = y[c];
      }
      spaces.make_readable_velocity(result);
      return result;
    }

    /// Sums at nodes of all cells and ranks.
    void finish(Vector &momentum) const
    {
      spaces.velocity_hanging().template fold<dim>(momentum.begin());
      momentum.compress(dealii::VectorOperation::add);
    }

    Spaces<dim> spaces;
    Vector reference;
  };

  double total(const double x)
  {
    return dealii::Utilities::MPI::sum(x, MPI_COMM_WORLD);
  }

  template <int dim>
  void derivatives(const std::string &material, const unsigned int degree)
  {
    Mesh<dim> mesh(MPI_COMM_WORLD);
    make_solid<dim>(mesh, std::vector<unsigned int>(dim, 2),
                    dim == 2 ? Point<dim>(1., 0.8)
                             : Point<dim>(1., 0.8) + Point<dim>::unit_vector(dim - 1));
    for (const auto &cell : mesh.active_cell_iterators())
      if (cell->is_locally_owned() && cell->center().norm() < 0.6)
        cell->set_refine_flag();
    mesh.execute_coarsening_and_refinement();
    const Nodes<dim> nodes(mesh, degree);
    WallParameters prm;
    prm.material = material;
    prm.youngs_modulus = 3.;
    prm.poisson_ratio = 0.3;
    prm.damping = 2.;
    prm.density = 1.5;
    const auto forms = WallForms<dim>::create(nodes.spaces, prm);
    forms->set_reference(nodes.reference);

    const auto wave = [](const Point<dim> &x, const double phase)
    {
      Tensor<1, dim> value;
      for (unsigned int c = 0; c < dim; ++c)
        value[c] = std::sin(2. * x[c] + x[(c + 1) % dim] + phase + c);
      return value;
    };
    const Vector x =
        nodes.map([&](const Point<dim> &X) { return Tensor<1, dim>(X) + 0.15 * wave(X, 0.); });
    const Vector v = nodes.map([&](const Point<dim> &X) { return wave(X, 1.); });
    const Vector w = nodes.map([&](const Point<dim> &X) { return wave(X, 2.); });
    Vector none(nodes.spaces.velocities());
    nodes.spaces.make_readable_velocity(none);

    const auto moved = [&](const double s)
    {
      Vector y(nodes.spaces.velocities());
      y.equ(1., x);
      y.add(s, v);
      nodes.spaces.make_readable_velocity(y);
      return y;
    };
    const auto internal = [&](const Vector &y)
    {
      Vector r(nodes.spaces.velocities());
      forms->add_residual(y, none, none, 0., r);
      nodes.finish(r);
      return r;
    };
    const double h = 1e-3;
    const auto derivative = [h](const auto &f)
    { return (8. * (f(h) - f(-h)) - (f(2. * h) - f(-2. * h))) / (12. * h); };
    const double work = internal(x) * v;
    const double energy_change =
        derivative([&](const double s) { return total(forms->energies(moved(s), none).strain); });
    const double force_change = derivative([&](const double s) { return internal(moved(s)) * w; });
    forms->linearise(x, 0.);
    Vector change(nodes.spaces.velocities());
    forms->add_jacobian(v, change);
    nodes.finish(change);

    // With inertia: velocities 1/alpha of positions, and mass and damping.
    const double alpha = 7.;
    forms->linearise(x, alpha);
    Vector dynamic(nodes.spaces.velocities()), mass(nodes.spaces.velocities());
    forms->add_jacobian(v, dynamic);
    nodes.finish(dynamic);
    forms->add_residual(nodes.reference, v, none, alpha, mass);
    nodes.finish(mass);
    const double kinetic = total(forms->energies(x, v).kinetic);
    if (first_rank())
    {
      log() << dim << "D, degree " << degree << ", " << material << std::endl;
      check("  work of stress against change of energy", work / energy_change - 1., 1e-9);
      check("  tangent against change of stress", (change * w) / force_change - 1., 1e-9);
    }
    const double with_mass = dynamic * w, static_part = change * w, mass_part = mass * w,
                 inertia_work = mass * v;
    if (first_rank())
    {
      check("  tangent with inertia", with_mass / (static_part / alpha + mass_part) - 1., 1e-10);
      check("  inertia and kinetic energy",
            inertia_work / (2. * (alpha + prm.damping) * kinetic) - 1., 1e-10);
    }

    // A rotation is free of stress; a linear map leaves no forces inside (patch test).
    const Vector rotated = nodes.map(
        [](const Point<dim> &X)
        {
          Tensor<1, dim> y = Tensor<1, dim>(X);
          y[0] = 3. + std::cos(2.) * X[0] - std::sin(2.) * X[1];
          y[1] = std::sin(2.) * X[0] + std::cos(2.) * X[1];
          return y;
        });
    const double turned = internal(rotated).linfty_norm();
    const Vector linear = nodes.map(
        [](const Point<dim> &X)
        {
          Tensor<1, dim> y = 1.2 * Tensor<1, dim>(X);
          y[0] += 0.3 * X[1];
          return y;
        });
    Vector patch = internal(linear);
    for (unsigned int i = 0; i < nodes.spaces.nodes()->locally_owned_size(); ++i)
      for (unsigned int c = 0; c < dim; ++c)
      {
        const double X = nodes.reference.local_element(dim * i + c);
        const double end = c == 1 ? 0.8 : 1.;
        if (X < 1e-10 || X > end - 1e-10)
          for (unsigned int d = 0; d < dim; ++d)
            patch.local_element(dim * i + d) = 0.;
      }
    const double left = patch.linfty_norm();
    const double smallest =
        dealii::Utilities::MPI::min(forms->smallest_determinant(linear), MPI_COMM_WORLD);
    if (first_rank())
    {
      check("  force of a rotation", turned, 1e-13);
      check("  patch test", left, 1e-13);
      check("  determinant of the linear map", smallest - std::pow(1.2, dim), 1e-12);
    }
  }

  /// Displacement of the tip in mm under the flag's weight.
  Tensor<1, 2> hanging_flag(const double shear_modulus, const unsigned int n_along,
                            const unsigned int n_across)
  {
    Mesh<2> mesh(MPI_COMM_WORLD);
    make_solid<2>(mesh, {n_along, n_across}, Point<2>(0.35, 0.02));
    Nodes<2> nodes(mesh, 2);
    // The root is a piece of the cylinder of radius 0.05 at (0.2, 0.2).
    nodes.reference = nodes.map(
        [](const Point<2> &x)
        {
          const double y = x[1] - 0.01, root = std::sqrt(0.0025 - y * y) + 0.2;
          return Tensor<1, 2>({root + (0.6 - root) * x[0] / 0.35, 0.2 + y});
        });
    nodes.spaces.make_readable_velocity(nodes.reference);
    WallParameters prm;
    prm.material = "St.Venant-Kirchhoff";
    prm.poisson_ratio = 0.4;
    prm.youngs_modulus = 2. * (1. + prm.poisson_ratio) * shear_modulus;
    prm.density = 1000.;
    prm.damping = 0.;
    prm.acceleration = {0., -2.};
    const auto forms = WallForms<2>::create(nodes.spaces, prm);
    forms->set_reference(nodes.reference);

    BoundaryFaces<2> faces(nodes.spaces);
    faces.update_geometry(nodes.reference);
    BoundaryConditions<2> bc;
    bc.set_wall(0);
    for (const unsigned int id : {1, 2, 3})
      bc.set_traction(id, [](const Point<2> &, const Tensor<1, 2> &, double)
                      { return Tensor<1, 2>(); });
    VelocityConstraints<2> clamped;
    clamped.reinit(nodes.spaces, faces, bc);
    WallNodes<2> wall_nodes(nodes.spaces);
    wall_nodes.reinit();
    WallMatrix<2> matrix(nodes.spaces, wall_nodes, true);
    matrix.reinit();

    Vector x(nodes.spaces.velocities()), none(nodes.spaces.velocities()), r(x), change(x);
    x.equ(1., nodes.reference);
    nodes.spaces.make_readable_velocity(none);
    // In steps of the load: Newton's method would stretch the flag first.
    for (const double load : {0.25, 0.5, 0.75, 1.})
    {
      prm.acceleration[1] = -2. * load;
      double first = 0.;
      for (unsigned int n = 0;; ++n)
      {
        nodes.spaces.make_readable_velocity(x);
        r.zero_out_ghost_values();
        r = 0.;
        forms->add_residual(x, none, none, 0., r);
        nodes.finish(r);
        clamped.mask(r);
        const double size = r.l2_norm();
        if (n == 0)
          first = size;
        if (size < 1e-6 * first)
          break;
        if (n == 12)
          check("  residual after 12 iterations", size / first, 1e-6);
        forms->linearise(x, 0.);
        matrix.assemble(*forms);
        matrix.factorise(clamped);
        matrix.solve(r, change);
        x.zero_out_ghost_values();
        x.add(-1., change);
      }
    }
    Tensor<1, 2> tip;
    for (unsigned int i = 0; i < nodes.spaces.nodes()->locally_owned_size(); ++i)
      if (std::abs(nodes.reference.local_element(2 * i) - 0.6) < 1e-10 &&
          std::abs(nodes.reference.local_element(2 * i + 1) - 0.2) < 1e-10)
        for (unsigned int c = 0; c < 2; ++c)
          tip[c] = 1e3 * (x.local_element(2 * i + c) - nodes.reference.local_element(2 * i + c));
    return tip;
  }
} // namespace

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const char *material : {"neo-Hookean", "St.Venant-Kirchhoff"})
  {
    derivatives<2>(material, 2);
    derivatives<2>(material, 3);
    derivatives<3>(material, 2);
  }
  if (dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1)
    return 0; // the matrix is of one rank
  // FeatFlow's table, level 5+1.
  log() << "CSM1" << std::endl;
  const auto csm1 = hanging_flag(0.5e6, 40, 4);
  check("  displacement of the tip along the flag", csm1[0] / -7.18767 - 1., 5e-3);
  check("  and across it", csm1[1] / -66.1023 - 1., 5e-3);
  log() << "CSM2" << std::endl;
  const auto csm2 = hanging_flag(2e6, 40, 4);
  check("  displacement of the tip along the flag", csm2[0] / -0.469 - 1., 5e-3);
  check("  and across it", csm2[1] / -16.9739 - 1., 5e-3);
}
