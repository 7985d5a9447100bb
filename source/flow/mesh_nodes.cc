// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/flow/mesh_nodes.h>
#include <semilunar/flow/nodal_values.h>

#include <deal.II/fe/fe_tools.h>
#include <deal.II/fe/mapping_q.h>

namespace semilunar::flow
{
  template <int dim>
  MeshNodes<dim>::MeshNodes(const Spaces<dim> &spaces, const dealii::Mapping<dim> &reference)
      : spaces(spaces), reference(reference.clone()), moved_mapping(spaces.degree())
  {
    put_at_rest();
  }

  template <int dim>
  void MeshNodes<dim>::put_at_rest()
  {
    const Vector positions = nodal_positions(spaces, *reference);
    for (Vector *copy : {&at_rest, &now, &old, &older})
    {
      copy->reinit(spaces.velocities()); // assignment alone may keep the ghosts of an old mesh
      *copy = positions;
      spaces.make_readable_velocity(*copy);
    }
    node_velocity.reinit(spaces.velocities());
    mapping_is_valid = false;
  }

  template <int dim>
  void MeshNodes<dim>::begin_motion(const Vector &positions, const Vector &old_positions)
  {
    mesh_moves = true;
    now = positions;
    old = old_positions;
    older = old;
    for (const Vector *vector : {&now, &old, &older})
      spaces.make_readable_velocity(*vector);
    mapping_is_valid = false;
  }

  template <int dim>
  void MeshNodes<dim>::start_step()
  {
    std::swap(older, old);
    old = now;
  }

  template <int dim>
  void MeshNodes<dim>::move(const Vector &positions, const Bdf &bdf)
  {
    mesh_moves = true;
    now = positions;
    spaces.make_readable_velocity(now);
    node_velocity.equ(bdf.alpha[0], now);
    node_velocity.add(bdf.alpha[1], old);
    if (bdf.alpha[2] != 0.)
      node_velocity.add(bdf.alpha[2], older);
    spaces.make_readable_velocity(node_velocity);
    mapping_is_valid = false;
  }

  template <int dim>
  Vector MeshNodes<dim>::extrapolated(const double r) const
  {
    Vector result(spaces.velocities());
    result.equ(1. + r, old);
    result.add(-r, older);
    return result;
  }

  template <int dim>
  void MeshNodes<dim>::reject_step()
  {
    now = old;
    std::swap(older, old);
    mapping_is_valid = false;
  }

  template <int dim>
  void MeshNodes<dim>::make_displacements()
  {
    for (Vector *vector : {&now, &old})
    {
      *vector -= at_rest;
      spaces.make_readable_velocity(*vector);
    }
  }

  template <int dim>
  void MeshNodes<dim>::renew(const bool moves, const bool from_displacements)
  {
    const Vector carried = now, carried_old = old;
    put_at_rest();
    mesh_moves = moves;
    if (!mesh_moves)
      return;
    now = carried;
    old = carried_old;
    for (Vector *vector : {&now, &old})
    {
      if (from_displacements)
        *vector += at_rest;
      spaces.make_readable_velocity(*vector);
    }
    older = old;
  }

  template <int dim>
  const dealii::Mapping<dim> &MeshNodes<dim>::mapping() const
  {
    if (mapping_is_valid)
      return moved_mapping;
    // Cells that are not active have no nodes of their own: any shape will do.
    const dealii::MappingQ<dim> coarse(1);
    const auto &element = spaces.velocity_dofs().get_fe();
    const auto hierarchic =
        dealii::FETools::lexicographic_to_hierarchic_numbering<dim>(spaces.degree());
    moved_mapping.initialize(
        spaces.velocity_dofs().get_triangulation(),
        [&](const typename dealii::Triangulation<dim>::cell_iterator &cell)
        {
          std::vector<dealii::Point<dim>> points(element.dofs_per_cell);
          const bool known = cell->is_active() && !cell->is_artificial();
          const CellLane where = known ? spaces.lane_of(cell->active_cell_index()) : CellLane();
          for (unsigned int i = 0; i < points.size(); ++i)
            if (known)
              for (unsigned int c = 0; c < dim; ++c)
                points[hierarchic[i]][c] =
                    now.local_element(dim * spaces.velocity_nodes(where.batch)[i][where.lane] + c);
            else
              points[i] =
                  coarse.transform_unit_to_real_cell(cell, element.get_unit_support_points()[i]);
          return points;
        });
    mapping_is_valid = true;
    return moved_mapping;
  }

  template class MeshNodes<2>;
  template class MeshNodes<3>;
} // namespace semilunar::flow
