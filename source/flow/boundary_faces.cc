// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/flow/boundary_faces.h>
#include <semilunar/flow/tensor_kernel.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <set>

namespace semilunar::flow
{
  using dealii::Tensor;

  double SparseFunctional::local_value(const Vector &vector) const
  {
    double sum = 0.;
    for (unsigned int i = 0; i < index.size(); ++i)
      sum += value[i] * vector.local_element(index[i]);
    return sum;
  }

  void SparseFunctional::add(const double factor, Vector &vector) const
  {
    for (unsigned int i = 0; i < index.size(); ++i)
      vector.local_element(index[i]) += factor * value[i];
  }

  namespace
  {
    /// Lexicographic nodes of a cell with n nodes in each direction that lie on each face.
    template <int dim>
    std::vector<unsigned int> nodes_on_faces(const unsigned int n)
    {
      std::vector<unsigned int> nodes;
      const unsigned int n_cell = dealii::Utilities::fixed_power<dim>(n);
      for (unsigned int face = 0; face < 2 * dim; ++face)
        for (unsigned int i = 0; i < n_cell; ++i)
        {
          const unsigned int stride = face / 2 == 0 ? 1 : face / 2 == 1 ? n : n * n;
          if (i / stride % n == (face % 2) * (n - 1))
            nodes.push_back(i);
        }
      return nodes;
    }

    SparseFunctional owned_entries(const Vector &vector)
    {
      SparseFunctional functional;
      for (unsigned int i = 0; i < vector.locally_owned_size(); ++i)
        if (vector.local_element(i) != 0.)
        {
          functional.index.push_back(i);
          functional.value.push_back(vector.local_element(i));
        }
      return functional;
    }

    /// n dA out of the cell from the tangents along the face's directions.
    template <int dim>
    Tensor<1, dim> outward_area(const std::array<Tensor<1, dim>, dim - 1> &tangents,
                                const unsigned int face)
    {
      Tensor<1, dim> area;
      if constexpr (dim == 2)
        area = dealii::cross_product_2d(tangents[0]);
      else
        area = dealii::cross_product_3d(tangents[0], tangents[1]);
      // The remaining directions of the second one are not in cyclic order.
      const bool along = (face / 2 == 1) != (face % 2 == 1);
      return along ? area : -area;
    }
  } // namespace

  template <int dim>
  BoundaryFaces<dim>::BoundaryFaces(const Spaces<dim> &spaces) : spaces(spaces)
  {
    tabulate();
    reinit();
  }

  template <int dim>
  void BoundaryFaces<dim>::tabulate()
  {
    const unsigned int degree = spaces.degree();
    const dealii::QGauss<1> gauss(degree + 1);
    const dealii::QGauss<dim - 1> points(degree + 1);
    const auto basis = dealii::Polynomials::generate_complete_Lagrange_basis(nodes_1d(degree));
    const auto pressure_basis =
        dealii::Polynomials::generate_complete_Lagrange_basis(nodes_1d(degree - 1));
    const dealii::TensorProductPolynomials<dim - 1> shapes(basis), pressure_shapes(pressure_basis);
    n_nodes = shapes.n();
    n_pressure_nodes = pressure_shapes.n();
    n_points = points.size();
    weights = points.get_weights();
    for (const auto &point : points.get_points())
    {
      for (unsigned int i = 0; i < n_nodes; ++i)
      {
        shape.push_back(shapes.compute_value(i, point));
        const auto derivative = shapes.compute_grad(i, point);
        derivatives.emplace_back();
        for (unsigned int d = 0; d < dim - 1; ++d)
          derivatives.back()[d] = derivative[d];
      }
      for (unsigned int i = 0; i < n_pressure_nodes; ++i)
        pressure_shape.push_back(pressure_shapes.compute_value(i, point));
    }
    node_of_face = nodes_on_faces<dim>(degree + 1);
    pressure_node_of_face = nodes_on_faces<dim>(degree);
  }

