// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_flow_boundary_faces_h
#define semilunar_flow_boundary_faces_h

#include <semilunar/flow/boundary_conditions.h>
#include <semilunar/flow/spaces.h>

#include <map>

namespace semilunar::flow
{
  /// A linear functional with few entries, each on the rank that owns it.
  struct SparseFunctional
  {
    std::vector<unsigned int> index;
    std::vector<double> value;

    /// The part of this rank.
    double local_value(const Vector &vector) const;
    /// vector += factor times the coefficients
    void add(double factor, Vector &vector) const;
  };

  /// The faces of each part of the boundary, and integrals over them.
  template <int dim>
  class BoundaryFaces
  {
  public:
    using Id = dealii::types::boundary_id;

    struct Part
    {
      SparseFunctional flow_rate;      ///< of a velocity: integral of u.n
      SparseFunctional pressure;       ///< of a pressure: integral of p
      double area = 0.;                ///< of all ranks [cm^(dim-1)]
      Vector normals;                  ///< integral of n phi_i of each node, readable
      std::vector<unsigned int> nodes; ///< stored nodes on this part that the rank sees, sorted

      // Faces of owned cells: nodes and n dA at the Gauss points, [face][node], [face][point];
      // then beta rho |w.n| dA where fluid enters.
      std::vector<unsigned int> face_nodes, face_pressure_nodes;
      std::vector<dealii::Tensor<1, dim>> face_area, face_points;
      std::vector<double> inflow;
      std::vector<CellLane> face_cell;        ///< where the cell of a face is worked on
      std::vector<unsigned int> face_of_cell; ///< its number in the cell
    };

    explicit BoundaryFaces(const Spaces<dim> &spaces);

    /// Find the faces. Collective: a part exists on all ranks if one has a face of it.
    void reinit();
    /// @param positions of the nodes, readable
    void update_geometry(const Vector &positions);

    const std::map<Id, Part> &parts() const { return part_of_id; }
    const Part &part(Id id) const { return part_of_id.at(id); }

    /// beta rho |{(u - uhat).n}_-| at the Gauss points of a part (equation (9)).
    void linearise_backflow(Id id, double coefficient, const Vector &velocity,
                            const Vector *mesh_velocity);
    /// momentum += (that coefficient) u.
    void add_backflow(Id id, const Vector &velocity, Vector &momentum) const;
    /// momentum -= traction h(x, n, t).
    void subtract_traction(Id id, const TractionFunction<dim> &traction, double time,
                           Vector &momentum) const;
    /// vector += factor times the integrals of n phi_i over those faces of a part that the lumen's
    /// cells have.
    void add_lumen_normals(Id id, double factor, Vector &vector) const;

    unsigned int n_face_nodes() const { return n_nodes; }
    /// Integrals of products of the shape functions over each face of owned cells,
    /// [face][node][node].
    std::vector<double> mass_matrices(Id id) const;

    /// Calls add(cell, i, j, value) for lexicographic cell nodes i, j with backflow matrix entries.
    template <class Add>
    void backflow_matrix(Id id, const Add &add) const;

  private:
    void collect(Id id, const typename dealii::DoFHandler<dim>::active_cell_iterator &cell,
                 unsigned int face);
    void tabulate();
    void update_functionals(Part &part);
    unsigned int n_faces(const Part &part) const { return part.face_nodes.size() / n_nodes; }
    unsigned int cell_node(unsigned int face, unsigned int i) const
    {
      return node_of_face[face * n_nodes + i];
    }

    const Spaces<dim> &spaces;
    unsigned int n_nodes = 0, n_points = 0, n_pressure_nodes = 0; ///< of a face
    std::vector<double> shape, pressure_shape;                    ///< [point][node]
    std::vector<std::array<double, dim - 1>> derivatives;         ///< [point][node], in the face
    std::vector<double> weights;
    std::vector<unsigned int> node_of_face, pressure_node_of_face; ///< [face][i]: node of the cell
    std::map<Id, Part> part_of_id;
  };

  template <int dim>
  template <class Add>
  void BoundaryFaces<dim>::backflow_matrix(const Id id, const Add &add) const
  {
    const Part &part = part_of_id.at(id);
    for (unsigned int f = 0; f < n_faces(part); ++f)
      for (unsigned int q = 0; q < n_points; ++q)
      {
        const double coefficient = part.inflow[f * n_points + q];
        if (coefficient > 0.)
          for (unsigned int i = 0; i < n_nodes; ++i)
            for (unsigned int j = 0; j < n_nodes; ++j)
              add(part.face_cell[f], cell_node(part.face_of_cell[f], i),
                  cell_node(part.face_of_cell[f], j),
                  coefficient * shape[q * n_nodes + i] * shape[q * n_nodes + j]);
      }
  }
} // namespace semilunar::flow

#endif
