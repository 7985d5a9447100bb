// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/flow/schur_preconditioner.h>
#include <semilunar/flow/tensor_kernel.h>

#include <deal.II/base/aligned_vector.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>
#include <deal.II/lac/trilinos_vector.h>

namespace semilunar::flow
{
  namespace
  {
    using dealii::TrilinosWrappers::SparsityPattern;
    using Masters = std::vector<HangingNodes::Master>;

    /// Calls visit(batch, lane, i, pressure masters, j, velocity masters) for all pairs of nodes of
    /// owned cells.
    template <int dim, class Visit>
    void for_all_pairs(const Spaces<dim> &spaces, const Visit &visit)
    {
      const int n_u = power(spaces.degree() + 1, dim), n_p = power(spaces.degree(), dim);
      std::vector<Masters> velocity(n_u), pressure(n_p);
      for (unsigned int batch = 0; batch < spaces.n_owned_batches(); ++batch)
        for (unsigned int lane = 0; lane < spaces.n_filled_lanes(batch); ++lane)
        {
          for (int j = 0; j < n_u; ++j)
            spaces.velocity_hanging().masters_of(spaces.velocity_nodes(batch)[j][lane],
                                                 velocity[j]);
          for (int i = 0; i < n_p; ++i)
            spaces.pressure_hanging().masters_of(spaces.pressure_nodes(batch)[i][lane],
                                                 pressure[i]);
          for (int i = 0; i < n_p; ++i)
            for (int j = 0; j < n_u; ++j)
              visit(batch, lane, i, pressure[i], j, velocity[j]);
        }
    }

    /// Owned nodes that hang.
    std::vector<unsigned int> owned_hanging(const HangingNodes &hanging,
                                            const dealii::Utilities::MPI::Partitioner &nodes)
    {
      std::vector<unsigned int> result;
      for (unsigned int node = 0; node < nodes.locally_owned_size(); ++node)
        if (hanging.hangs(node))
          result.push_back(node);
      return result;
    }

    /// Calls visit(row, column) for entries, in empty rows, that give the empty columns of hanging
    /// pressures, and of those inside a wall, diagonal entries in B D^-1 B^T: where a pressure
    /// hangs, so do more velocities.
    template <int dim, class Visit>
    void for_empty_columns(const Spaces<dim> &spaces, const WallEquations<dim> *wall,
                           const Visit &visit)
    {
      auto velocities = owned_hanging(spaces.velocity_hanging(), *spaces.nodes());
      auto pressures = owned_hanging(spaces.pressure_hanging(), *spaces.pressures());
      if (wall)
      {
        for (const unsigned int node : wall->nodes().owned())
          if (!wall->nodes().at_interface(node))
            velocities.push_back(node);
        const auto &idle = wall->nodes().idle_pressures();
        pressures.insert(pressures.end(), idle.begin(), idle.end());
      }
      AssertThrow(velocities.size() >= pressures.size(), dealii::ExcInternalError());
      for (unsigned int i = 0; i < pressures.size(); ++i)
        visit(dim * spaces.nodes()->local_to_global(velocities[i]),
              spaces.pressures()->local_to_global(pressures[i]));
    }

    template <int dim>
    SparsityPattern gradient_pattern(const Spaces<dim> &spaces, const WallEquations<dim> *wall)
    {
      SparsityPattern pattern(spaces.velocities()->locally_owned_range(),
                              spaces.pressures()->locally_owned_range(), spaces.communicator());
      for_all_pairs(spaces,
                    [&](unsigned int, unsigned int, int, const Masters &pressures, int,
                        const Masters &velocities)
                    {
                      for (const auto &p : pressures)
                        for (const auto &u : velocities)
                          for (unsigned int c = 0; c < dim; ++c)
                            pattern.add(dim * spaces.nodes()->local_to_global(u.node) + c,
                                        spaces.pressures()->local_to_global(p.node));
                    });
      for_empty_columns(spaces, wall,
                        [&](const auto row, const auto column) { pattern.add(row, column); });
      pattern.compress();
      return pattern;
    }

    /// Without its constrained directions.
    template <int dim>
    dealii::Tensor<1, dim> projected(dealii::Tensor<1, dim> vector,
                                     const typename VelocityConstraints<dim>::Entry *constraint)
    {
      if (constraint)
        for (unsigned int d = 0; d < constraint->n; ++d)
          vector -= (vector * constraint->directions[d]) * constraint->directions[d];
      return vector;
    }
  } // namespace