  template <int dim>
  void BoundaryFaces<dim>::reinit()
  {
    part_of_id.clear();
    std::set<Id> ids;
    for (const auto &cell : spaces.velocity_dofs().active_cell_iterators())
      if (cell->is_locally_owned() || cell->is_ghost())
        for (const unsigned int face : cell->face_indices())
          if (cell->face(face)->at_boundary())
          {
            ids.insert(cell->face(face)->boundary_id());
            collect(cell->face(face)->boundary_id(), cell, face);
          }
    for (const auto &of_rank : dealii::Utilities::MPI::all_gather(
             spaces.communicator(), std::vector<Id>(ids.begin(), ids.end())))
      for (const Id id : of_rank)
        part_of_id[id];
    for (auto &[id, part] : part_of_id)
    {
      std::sort(part.nodes.begin(), part.nodes.end());
      part.nodes.erase(std::unique(part.nodes.begin(), part.nodes.end()), part.nodes.end());
    }
  }

  template <int dim>
  void
  BoundaryFaces<dim>::collect(const Id id,
                              const typename dealii::DoFHandler<dim>::active_cell_iterator &cell,
                              const unsigned int face)
  {
    Part &part = part_of_id[id];
    const CellLane where = spaces.lane_of(cell->active_cell_index());
    const auto *nodes = spaces.velocity_nodes(where.batch);
    for (unsigned int i = 0; i < n_nodes; ++i)
      part.nodes.push_back(nodes[cell_node(face, i)][where.lane]);
    if (!cell->is_locally_owned())
      return;
    part.face_cell.push_back(where);
    part.face_of_cell.push_back(face);
    part.face_nodes.insert(part.face_nodes.end(), part.nodes.end() - n_nodes, part.nodes.end());
    const auto *pressure_nodes = spaces.pressure_nodes(where.batch);
    for (unsigned int i = 0; i < n_pressure_nodes; ++i)
      part.face_pressure_nodes.push_back(
          pressure_nodes[pressure_node_of_face[face * n_pressure_nodes + i]][where.lane]);
  }

  template <int dim>
  void BoundaryFaces<dim>::update_geometry(const Vector &positions)
  {
    for (auto &[id, part] : part_of_id)
    {
      part.face_area.resize(n_faces(part) * n_points);
      part.face_points.resize(part.face_area.size());
      for (unsigned int f = 0; f < n_faces(part); ++f)
        for (unsigned int q = 0; q < n_points; ++q)
        {
          std::array<Tensor<1, dim>, dim - 1> tangents;
          Tensor<1, dim> x;
          for (unsigned int i = 0; i < n_nodes; ++i)
            for (unsigned int c = 0; c < dim; ++c)
            {
              const double position =
                  positions.local_element(dim * part.face_nodes[f * n_nodes + i] + c);
              x[c] += shape[q * n_nodes + i] * position;
              for (unsigned int d = 0; d < dim - 1; ++d)
                tangents[d][c] += derivatives[q * n_nodes + i][d] * position;
            }
          part.face_points[f * n_points + q] = x;
          part.face_area[f * n_points + q] =
              weights[q] * outward_area<dim>(tangents, part.face_of_cell[f]);
        }
      update_functionals(part);
    }
  }

  template <int dim>
  void BoundaryFaces<dim>::update_functionals(Part &part)
  {
    Vector pressure(spaces.pressures());
    part.normals.reinit(spaces.velocities());
    double area = 0.;
    for (unsigned int f = 0; f < n_faces(part); ++f)
      for (unsigned int q = 0; q < n_points; ++q)
      {
        const Tensor<1, dim> &da = part.face_area[f * n_points + q];
        area += da.norm();
        for (unsigned int i = 0; i < n_nodes; ++i)
          for (unsigned int c = 0; c < dim; ++c)
            part.normals.local_element(dim * part.face_nodes[f * n_nodes + i] + c) +=
                shape[q * n_nodes + i] * da[c];
        for (unsigned int i = 0; i < n_pressure_nodes; ++i)
          pressure.local_element(part.face_pressure_nodes[f * n_pressure_nodes + i]) +=
              pressure_shape[q * n_pressure_nodes + i] * da.norm();
      }
    part.area = dealii::Utilities::MPI::sum(area, spaces.communicator());
    spaces.velocity_hanging().template fold<dim>(part.normals.begin());
    part.normals.compress(dealii::VectorOperation::add);
    spaces.pressure_hanging().template fold<1>(pressure.begin());
    pressure.compress(dealii::VectorOperation::add);
    part.flow_rate = owned_entries(part.normals);
    part.pressure = owned_entries(pressure);
    part.normals.update_ghost_values();
  }

