// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/flow/wall_support.h>

#include <deal.II/base/mpi.h>

namespace semilunar::flow
{
  template <int dim>
  void WallSupport<dim>::reinit(const BoundaryFaces<dim> &faces,
                                const std::set<dealii::types::boundary_id> &ids)
  {
    n_face_nodes = faces.n_face_nodes();
    nodes.clear();
    mass.clear();
    for (const auto id : ids)
      if (faces.parts().count(id) == 0 || !add_part(faces, id))
        throw InputError("Wall/Supported boundaries", std::to_string(id),
                         "no cell of the wall lies at this part of the boundary",
                         "name a boundary of the wall");
    find_areas_of_others();
  }

  template <int dim>
  void WallSupport<dim>::find_areas_of_others()
  {
    Vector area(spaces.nodes());
    for (unsigned int k = 0; k < mass.size(); ++k)
      area.local_element(nodes[k / n_face_nodes]) += mass[k];
    spaces.velocity_hanging().template fold<1>(area.begin());
    const std::vector<double> own(area.begin(), area.begin() +
                                                    spaces.nodes()->locally_owned_size() +
                                                    spaces.nodes()->n_ghost_indices());
    area.compress(dealii::VectorOperation::add);
    area.update_ghost_values();
    of_others.clear();
    constexpr double rounding = 1e-12;
    for (unsigned int node = 0; node < own.size(); ++node)
      if (area.local_element(node) > (1. + rounding) * own[node])
        of_others.emplace_back(node, area.local_element(node) - own[node]);
  }

  template <int dim>
  bool WallSupport<dim>::add_part(const BoundaryFaces<dim> &faces,
                                  const dealii::types::boundary_id id)
  {
    const auto &part = faces.part(id);
    const unsigned int n = n_face_nodes;
    const std::vector<double> matrices = faces.mass_matrices(id);
    unsigned int n_found = 0;
    for (unsigned int f = 0; f < part.face_cell.size(); ++f)
      if (part.face_cell[f].batch >= spaces.n_batches()) // in the wall
      {
        ++n_found;
        nodes.insert(nodes.end(), part.face_nodes.begin() + f * n,
                     part.face_nodes.begin() + (f + 1) * n);
        mass.insert(mass.end(), matrices.begin() + f * n * n, matrices.begin() + (f + 1) * n * n);
      }
    return dealii::Utilities::MPI::sum(n_found, spaces.communicator()) > 0;
  }

  template <int dim>
  void WallSupport<dim>::add(const double factor, const Vector &values, Vector &momentum) const
  {
    const unsigned int n = n_face_nodes;
    for (unsigned int k = 0; k < mass.size(); ++k)
    {
      const unsigned int row = nodes[k / n], column = nodes[k / (n * n) * n + k % n];
      for (unsigned int c = 0; c < dim; ++c)
        momentum.local_element(dim * row + c) +=
            factor * mass[k] * values.local_element(dim * column + c);
    }
  }

  template class WallSupport<2>;
  template class WallSupport<3>;
} // namespace semilunar::flow