  template <int dim>
  void SchurPreconditioner<dim>::assemble_gradient(const Equations<dim> &equations)
  {
    const Spaces<dim> &spaces = equations.spaces();
    gradient.reinit(gradient_pattern(spaces, equations.wall()));
    const int n_u = power(spaces.degree() + 1, dim), n_p = power(spaces.degree(), dim);
    dealii::AlignedVector<Lanes> cell_matrix(n_u * n_p * dim);
    unsigned int current = dealii::numbers::invalid_unsigned_int;
    for_all_pairs(spaces,
                  [&](const unsigned int batch, const unsigned int lane, const int i,
                      const Masters &pressures, const int j, const Masters &velocities)
                  {
                    if (batch != current)
                      equations.cells().divergence_matrix(batch, cell_matrix.data());
                    current = batch;
                    dealii::Tensor<1, dim> entry;
                    for (unsigned int c = 0; c < dim; ++c)
                      entry[c] = cell_matrix[(i * n_u + j) * dim + c][lane];
                    for (const auto &u : velocities)
                    {
                      const auto free =
                          projected<dim>(entry, equations.constraints().of_node(u.node));
                      for (const auto &p : pressures)
                        for (unsigned int c = 0; c < dim; ++c)
                          gradient.add(dim * spaces.nodes()->local_to_global(u.node) + c,
                                       spaces.pressures()->local_to_global(p.node),
                                       u.weight * p.weight * free[c]);
                    }
                  });
    for_empty_columns(spaces, equations.wall(),
                      [&](const auto row, const auto column) { gradient.add(row, column, 1.); });
    gradient.compress(dealii::VectorOperation::add);
  }

  template <int dim>
  void SchurPreconditioner<dim>::assemble_mass(const Equations<dim> &equations)
  {
    const Spaces<dim> &spaces = equations.spaces();
    const int n_p = power(spaces.degree(), dim);
    dealii::AlignedVector<Lanes> cell_matrix(n_p * n_p);
    inverse_mass.reinit(spaces.pressures());
    for (unsigned int batch = 0; batch < spaces.n_owned_batches(); ++batch)
    {
      equations.cells().pressure_mass_matrix(batch, cell_matrix.data());
      for (unsigned int lane = 0; lane < spaces.n_filled_lanes(batch); ++lane)
        for (int i = 0; i < n_p; ++i)
          inverse_mass.local_element(spaces.pressure_nodes(batch)[i][lane]) +=
              cell_matrix[i * n_p + i][lane];
    }
    spaces.pressure_hanging().template fold<1>(inverse_mass.begin());
    inverse_mass.compress(dealii::VectorOperation::add);
    for (unsigned int i = 0; i < inverse_mass.locally_owned_size(); ++i)
      if (double &entry = inverse_mass.local_element(i); entry > 0.)
        entry = 1. / entry;
  }

  template <int dim>
  std::vector<double> SchurPreconditioner<dim>::with_wall(const Equations<dim> &equations,
                                                          const std::vector<double> &of_lumen) const
  {
    // The gradient of a uniform pressure is the normal area of each node.
    const auto &wall = *equations.wall();
    const Spaces<dim> &spaces = equations.spaces();
    Vector one(spaces.pressures()), area(spaces.velocities());
    one = 1.;
    for (const unsigned int i : wall.nodes().idle_pressures())
      one.local_element(i) = 0.;
    gradient.vmult(area, one);
    std::vector<double> of_node(of_lumen.size(), 0.);
    double sums[3] = {0., wall.solid().reference_volume(), equations.cells().volume()};
    for (const unsigned int node : wall.nodes().owned())
      if (wall.nodes().at_interface(node))
      {
        double squared = 0.;
        for (unsigned int c = 0; c < dim; ++c)
          squared += std::pow(area.local_element(dim * node + c), 2);
        of_node[node] = std::sqrt(squared);
        sums[0] += of_node[node];
      }
    dealii::Utilities::MPI::sum(sums, spaces.communicator(), sums);
    if (sums[0] == 0.)
      return of_lumen;
    const WallParameters &solid = wall.parameters();
    const double thickness = sums[1] / sums[0], alpha = equations.inertia();
    // Hoops of the hydraulic radius 2 V / A; walls in the plane have none.
    const double curvature = dim == 3 ? sums[0] / (2. * sums[2]) : 0.;
    const double hoop = solid.youngs_modulus * thickness * curvature * curvature /
                        (1. - solid.poisson_ratio * solid.poisson_ratio);
    const double impedance = thickness * solid.density * (alpha + solid.damping) + hoop / alpha +
                             (wall.has_support() ? wall.support_impedance() : 0.);
    std::vector<double> result = of_lumen;
    for (unsigned int node = 0; node < result.size(); ++node)
      result[node] += impedance * of_node[node];
    return result;
  }

