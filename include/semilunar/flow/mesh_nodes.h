// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_flow_mesh_nodes_h
#define semilunar_flow_mesh_nodes_h

#include <semilunar/flow/bdf.h>
#include <semilunar/flow/spaces.h>

#include <deal.II/fe/mapping_q_cache.h>

#include <memory>

namespace semilunar::flow
{
  /// The geometry of the flow: positions of the velocity nodes at the new time (equal to the old
  /// one between steps), at the old time and before, and the velocity of the mesh between them. All
  /// vectors are readable.
  template <int dim>
  class MeshNodes
  {
  public:
    /// @param reference gives the positions at rest, now and when the mesh is refined
    MeshNodes(const Spaces<dim> &spaces, const dealii::Mapping<dim> &reference);

    bool moving() const { return mesh_moves; }
    const Vector &positions() const { return now; }
    const Vector &old_positions() const { return old; }
    const Vector &older_positions() const { return older; }
    const Vector &reference_positions() const { return at_rest; }
    /// uhat; zero on a mesh that does not move
    const Vector &velocity() const { return node_velocity; }
    const Vector *velocity_if_moving() const { return mesh_moves ? &node_velocity : nullptr; }
    /// (1 + r) old - r older positions, owned entries
    Vector extrapolated(double r) const;
    /// Of the positions now: isoparametric.
    const dealii::Mapping<dim> &mapping() const;

    /// The mesh begins to move, between steps: positions now and a step ago.
    void begin_motion(const Vector &positions, const Vector &old_positions);
    void start_step();
    /// @param positions at the new time (readable not needed)
    void move(const Vector &positions, const Bdf &bdf);
    /// Back to where the step began.
    void reject_step();

    /// Before a refinement: carry displacements, so that new nodes lie on the surfaces at rest.
    void make_displacements();
    /// The positions, or the displacements, that are carried over to a new mesh.
    std::vector<Vector *> transferred() { return {&now, &old}; }
    /// After the unknowns were distributed on a new mesh and transferred() was filled.
    void renew(bool mesh_moves, bool from_displacements);

  private:
    void put_at_rest();

    const Spaces<dim> &spaces;
    const std::unique_ptr<dealii::Mapping<dim>> reference;
    Vector now, old, older, at_rest, node_velocity;
    bool mesh_moves = false;
    mutable dealii::MappingQCache<dim> moved_mapping;
    mutable bool mapping_is_valid = false;
  };
} // namespace semilunar::flow

#endif
