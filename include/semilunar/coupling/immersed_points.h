// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_coupling_immersed_points_h
#define semilunar_coupling_immersed_points_h

#include <semilunar/coupling/cell_map.h>

namespace semilunar::coupling
{
  /// Where points of a surface are in the mesh of the fluid: each belongs to the rank and the cell
  /// that hold it. Positions are known to all ranks, as is everything else about a surface; what
  /// passes from rank to rank is which points crossed over.
  ///
  /// (deal.II's ParticleHandler was tried first: on curved cells it took some ten microseconds more
  /// for each point and step, as it does not start from where in its cell a particle was.)
  class ImmersedPoints
  {
  public:
    using Position = dealii::Tensor<1, 3>;

    /// Find the points. Those outside of the mesh take no part. Collective.
    ImmersedPoints(const flow::FlowSolver<3> &flow, const std::vector<Position> &positions);

    /// Follow the points to new positions; what comes after these is ignored. Collective.
    /// @throws NumericsError on all ranks if a point that was in the fluid has left it
    void move(const std::vector<Position> &positions);

    /// Follow a mesh that has moved under the points: those that it has left take no part any more,
    /// those that it has reached do. Collective.
    void follow_mesh(const std::vector<Position> &positions);

    /// Find all points anew, as after the mesh was refined, wherever they were before. Collective.
    /// @throws NumericsError on all ranks if a point that was in the fluid is not found
    void search_again(const std::vector<Position> &positions);

    /// A point in a cell of this rank.
    struct Local
    {
      unsigned int q;
      unsigned int active_cell_index;
      dealii::Point<3> unit_point;
    };
    /// Those of this rank, in ascending order of q.
    const std::vector<Local> &local() const { return of_this_rank; }

    /// Whether a point was in the mesh from the start, or at the last follow_mesh(); the same on
    /// all ranks.
    bool takes_part(const unsigned int q) const { return participants[q]; }

    /// Of all ranks.
    unsigned int n_inside() const { return inside; }
    unsigned int n_points() const { return participants.size(); }

  private:
    struct Held
    {
      unsigned int q;
      CellMap::Place place;
    };
    /// Walk from the places where points were.
    void walk(const std::vector<Position> &positions);
    /// Search the whole mesh for these points, and keep what this rank owns.
    void search(const std::vector<Position> &positions, const std::vector<unsigned int> &which);
    /// Give points in cells of other ranks to these.
    void hand_over(const std::vector<Position> &positions, const std::vector<Held> &leaving);
    void collect();
    std::vector<unsigned int> missing() const;
    void exclude_missing();
    void search_all(const std::vector<Position> &positions);
    [[noreturn]] void throw_lost(const std::vector<Position> &positions) const;

    const flow::FlowSolver<3> &flow;
    const MPI_Comm communicator;
    const CellMap map;
    unsigned int inside = 0;
    std::vector<bool> participants;
    std::vector<Held> held;
    std::vector<Local> of_this_rank;
  };
} // namespace semilunar::coupling

#endif