  template <int dim>
  void SchurPreconditioner<dim>::build(const Equations<dim> &equations,
                                       const std::vector<double> &of_lumen)
  {
    const Spaces<dim> &spaces = equations.spaces();
    multigrid.clear(); // before its matrix: the incomplete factorisations refer to that
    assemble_gradient(equations);
    assemble_mass(equations);
    const auto diagonal = equations.wall() ? with_wall(equations, of_lumen) : of_lumen;
    idle.clear();
    if (equations.wall())
      idle = equations.wall()->nodes().idle_pressures();
    velocity.reinit(spaces.velocities());
    change.reinit(spaces.velocities());
    pressure.reinit(spaces.pressures());
    inverse_diagonal.clear();
    for (const double entry : diagonal)
      inverse_diagonal.push_back(1. / entry);
    dealii::TrilinosWrappers::MPI::Vector weights(spaces.velocities()->locally_owned_range(),
                                                  spaces.communicator());
    const auto first = spaces.velocities()->local_range().first;
    for (unsigned int i = 0; i < diagonal.size(); ++i)
      for (unsigned int c = 0; c < dim; ++c)
        weights[first + dim * i + c] = inverse_diagonal[i];
    weights.compress(dealii::VectorOperation::insert);
    gradient.Tmmult(schur, gradient, weights);

    if (equations.conditions().closed())
    {
      // The mean pressure is free: keep the coarsest matrix regular.
      constexpr double regularisation = 1e-6;
      const auto range = schur.local_range();
      for (auto i = range.first; i < range.second; ++i)
        schur.set(i, i, (1. + regularisation) * schur.el(i, i));
      schur.compress(dealii::VectorOperation::insert);
    }

    dealii::TrilinosWrappers::PreconditionAMG::AdditionalData options;
    options.elliptic = true;
    // Cells are flat at walls: incomplete factorisations smooth where polynomials do not.
    options.smoother_type = "IC";
    options.smoother_sweeps = 1;
    options.aggregation_threshold = 0.02;
    multigrid.initialize(schur, options);
  }

  template <int dim>
  void SchurPreconditioner<dim>::vmult(Vector &result, const Vector &residual) const
  {
    multigrid.vmult(result, residual);
    for (unsigned int i = 0; i < residual.locally_owned_size(); ++i)
      result.local_element(i) += inverse_mass.local_element(i) * residual.local_element(i);
    for (const unsigned int i : idle)
      result.local_element(i) = 0.;
  }

  template <int dim>
  void SchurPreconditioner<dim>::vmult(Vector &result, const Vector &residual,
                                       const CompressedRows &momentum) const
  {
    const auto scale = [this](Vector &v)
    {
      for (unsigned int i = 0; i < inverse_diagonal.size(); ++i)
        for (unsigned int c = 0; c < dim; ++c)
          v.local_element(dim * i + c) *= inverse_diagonal[i];
    };
    multigrid.vmult(pressure, residual);
    gradient.vmult(velocity, pressure);
    scale(velocity);
    momentum.vmult<dim>(velocity.begin(), change.begin());
    scale(change);
    gradient.Tvmult(pressure, change);
    multigrid.vmult(result, pressure);
  }

  template <int dim>
  void SchurPreconditioner<dim>::volume_source(Vector &result) const
  {
    for (unsigned int i = 0; i < inverse_mass.locally_owned_size(); ++i)
    {
      const double entry = inverse_mass.local_element(i);
      result.local_element(i) = entry > 0. ? 1. / entry : 0.;
    }
  }

  template class SchurPreconditioner<2>;
  template class SchurPreconditioner<3>;
} // namespace semilunar::flow
