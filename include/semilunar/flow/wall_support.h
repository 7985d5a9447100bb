// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_flow_wall_support_h
#define semilunar_flow_wall_support_h

#include <semilunar/flow/boundary_faces.h>

#include <set>

namespace semilunar::flow
{
  /// The tissue around an elastic wall: springs and dampers on parts of its boundary, equation (S1)
  /// of doc/theory/wall.md. They act per area at rest, so that they are linear.
  template <int dim>
  class WallSupport
  {
  public:
    explicit WallSupport(const Spaces<dim> &spaces) : spaces(spaces) {}

    /// After the mesh was made or refined.
    /// @param faces with the geometry at rest
    /// @param ids of the supported parts
    /// @throws InputError for a part without the wall's cells
    void reinit(const BoundaryFaces<dim> &faces, const std::set<dealii::types::boundary_id> &ids);

    /// momentum += factor (field, v) over the supported faces of owned cells, from readable nodal
    /// values of the field.
    void add(double factor, const Vector &values, Vector &momentum) const;

    /// Calls add(row, column, entry) with the entries of that matrix between stored nodes, each the
    /// same for all components. What the faces of other ranks add is lumped.
    template <class Add>
    void matrix(const Add &add) const;

  private:
    /// @return whether any rank has a face of the wall there
    bool add_part(const BoundaryFaces<dim> &faces, dealii::types::boundary_id id);
    /// Areas of nodes on faces of other ranks. Collective.
    void find_areas_of_others();

    const Spaces<dim> &spaces;
    unsigned int n_face_nodes = 0;
    std::vector<unsigned int> nodes;                        ///< [face][node]: stored
    std::vector<double> mass;                               ///< [face][node][node] [cm^(dim-1)]
    std::vector<std::pair<unsigned int, double>> of_others; ///< stored node, area [cm^(dim-1)]
  };

  template <int dim>
  template <class Add>
  void WallSupport<dim>::matrix(const Add &add) const
  {
    for (const auto &[node, area] : of_others)
      add(node, node, area);
    const unsigned int n = n_face_nodes;
    std::vector<HangingNodes::Master> rows, columns;
    for (unsigned int k = 0; k < mass.size(); ++k)
    {
      spaces.velocity_hanging().masters_of(nodes[k / n], rows);
      spaces.velocity_hanging().masters_of(nodes[k / (n * n) * n + k % n], columns);
      for (const auto &row : rows)
        for (const auto &column : columns)
          add(row.node, column.node, row.weight * column.weight * mass[k]);
    }
  }
} // namespace semilunar::flow

#endif
