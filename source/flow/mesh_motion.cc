// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/flow/mesh_motion.h>
#include <semilunar/mesh/mesh.h>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>

#include <cmath>
#include <map>

namespace semilunar::flow
{
  using dealii::Tensor;

  namespace
  {
    /// Exponent of the determinant of a cell's Jacobian in its stiffness: equation (6).
    constexpr double stiffening = 1.5;
    /// Of the material that the mesh is made of.
    constexpr double poisson_ratio = 0.3;
    /// Of forces, relative to what the wall does to them.
    constexpr double tolerance = 1e-4;

    template <int dim>
    BoundaryConditions<dim> of_mesh(const BoundaryConditions<dim> &conditions)
    {
      using Kind = typename BoundaryConditions<dim>::Kind;
      BoundaryConditions<dim> result;
      for (const auto &[id, condition] : conditions.all())
        if (condition.kind == Kind::wall || condition.kind == Kind::velocity)
          result.set_wall(id);
        else
          result.set_slip(id);
      return result;
    }
  } // namespace

  template <int dim>
  MeshMotion<dim>::MeshMotion(const Spaces<dim> &spaces, const WallNodes<dim> &nodes,
                              const BoundaryConditions<dim> &conditions)
      : spaces(spaces), wall_nodes(nodes), conditions(of_mesh(conditions)),
        element(dealii::FE_Q<dim>(1), dim), vertices(spaces.velocity_dofs().get_triangulation()),
        interpolation(spaces, nodes)
  {
  }

  template <int dim>
  void MeshMotion<dim>::reinit(const Vector &reference_positions, const BoundaryFaces<dim> &faces)
  {
    reference.reinit(spaces.velocities());
    reference = reference_positions;
    spaces.make_readable_velocity(reference);
    vertices.distribute_dofs(element);
    dealii::IndexSet relevant;
    dealii::DoFTools::extract_locally_relevant_dofs(vertices, relevant);
    const auto partitioner = std::make_shared<dealii::Utilities::MPI::Partitioner>(
        vertices.locally_owned_dofs(), relevant, spaces.communicator());
    for (Vector *vector : {&solution, &given, &load})
      vector->reinit(partitioner);
    for (auto *set : {&hanging, &constraints})
    {
      set->clear();
      set->reinit(relevant);
      dealii::DoFTools::make_hanging_node_constraints(vertices, *set);
    }
    hanging.close();
    number_vertices();
    set_constraints(faces);
    find_dependent();
    assemble();
    constexpr unsigned int n_vertices = dealii::GeometryInfo<dim>::vertices_per_cell;
    interpolation.reinit(
        [this](const CellLane &cell, const unsigned int v)
        { return vertex_of_cell[(cell.batch * n_lanes + cell.lane) * n_vertices + v]; });
  }

  template <int dim>
  void MeshMotion<dim>::number_vertices()
  {
    constexpr unsigned int n_vertices = dealii::GeometryInfo<dim>::vertices_per_cell;
    node_of_vertex.assign(
        (solution.locally_owned_size() + solution.get_partitioner()->n_ghost_indices()) / dim,
        dealii::numbers::invalid_unsigned_int);
    vertex_of_cell.assign(spaces.n_batches() * n_lanes * n_vertices, 0);
    std::vector<Index> dofs(element.dofs_per_cell);
    for (const auto &cell : vertices.active_cell_iterators())
      if (!cell->is_artificial())
      {
        cell->get_dof_indices(dofs);
        const CellLane where = spaces.lane_of(cell->active_cell_index());
        for (unsigned int v = 0; v < n_vertices; ++v)
        {
          // The components of a vertex have subsequent numbers.
          const unsigned int vertex = stored(dofs[element.component_to_system_index(0, v)]) / dim;
          node_of_vertex[vertex] =
              spaces.velocity_nodes(where.batch)[interpolation.node_at(v)][where.lane];
          if (where.batch < spaces.n_batches())
            vertex_of_cell[(where.batch * n_lanes + where.lane) * n_vertices + v] = vertex;
        }
      }
  }

  template <int dim>
  void MeshMotion<dim>::set_constraints(const BoundaryFaces<dim> &faces)
  {
    VelocityConstraints<dim> sliding;
    sliding.reinit(spaces, faces, conditions);
    typename VelocityConstraints<dim>::Entry fixed{};
    fixed.n = dim;
    of_wall.assign(node_of_vertex.size(), false);
    for (unsigned int vertex = 0; vertex < node_of_vertex.size(); ++vertex)
    {
      const unsigned int node = node_of_vertex[vertex];
      const Index first = solution.get_partitioner()->local_to_global(dim * vertex);
      if (node == dealii::numbers::invalid_unsigned_int || hanging.is_constrained(first))
        continue;
      of_wall[vertex] = wall_nodes.in_wall(node);
      if (of_wall[vertex])
        constrain(first, fixed);
      else if (const auto *entry = sliding.of_node(node))
        constrain(first, *entry);
    }
    constraints.close();
  }

