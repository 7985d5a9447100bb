// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_flow_mesh_motion_h
#define semilunar_flow_mesh_motion_h

#include <semilunar/flow/mesh_interpolation.h>
#include <semilunar/flow/velocity_constraints.h>

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
    /// @param positions those of other nodes are a first guess
    /// @return iterations
    unsigned int solve(Vector &positions);

  private:
    using Index = dealii::types::global_dof_index;
    using Entries = std::vector<SparseMap::Entry>;

    void number_vertices();
    void set_constraints(const BoundaryFaces<dim> &faces);
    void constrain(Index first, const typename VelocityConstraints<dim>::Entry &entry);
    void find_dependent();
    void assemble();
    void make_multigrid();
    unsigned int find_free_displacements();
    void cell_matrix(const dealii::FEValues<dim> &values, dealii::FullMatrix<double> &matrix) const;
    /// Displacements on which one depends: free ones; those of the wall.
    Entries free_masters(Index dof) const;
    Entries wall_masters(Index dof) const;
    unsigned int stored(const Index dof) const
    {
      return solution.get_partitioner()->global_to_local(dof);
    }

    const Spaces<dim> &spaces;
    const WallNodes<dim> &wall_nodes;
    BoundaryConditions<dim> conditions;
    const dealii::FESystem<dim> element;
    dealii::DoFHandler<dim> vertices;
    dealii::AffineConstraints<double> hanging, constraints;
    dealii::TrilinosWrappers::SparseMatrix matrix;
    dealii::TrilinosWrappers::PreconditionAMG multigrid;
    MeshInterpolation<dim> interpolation;
    Vector reference;
    // Of vertices, dim components each.
    Vector solution, given; ///< displacements: all, and those of the wall alone
    Vector load;
    std::vector<unsigned int> node_of_vertex; ///< stored velocity node of a stored vertex
    std::vector<bool> of_wall;                ///< stored vertices that do not hang
    std::vector<unsigned int> vertex_of_cell; ///< [batch][lane][vertex], cells of the lumen
    std::vector<unsigned int> constrained;    ///< owned entries, those of the wall included
    SparseMap dependent;     ///< constrained displacements from those of free and wall's vertices
    SparseMap force_of_wall; ///< loads on free vertices from displacements of the wall's
  };
} // namespace semilunar::flow

#endif
