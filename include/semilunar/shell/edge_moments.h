// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_shell_edge_moments_h
#define semilunar_shell_edge_moments_h

#include <semilunar/shell/assembly.h>
#include <semilunar/shell/loads.h>

namespace semilunar::shell
{
  /// Moments along edges that follow the rotation of the shell: (L1) and (L2) of
  /// doc/theory/shell.md.
  class EdgeMoments
  {
  public:
    /// @throws InputError for moments that name no edge of the surface
    EdgeMoments(const spline::Surface &surface, const LoadParameters &parameters);

    /// With control points at x and the given load factor, subtract the forces from these, and hand
    /// the derivative of what was added to add_block unless that is empty.
    void add(const ControlVectors &x, double load, ControlVectors &forces,
             const Assembly::AddBlock &add_block) const;

  private:
    /// A Gauss point of an edge.
    struct Point
    {
      unsigned int element;
      unsigned int across;                      ///< direction of the element across the edge
      double outward;                           ///< +1 if that direction leads out of the shell
      double moment;                            ///< times weight and undeformed length
      std::array<std::vector<double>, 2> basis; ///< derivatives in both directions
    };
    const spline::Surface &surface;
    std::vector<Point> points;

    void append_points(const spline::ElementSide &side, double moment);
  };
} // namespace semilunar::shell

#endif
