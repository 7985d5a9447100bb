// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_flow_mesh_motion_h
#define semilunar_flow_mesh_motion_h

#include <semilunar/flow/velocity_constraints.h>
#include <semilunar/flow/wall_nodes.h>

#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

namespace semilunar::flow
{
  /// Moves the nodes of the lumen after the wall: elastostatics of the vertices with stiffening of
  /// small cells, equation (6) of doc/theory/wall.md; nodes between vertices follow. The matrix is
  /// made once for a mesh.
  template <int dim>
  class MeshMotion
  {
  public:
    /// @param conditions nodes slide in slip boundaries and open ones, and stay where velocities
    ///   are given and at rigid walls
    MeshMotion(const Spaces<dim> &spaces, const WallNodes<dim> &nodes,
               const BoundaryConditions<dim> &conditions);

    /// After construction and when the mesh was refined. Collective.
    /// @param reference positions of the nodes, readable
    /// @param faces their geometry that of the reference
    void reinit(const Vector &reference, const BoundaryFaces<dim> &faces);

    /// Find the positions of all nodes from those of the wall's. Collective.
    /// @return iterations
    unsigned int solve(Vector &positions);

    /// The next solution starts from zero, as it does in a run that goes on from a file.
    void forget_solution();

    /// Smallest scaled Jacobian at the vertices of the cells of the lumen (doc/theory/mesh.md).
    /// Collective. @param positions readable
    double min_scaled_jacobian(const Vector &positions) const;

  private:
    using CellIterator = typename dealii::DoFHandler<dim>::active_cell_iterator;

    void set_constraints(const BoundaryFaces<dim> &faces);
    void constrain(dealii::types::global_dof_index first,
                   const typename VelocityConstraints<dim>::Entry &entry);
    void assemble();
    void cell_matrix(const dealii::FEValues<dim> &values, dealii::FullMatrix<double> &matrix) const;
    template <class Value>
    void give(const Value &value);
    void find_load();
    void follow_vertices(const Vector &displacement, Vector &positions) const;
    void add_surplus(Vector &displacement) const;

    /// Stored velocity node of a vertex of a cell.
    unsigned int node_of(const CellIterator &cell, unsigned int vertex) const;

    const Spaces<dim> &spaces;
    const WallNodes<dim> &wall_nodes;
    BoundaryConditions<dim> conditions;
    const dealii::FESystem<dim> element;
    dealii::DoFHandler<dim> vertices;
    dealii::AffineConstraints<double> hanging, constraints;
    dealii::TrilinosWrappers::SparseMatrix matrix;
    dealii::TrilinosWrappers::PreconditionAMG multigrid;
    Vector solution, given; ///< displacements of vertices: free ones, and what the wall gives
    Vector load;
    Vector reference;

    /// Owned vertices of the wall: number of the first component, velocity node.
    std::vector<std::pair<unsigned int, unsigned int>> wall_vertices;
    /// Cells of the lumen that touch the wall, with their matrices.
    struct CellAtWall
    {
      std::vector<dealii::types::global_dof_index> dofs;
      dealii::FullMatrix<double> matrix;
    };
    std::vector<CellAtWall> cells_at_wall;
    std::vector<double> vertex_weight; ///< [lexicographic node][vertex]
  };
} // namespace semilunar::flow

#endif