  template <int dim>
  void MeshMotion<dim>::constrain(const Index first,
                                  const typename VelocityConstraints<dim>::Entry &entry)
  {
    const auto pivot = [](const Tensor<1, dim> &a)
    {
      unsigned int largest = 0;
      for (unsigned int c = 1; c < dim; ++c)
        if (std::abs(a[c]) > std::abs(a[largest]))
          largest = c;
      return largest;
    };
    if (entry.n == dim)
      for (unsigned int c = 0; c < dim; ++c)
        constraints.add_line(first + c);
    else if (entry.n == 1)
    {
      const Tensor<1, dim> &normal = entry.directions[0];
      const unsigned int p = pivot(normal);
      constraints.add_line(first + p);
      for (unsigned int c = 0; c < dim; ++c)
        if (c != p && std::abs(normal[c]) > 1e-12)
          constraints.add_entry(first + p, first + c, -normal[c] / normal[p]);
    }
    else if constexpr (dim == 3)
    {
      const Tensor<1, 3> along = cross_product_3d(entry.directions[0], entry.directions[1]);
      const unsigned int p = pivot(along);
      for (unsigned int c = 0; c < dim; ++c)
        if (c != p)
        {
          constraints.add_line(first + c);
          if (std::abs(along[c]) > 1e-12)
            constraints.add_entry(first + c, first + p, along[c] / along[p]);
        }
    }
  }

  template <int dim>
  void MeshMotion<dim>::cell_matrix(const dealii::FEValues<dim> &values,
                                    dealii::FullMatrix<double> &result) const
  {
    // Lame's constants for Young's modulus 1 (its size does not matter).
    constexpr double lame = poisson_ratio / ((1. + poisson_ratio) * (1. - 2. * poisson_ratio)),
                     shear = 0.5 / (1. + poisson_ratio);
    result = 0.;
    for (unsigned int q = 0; q < values.n_quadrature_points; ++q)
    {
      const double determinant = values.JxW(q) / values.get_quadrature().weight(q);
      const double weight = values.JxW(q) * std::pow(determinant, -stiffening);
      for (unsigned int i = 0; i < element.dofs_per_cell; ++i)
        for (unsigned int j = 0; j < element.dofs_per_cell; ++j)
        {
          const auto [c, v] = element.system_to_component_index(i);
          const auto [d, w] = element.system_to_component_index(j);
          const Tensor<1, dim> &a = values.shape_grad(v, q), &b = values.shape_grad(w, q);
          result(i, j) +=
              weight * (lame * a[c] * b[d] + shear * (a[d] * b[c] + (c == d ? a * b : 0.)));
        }
    }
  }

  template <int dim>
  typename MeshMotion<dim>::Entries MeshMotion<dim>::free_masters(const Index dof) const
  {
    if (!constraints.is_constrained(dof))
      return {{stored(dof), 1.}};
    Entries result;
    for (const auto &[master, weight] : *constraints.get_constraint_entries(dof))
      result.push_back({stored(master), weight});
    return result;
  }

  template <int dim>
  typename MeshMotion<dim>::Entries MeshMotion<dim>::wall_masters(const Index dof) const
  {
    Entries result;
    if (!hanging.is_constrained(dof))
    {
      if (of_wall[stored(dof) / dim])
        result.push_back({stored(dof), 1.});
    }
    else
      for (const auto &[master, weight] : *hanging.get_constraint_entries(dof))
        if (of_wall[stored(master) / dim])
          result.push_back({stored(master), weight});
    return result;
  }

  template <int dim>
  void MeshMotion<dim>::find_dependent()
  {
    constrained.clear();
    dependent.clear();
    for (unsigned int i = 0; i < solution.locally_owned_size(); ++i)
    {
      const Index dof = solution.get_partitioner()->local_to_global(i);
      if (!constraints.is_constrained(dof))
        continue;
      constrained.push_back(i);
      if (of_wall[i / dim])
        continue;
      Entries masters = free_masters(dof);
      for (const auto &entry : wall_masters(dof))
        masters.push_back(entry);
      dependent.add_row(i, masters);
    }
  }