  template <int dim>
  void BoundaryFaces<dim>::linearise_backflow(const Id id, const double coefficient,
                                              const Vector &velocity, const Vector *mesh_velocity)
  {
    Part &part = part_of_id.at(id);
    part.inflow.assign(part.face_area.size(), 0.);
    if (coefficient == 0.)
      return;
    for (unsigned int f = 0; f < n_faces(part); ++f)
      for (unsigned int q = 0; q < n_points; ++q)
      {
        double flow = 0.;
        for (unsigned int i = 0; i < n_nodes; ++i)
          for (unsigned int c = 0; c < dim; ++c)
          {
            const unsigned int entry = dim * part.face_nodes[f * n_nodes + i] + c;
            const double w = velocity.local_element(entry) -
                             (mesh_velocity ? mesh_velocity->local_element(entry) : 0.);
            flow += shape[q * n_nodes + i] * w * part.face_area[f * n_points + q][c];
          }
        part.inflow[f * n_points + q] = coefficient * std::max(-flow, 0.);
      }
  }

  template <int dim>
  void BoundaryFaces<dim>::add_backflow(const Id id, const Vector &velocity, Vector &momentum) const
  {
    const Part &part = part_of_id.at(id);
    for (unsigned int f = 0; f < n_faces(part); ++f)
      for (unsigned int q = 0; q < n_points; ++q)
      {
        const double coefficient = part.inflow[f * n_points + q];
        if (coefficient == 0.)
          continue;
        const unsigned int *nodes = part.face_nodes.data() + f * n_nodes;
        Tensor<1, dim> u;
        for (unsigned int i = 0; i < n_nodes; ++i)
          for (unsigned int c = 0; c < dim; ++c)
            u[c] += shape[q * n_nodes + i] * velocity.local_element(dim * nodes[i] + c);
        for (unsigned int i = 0; i < n_nodes; ++i)
          for (unsigned int c = 0; c < dim; ++c)
            momentum.local_element(dim * nodes[i] + c) +=
                coefficient * shape[q * n_nodes + i] * u[c];
      }
  }

  template <int dim>
  void BoundaryFaces<dim>::subtract_traction(const Id id, const TractionFunction<dim> &traction,
                                             const double time, Vector &momentum) const
  {
    const Part &part = part_of_id.at(id);
    for (unsigned int f = 0; f < n_faces(part); ++f)
      for (unsigned int q = 0; q < n_points; ++q)
      {
        const Tensor<1, dim> &da = part.face_area[f * n_points + q];
        const double area = da.norm();
        const Tensor<1, dim> force =
            area *
            traction(dealii::Point<dim>(part.face_points[f * n_points + q]), da / area, time);
        for (unsigned int i = 0; i < n_nodes; ++i)
          for (unsigned int c = 0; c < dim; ++c)
            momentum.local_element(dim * part.face_nodes[f * n_nodes + i] + c) -=
                shape[q * n_nodes + i] * force[c];
      }
  }

  template <int dim>
  void BoundaryFaces<dim>::add_lumen_normals(const Id id, const double factor, Vector &vector) const
  {
    const Part &part = part_of_id.at(id);
    for (unsigned int f = 0; f < n_faces(part); ++f)
      if (part.face_cell[f].batch < spaces.n_batches())
        for (unsigned int q = 0; q < n_points; ++q)
          for (unsigned int i = 0; i < n_nodes; ++i)
            for (unsigned int c = 0; c < dim; ++c)
              vector.local_element(dim * part.face_nodes[f * n_nodes + i] + c) +=
                  factor * shape[q * n_nodes + i] * part.face_area[f * n_points + q][c];
  }

  template <int dim>
  std::vector<double> BoundaryFaces<dim>::mass_matrices(const Id id) const
  {
    const Part &part = part_of_id.at(id);
    std::vector<double> result(n_faces(part) * n_nodes * n_nodes, 0.);
    for (unsigned int f = 0; f < n_faces(part); ++f)
      for (unsigned int q = 0; q < n_points; ++q)
      {
        const double area = part.face_area[f * n_points + q].norm();
        for (unsigned int i = 0; i < n_nodes; ++i)
          for (unsigned int j = 0; j < n_nodes; ++j)
            result[(f * n_nodes + i) * n_nodes + j] +=
                area * shape[q * n_nodes + i] * shape[q * n_nodes + j];
      }
    return result;
  }

  template class BoundaryFaces<2>;
  template class BoundaryFaces<3>;
} // namespace semilunar::flow
