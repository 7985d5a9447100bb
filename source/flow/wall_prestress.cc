// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/flow/tensor_kernel.h>
#include <semilunar/flow/wall_matrix.h>
#include <semilunar/flow/wall_prestress.h>

#include <deal.II/base/aligned_vector.h>
#include <deal.II/base/mpi.h>
#include <deal.II/lac/solver_cg.h>

#include <cmath>

namespace semilunar::flow
{
  namespace
  {
    /// Of the balance at rest, relative to the load.
    constexpr double tolerance = 1e-9;
    /// Inertia of the preconditioner in units of stiffness over squared length: what nothing holds
    /// may move freely.
    constexpr double regularisation = 1.;

    /// The wall at rest: stiffness, and a preconditioner for it.
    template <int dim>
    class WallAtRest
    {
    public:
      WallAtRest(const Spaces<dim> &spaces, const WallNodes<dim> &nodes,
                 const VelocityConstraints<dim> &constraints, const Vector &reference,
                 const WallParameters &prm, WallForms<dim> &forms)
          : spaces(spaces), constraints(constraints), forms(forms), matrix(spaces, nodes, false)
      {
        const double volume =
            dealii::Utilities::MPI::sum(forms.reference_volume(), spaces.communicator());
        const double squared =
            regularisation * prm.youngs_modulus / (prm.density * std::pow(volume, 2. / dim));
        // inertia (inertia + damping) = squared
        const double half = 0.5 * prm.damping;
        forms.linearise(
            reference, prm.density > 0. ? squared / (half + std::sqrt(half * half + squared)) : 1.);
        matrix.reinit();
        matrix.assemble(forms);
        matrix.factorise(constraints);
        forms.linearise(reference, 0.);
      }

      void vmult(Vector &result, const Vector &x) const
      {
        spaces.make_readable_velocity(x);
        result.zero_out_ghost_values();
        result = 0.;
        forms.add_jacobian(x, result);
        spaces.velocity_hanging().template fold<dim>(result.begin());
        result.compress(dealii::VectorOperation::add);
        constraints.mask(result);
        x.zero_out_ghost_values();
      }

      struct Preconditioner
      {
        const WallAtRest &wall;
        void vmult(Vector &result, const Vector &x) const
        {
          result = 0.;
          wall.matrix.solve(x, result);
          wall.constraints.mask(result);
        }
      };

    private:
      const Spaces<dim> &spaces;
      const VelocityConstraints<dim> &constraints;
      WallForms<dim> &forms;
      WallMatrix<dim> matrix;
    };
  } // namespace

  template <int dim>
  Vector pressure_load(const Spaces<dim> &spaces, const WallNodes<dim> &nodes,
                       const CellForms<dim> &cells, const BoundaryFaces<dim> &faces,
                       const double pressure)
  {
    const int n_u = power(spaces.degree() + 1, dim), n_p = power(spaces.degree(), dim);
    dealii::AlignedVector<Lanes> divergence(n_u * n_p * dim);
    Vector load(spaces.velocities());
    for (unsigned int batch = 0; batch < spaces.n_owned_batches(); ++batch)
    {
      cells.divergence_matrix(batch, divergence.data());
      for (unsigned int lane = 0; lane < spaces.n_filled_lanes(batch); ++lane)
        for (int i = 0; i < n_p; ++i)
          for (int j = 0; j < n_u; ++j)
            for (int c = 0; c < dim; ++c)
              load.local_element(dim * spaces.velocity_nodes(batch)[j][lane] + c) -=
                  pressure * divergence[(i * n_u + j) * dim + c][lane];
    }
    for (const auto &[id, part] : faces.parts())
      faces.add_lumen_normals(id, -pressure, load);
    spaces.velocity_hanging().template fold<dim>(load.begin());
    load.compress(dealii::VectorOperation::add);
    for (unsigned int node = 0; node < spaces.nodes()->locally_owned_size(); ++node)
      if (!nodes.in_wall(node)) // but for rounding
        for (unsigned int c = 0; c < dim; ++c)
          load.local_element(dim * node + c) = 0.;
    return load;
  }

  template <int dim>
  void prestress(const Spaces<dim> &spaces, const WallNodes<dim> &nodes,
                 const VelocityConstraints<dim> &constraints, Vector load, const Vector &reference,
                 const WallParameters &prm, WallForms<dim> &forms)
  {
    constraints.mask(load);
    const WallAtRest<dim> wall(spaces, nodes, constraints, reference, prm, forms);
    Vector displacement(spaces.velocities());
    const double size = load.l2_norm();
    dealii::SolverControl control(1000, tolerance * size, false, false);
    try
    {
      dealii::SolverCG<Vector>(control).solve(wall, displacement, load,
                                              typename WallAtRest<dim>::Preconditioner{wall});
    }
    catch (const dealii::SolverControl::NoConvergence &)
    {
      throw NumericsError("the prestress of the wall was not found: is it held where the blood "
                          "pushes it?",
                          "", "");
    }
    spaces.make_readable_velocity(displacement);
    forms.set_prestress(displacement);
  }

#define INSTANTIATE(dim)                                                                           \
  template Vector pressure_load(const Spaces<dim> &, const WallNodes<dim> &,                       \
                                const CellForms<dim> &, const BoundaryFaces<dim> &, double);       \
  template void prestress(const Spaces<dim> &, const WallNodes<dim> &,                             \
                          const VelocityConstraints<dim> &, Vector, const Vector &,                \
                          const WallParameters &, WallForms<dim> &)
  INSTANTIATE(2);
  INSTANTIATE(3);
#undef INSTANTIATE
} // namespace semilunar::flow
