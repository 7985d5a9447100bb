// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/flow/mesh_motion.h>
#include <semilunar/flow/tensor_kernel.h>
#include <semilunar/mesh/mesh.h>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_tools.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace semilunar::flow
{
  using dealii::Tensor;

  namespace
  {
    /// Exponent of the determinant of a cell's Jacobian in its stiffness: equation (6).
    constexpr double stiffening = 1.5;
    /// Of the material that the mesh is made of.
    constexpr double poisson_ratio = 0.3;
    /// Of displacements, relative to what the wall does to them.
    constexpr double tolerance = 1e-6;

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
        element(dealii::FE_Q<dim>(1), dim), vertices(spaces.velocity_dofs().get_triangulation())
  {
    const auto &points = spaces.velocity_dofs().get_fe().get_unit_support_points();
    const auto order = dealii::FETools::lexicographic_to_hierarchic_numbering<dim>(spaces.degree());
    const dealii::FE_Q<dim> linear(1);
    for (const unsigned int i : order)
      for (unsigned int v = 0; v < dealii::GeometryInfo<dim>::vertices_per_cell; ++v)
        vertex_weight.push_back(linear.shape_value(v, points[i]));
  }

  template <int dim>
  unsigned int MeshMotion<dim>::node_of(const CellIterator &cell, const unsigned int vertex) const
  {
    const CellLane where = spaces.lane_of(cell->active_cell_index());
    unsigned int node = 0, stride = spaces.degree();
    for (unsigned int d = 0; d < dim; ++d, stride *= spaces.degree() + 1)
      node += (vertex >> d & 1) * stride;
    return spaces.velocity_nodes(where.batch)[node][where.lane];
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
    solution.reinit(partitioner);
    load.reinit(partitioner);
    given.reinit(partitioner);
    hanging.clear();
    hanging.reinit(relevant);
    dealii::DoFTools::make_hanging_node_constraints(vertices, hanging);
    hanging.close();
    constraints.clear();
    constraints.reinit(relevant);
    set_constraints(faces);
    assemble();
  }

  template <int dim>
  void MeshMotion<dim>::set_constraints(const BoundaryFaces<dim> &faces)
  {
    dealii::DoFTools::make_hanging_node_constraints(vertices, constraints);
    wall_vertices.clear();
    VelocityConstraints<dim> sliding;
    sliding.reinit(spaces, faces, conditions);
    std::vector<dealii::types::global_dof_index> dofs(element.dofs_per_cell);
    std::vector<bool> done(solution.locally_owned_size() +
                           solution.get_partitioner()->n_ghost_indices());
    for (const auto &cell : vertices.active_cell_iterators())
      if (!cell->is_artificial())
      {
        cell->get_dof_indices(dofs);
        for (const unsigned int v : cell->vertex_indices())
        {
          const auto first = dofs[element.component_to_system_index(0, v)];
          const unsigned int stored = solution.get_partitioner()->global_to_local(first);
          const unsigned int node = node_of(cell, v);
          if (done[stored] || constraints.is_constrained(first))
            continue;
          done[stored] = true;
          typename VelocityConstraints<dim>::Entry fixed{};
          fixed.n = dim;
          if (wall_nodes.in_wall(node))
          {
            constrain(first, fixed);
            if (stored < solution.locally_owned_size())
              wall_vertices.emplace_back(stored, node);
          }
          else if (const auto *entry = sliding.of_node(node))
            constrain(first, *entry);
        }
      }
    constraints.close();
  }

  template <int dim>
  void MeshMotion<dim>::constrain(const dealii::types::global_dof_index first,
                                  const typename VelocityConstraints<dim>::Entry &entry)
  {
    // The components of a vertex have subsequent numbers.
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
  void MeshMotion<dim>::assemble()
  {
    dealii::TrilinosWrappers::SparsityPattern pattern(vertices.locally_owned_dofs(),
                                                      spaces.communicator());
    dealii::DoFTools::make_sparsity_pattern(vertices, pattern, constraints, false,
                                            vertices.get_triangulation().locally_owned_subdomain());
    pattern.compress();
    matrix.reinit(pattern);
    const dealii::FE_Q<dim> scalar(1);
    dealii::FEValues<dim> values(scalar, dealii::QGauss<dim>(2),
                                 dealii::update_gradients | dealii::update_JxW_values);
    cells_at_wall.clear();
    give([](const unsigned int, const unsigned int) { return 1.; });
    CellAtWall data;
    data.dofs.resize(element.dofs_per_cell);
    data.matrix.reinit(element.dofs_per_cell, element.dofs_per_cell);
    for (const auto &cell : vertices.active_cell_iterators())
      if (cell->is_locally_owned())
      {
        cell->get_dof_indices(data.dofs);
        // Nothing couples the wall's vertices to others; they need a diagonal.
        data.matrix = 0.;
        if (cell->material_id() == mesh::wall)
          for (unsigned int i = 0; i < element.dofs_per_cell; ++i)
            data.matrix(i, i) = 1.;
        else
        {
          values.reinit(typename dealii::Triangulation<dim>::cell_iterator(cell));
          cell_matrix(values, data.matrix);
        }
        constraints.distribute_local_to_global(data.matrix, data.dofs, matrix);
        const bool touches = std::any_of(data.dofs.begin(), data.dofs.end(),
                                         [this](const auto dof) { return given(dof) != 0.; });
        if (touches && cell->material_id() != mesh::wall)
          cells_at_wall.push_back(data);
      }
    matrix.compress(dealii::VectorOperation::add);
    dealii::TrilinosWrappers::PreconditionAMG::AdditionalData options;
    options.elliptic = true;
    options.smoother_sweeps = 2;
    options.aggregation_threshold = 0.02;
    dealii::DoFTools::extract_constant_modes(vertices, dealii::ComponentMask(dim, true),
                                             options.constant_modes);
    multigrid.initialize(matrix, options);
  }

  /// Values at the vertices of the wall, zero at others, with the hanging ones that follow from
  /// both.
  template <int dim>
  template <class Value>
  void MeshMotion<dim>::give(const Value &value)
  {
    given.zero_out_ghost_values();
    given = 0.;
    for (const auto &[first, node] : wall_vertices)
      for (unsigned int c = 0; c < dim; ++c)
        given.local_element(first + c) = value(node, c);
    given.update_ghost_values();
    hanging.distribute(given);
    given.update_ghost_values();
  }

  template <int dim>
  void MeshMotion<dim>::find_load()
  {
    load = 0.;
    dealii::Vector<double> displacement(element.dofs_per_cell), force(element.dofs_per_cell);
    for (const CellAtWall &cell : cells_at_wall)
    {
      for (unsigned int i = 0; i < displacement.size(); ++i)
        displacement[i] = -given(cell.dofs[i]);
      cell.matrix.vmult(force, displacement);
      constraints.distribute_local_to_global(force, cell.dofs, load);
    }
    load.compress(dealii::VectorOperation::add);
  }

  template <int dim>
  unsigned int MeshMotion<dim>::solve(Vector &positions)
  {
    Vector displacement(spaces.velocities());
    displacement.equ(1., positions);
    displacement.add(-1., reference);
    spaces.make_readable_velocity(displacement);
    give([&displacement](const unsigned int node, const unsigned int c)
         { return displacement.local_element(dim * node + c); });
    find_load();
    solution.zero_out_ghost_values();
    constraints.set_zero(solution);
    const double size = load.l2_norm();
    unsigned int n = 0;
    if (size > 0.)
    {
      dealii::SolverControl control(500, tolerance * size, false, false);
      try
      {
        dealii::SolverCG<Vector>(control).solve(matrix, solution, load, multigrid);
      }
      catch (const dealii::SolverControl::NoConvergence &)
      {
        throw NumericsError("the equations of the mesh motion have not converged", "", "");
      }
      n = control.last_step();
    }
    else
      solution = 0.;
    constraints.distribute(solution);
    follow_vertices(displacement, positions);
    return n;
  }

  template <int dim>
  void MeshMotion<dim>::forget_solution()
  {
    solution.zero_out_ghost_values();
    solution = 0.;
  }

  template <int dim>
  void MeshMotion<dim>::follow_vertices(const Vector &wall_displacement, Vector &positions) const
  {
    // Displacements of vertices, then of all nodes of the lumen by linear interpolation.
    solution.update_ghost_values();
    constexpr unsigned int n_vertices = dealii::GeometryInfo<dim>::vertices_per_cell;
    const unsigned int n_nodes = power(spaces.degree() + 1, dim);
    Vector displacement(spaces.velocities());
    displacement = wall_displacement;
    spaces.make_readable_velocity(displacement);
    std::vector<dealii::types::global_dof_index> dofs(element.dofs_per_cell);
    for (const auto &cell : vertices.active_cell_iterators())
      if (!cell->is_artificial() && cell->material_id() != mesh::wall)
      {
        cell->get_dof_indices(dofs);
        Tensor<1, dim> of_vertex[n_vertices];
        for (unsigned int v = 0; v < n_vertices; ++v)
        {
          for (unsigned int c = 0; c < dim; ++c)
          {
            const auto dof = dofs[element.component_to_system_index(c, v)];
            of_vertex[v][c] = solution(dof) + given(dof);
          }
        }
        const CellLane where = spaces.lane_of(cell->active_cell_index());
        for (unsigned int i = 0; i < n_nodes; ++i)
        {
          const unsigned int node = spaces.velocity_nodes(where.batch)[i][where.lane];
          if (node >= spaces.nodes()->locally_owned_size() || wall_nodes.in_wall(node))
            continue;
          Tensor<1, dim> sum;
          for (unsigned int v = 0; v < n_vertices; ++v)
            sum += vertex_weight[i * n_vertices + v] * of_vertex[v];
          for (unsigned int c = 0; c < dim; ++c)
            displacement.local_element(dim * node + c) = sum[c];
        }
      }
    add_surplus(displacement);
    positions.zero_out_ghost_values();
    positions.equ(1., reference);
    positions.add(1., displacement);
    spaces.make_readable_velocity(positions);
  }

  /// What the interface does between its vertices is continued to the opposite faces of cells.
  template <int dim>
  void MeshMotion<dim>::add_surplus(Vector &displacement) const
  {
    constexpr unsigned int n_vertices = dealii::GeometryInfo<dim>::vertices_per_cell;
    const unsigned int n = spaces.degree() + 1, n_nodes = power(n, dim);
    const unsigned int n_owned = spaces.nodes()->locally_owned_size();
    const auto points = nodes_1d(spaces.degree());
    std::vector<double> found(n_owned, 0.); // cells that continue to a node
    std::vector<Tensor<1, dim>> sum(n_owned);
    for (unsigned int batch = 0; batch < spaces.n_batches(); ++batch)
      for (unsigned int lane = 0; lane < spaces.n_filled_lanes(batch); ++lane)
        for (unsigned int face = 0; face < 2 * dim; ++face)
        {
          const unsigned int d = face / 2, stride = power(n, d), end = (face % 2) * (n - 1);
          const auto node = [&](const unsigned int i)
          { return spaces.velocity_nodes(batch)[i][lane]; };
          bool at_wall = true;
          for (unsigned int i = 0; i < n_nodes && at_wall; ++i)
            at_wall = i / stride % n != end || wall_nodes.in_wall(node(i));
          if (!at_wall)
            continue;
          for (unsigned int i = 0; i < n_nodes; ++i)
          {
            const unsigned int along = i / stride % n, on_face = i + (end - along) * stride;
            if (node(i) >= n_owned || wall_nodes.in_wall(node(i)))
              continue;
            const double share = face % 2 == 0 ? 1. - points[along][0] : points[along][0];
            found[node(i)] += 1.;
            for (unsigned int c = 0; c < dim; ++c)
            {
              double surplus = displacement.local_element(dim * node(on_face) + c);
              for (unsigned int v = 0; v < n_vertices; ++v)
                if (const double w = vertex_weight[on_face * n_vertices + v]; w != 0.)
                {
                  unsigned int corner = 0;
                  for (unsigned int e = 0; e < dim; ++e)
                    corner += (v >> e & 1) * (n - 1) * power(n, e);
                  surplus -= w * displacement.local_element(dim * node(corner) + c);
                }
              sum[node(i)][c] += share * surplus;
            }
          }
        }
    for (unsigned int node = 0; node < n_owned; ++node)
      if (found[node] > 0.)
        for (unsigned int c = 0; c < dim; ++c)
          displacement.local_element(dim * node + c) += sum[node][c] / found[node];
  }

  template <int dim>
  double MeshMotion<dim>::min_scaled_jacobian(const Vector &positions) const
  {
    const unsigned int n = spaces.degree() + 1, n_nodes = power(n, dim);
    const auto nodes = nodes_1d(spaces.degree());
    const auto basis = dealii::Polynomials::generate_complete_Lagrange_basis(nodes);
    std::vector<double> derivative, both(2); // [point][node]
    for (unsigned int q = 0; q < n; ++q)
      for (unsigned int i = 0; i < n; ++i)
      {
        basis[i].value(nodes[q][0], both);
        derivative.push_back(both[1]);
      }
    double smallest = std::numeric_limits<double>::max();
    for (unsigned int batch = 0; batch < spaces.n_owned_batches(); ++batch)
      for (unsigned int lane = 0; lane < spaces.n_filled_lanes(batch); ++lane)
        for (unsigned int q = 0; q < n_nodes; ++q)
        {
          Tensor<2, dim> columns;
          for (unsigned int d = 0; d < dim; ++d)
          {
            const unsigned int stride = power(n, d), at = q / stride % n;
            for (unsigned int i = 0; i < n; ++i)
            {
              const unsigned int node =
                  spaces.velocity_nodes(batch)[q + i * stride - at * stride][lane];
              for (unsigned int c = 0; c < dim; ++c)
                columns[d][c] += derivative[at * n + i] * positions.local_element(dim * node + c);
            }
            columns[d] /= columns[d].norm();
          }
          smallest = std::min(smallest, determinant(columns));
        }
    return dealii::Utilities::MPI::min(smallest, spaces.communicator());
  }

  template class MeshMotion<2>;
  template class MeshMotion<3>;
} // namespace semilunar::flow
