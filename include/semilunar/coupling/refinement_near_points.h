// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_coupling_refinement_near_points_h
#define semilunar_coupling_refinement_near_points_h

#include <deal.II/distributed/tria.h>

#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace semilunar::coupling
{
  /// How the fluid's mesh follows a surface: the entries of section "Refinement".
  struct RefinementParameters
  {
    unsigned int levels = 0;        ///< how often cells near the surface are halved
    double width = 2.;              ///< of the fine zone at each side, in widths of its cells
    unsigned int interval = 1;      ///< steps between looks at the mesh
    unsigned int max_cells = 50000; ///< beyond this the zone becomes narrower

    void add_parameters(dealii::ParameterHandler &prm);
  };

  /// Keeps the cells around points of a moving surface fine, and others as coarse as they began,
  /// (I8) of doc/theory/coupling.md. Whatever the number of ranks, the same cells.
  class RefinementNearPoints
  {
  public:
    using Triangulation = dealii::parallel::distributed::Triangulation<3>;
    using Position = dealii::Tensor<1, 3>;

    /// Refine around points before there are any fields. Collective.
    RefinementNearPoints(Triangulation &triangulation, const RefinementParameters &parameters,
                         const std::vector<Position> &points);

    /// Whether this step is one to look at the mesh, and points have come to cells that are not
    /// fine, or next to one. Collective.
    /// @param with_points active cell indices of the cells of this rank that hold points
    bool due(unsigned int step, const std::vector<unsigned int> &with_points) const;
    /// Flag cells for refinement and coarsening. Collective.
    /// @return whether any cell on any rank is flagged
    bool flag(const std::vector<Position> &points);

  private:
    Triangulation &triangulation;
    const RefinementParameters prm;
    const int coarsest, finest; ///< levels of cells
  };
} // namespace semilunar::coupling

#endif
