// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_coupling_cells_near_surfaces_h
#define semilunar_coupling_cells_near_surfaces_h

#include <semilunar/flow/lanes.h>
#include <semilunar/flow/spaces.h>

namespace semilunar::coupling
{
  /// The cells that hold points of a surface, and all that touch one of these, on all ranks: where
  /// the fluid's incompressibility needs extra weight, (I7).
  class CellsNearSurfaces
  {
  public:
    explicit CellsNearSurfaces(const flow::Spaces<3> &spaces);

    /// Mark anew. @param cut active cell indices of owned cells with points. Collective.
    /// @return whether any cell changed on any rank
    bool mark(const std::vector<unsigned int> &cut);

    /// factor h^2 + constant in marked cells, 0 in others, by batch and lane.
    std::vector<flow::Lanes> weights(double factor, double constant) const;

    /// Marked, by active cell index; valid for owned and ghost cells.
    const std::vector<bool> &marked() const { return is_marked; }

  private:
    const flow::Spaces<3> &spaces;
    std::vector<bool> is_marked;
  };
} // namespace semilunar::coupling

#endif