  template <int dim>
  void MeshMotion<dim>::assemble()
  {
    multigrid.clear(); // before its matrix
    dealii::TrilinosWrappers::SparsityPattern pattern(vertices.locally_owned_dofs(),
                                                      spaces.communicator());
    dealii::DoFTools::make_sparsity_pattern(vertices, pattern, constraints, false,
                                            vertices.get_triangulation().locally_owned_subdomain());
    pattern.compress();
    matrix.reinit(pattern);
    const dealii::FE_Q<dim> scalar(1);
    dealii::FEValues<dim> values(scalar, dealii::QGauss<dim>(2),
                                 dealii::update_gradients | dealii::update_JxW_values);
    std::vector<Index> dofs(element.dofs_per_cell);
    dealii::FullMatrix<double> of_cell(element.dofs_per_cell, element.dofs_per_cell);
    std::map<unsigned int, std::map<unsigned int, double>> forces;
    for (const auto &cell : vertices.active_cell_iterators())
      if (cell->is_locally_owned())
      {
        cell->get_dof_indices(dofs);
        // Nothing couples the wall's vertices to others; they need a diagonal.
        if (cell->material_id() == mesh::wall)
          of_cell = dealii::IdentityMatrix(dofs.size());
        else
        {
          values.reinit(typename dealii::Triangulation<dim>::cell_iterator(cell));
          cell_matrix(values, of_cell);
          for (unsigned int j = 0; j < dofs.size(); ++j)
            for (const auto &column : wall_masters(dofs[j]))
              for (unsigned int i = 0; i < dofs.size(); ++i)
                for (const auto &row : free_masters(dofs[i]))
                  forces[row.index][column.index] -= row.weight * column.weight * of_cell(i, j);
        }
        constraints.distribute_local_to_global(of_cell, dofs, matrix);
      }
    matrix.compress(dealii::VectorOperation::add);
    force_of_wall.clear();
    for (const auto &[row, columns] : forces)
    {
      Entries entries;
      for (const auto &[column, force] : columns)
        entries.push_back({column, force});
      force_of_wall.add_row(row, entries);
    }
    make_multigrid();
  }

  template <int dim>
  void MeshMotion<dim>::make_multigrid()
  {
    dealii::TrilinosWrappers::PreconditionAMG::AdditionalData options;
    options.elliptic = true;
    options.smoother_sweeps = 2;
    options.aggregation_threshold = 0.02;
    dealii::DoFTools::extract_constant_modes(vertices, dealii::ComponentMask(dim, true),
                                             options.constant_modes);
    multigrid.initialize(matrix, options);
  }

  template <int dim>
  unsigned int MeshMotion<dim>::solve(Vector &positions)
  {
    Vector displacement(spaces.velocities());
    displacement.equ(1., positions);
    displacement.add(-1., reference);
    spaces.make_readable_velocity(displacement);
    for (Vector *vector : {&solution, &given, &load})
      vector->zero_out_ghost_values();
    given = 0.;
    load = 0.;
    for (unsigned int i = 0; i < solution.locally_owned_size(); ++i)
    {
      solution.local_element(i) =
          displacement.local_element(dim * node_of_vertex[i / dim] + i % dim);
      if (of_wall[i / dim])
        given.local_element(i) = solution.local_element(i);
    }
    given.update_ghost_values();
    force_of_wall.template add<1>(given.begin(), load.begin());
    load.compress(dealii::VectorOperation::add);
    for (const unsigned int i : constrained)
      solution.local_element(i) = 0.;
    const unsigned int n = find_free_displacements();

    // Free displacements and those of the wall, then what depends on them.
    given.zero_out_ghost_values();
    solution += given;
    solution.update_ghost_values();
    dependent.template set<1>(solution.begin(), solution.begin());
    solution.update_ghost_values();
    interpolation.apply(solution, displacement);
    positions.zero_out_ghost_values();
    displacement.zero_out_ghost_values();
    positions.equ(1., reference);
    positions.add(1., displacement);
    spaces.make_readable_velocity(positions);
    return n;
  }

  template <int dim>
  unsigned int MeshMotion<dim>::find_free_displacements()
  {
    const double size = load.l2_norm();
    if (size == 0.)
    {
      solution = 0.;
      return 0;
    }
    dealii::SolverControl control(500, tolerance * size, false, false);
    try
    {
      dealii::SolverCG<Vector>(control).solve(matrix, solution, load, multigrid);
    }
    catch (const dealii::SolverControl::NoConvergence &)
    {
      throw NumericsError("the equations of the mesh motion have not converged", "", "");
    }
    return control.last_step();
  }

  template class MeshMotion<2>;
  template class MeshMotion<3>;
} // namespace semilunar::flow
