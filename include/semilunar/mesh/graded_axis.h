// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_mesh_graded_axis_h
#define semilunar_mesh_graded_axis_h

namespace semilunar::mesh
{
  /// An interval with a smoothly varying density of cells, higher in a zone inside it: (H1).
  class GradedAxis
  {
  public:
    /// @param begin,end of the interval
    /// @param zone_begin,zone_end where cells are shorter
    /// @param transition the length w over which their size changes, > 0
    /// @param ratio the factor c by which they are shorter; 1 for cells of one size
    GradedAxis(double begin, double end, double zone_begin, double zone_end, double transition,
               double ratio);

    /// The grid coordinate in [0,1] of a position; continued smoothly outside of the interval.
    double coordinate(double z) const;
    /// Its inverse.
    double position(double coordinate) const;
    /// dz / d coordinate at a position.
    double stretch(double z) const;

  private:
    const double begin, end, zone_begin, zone_end, transition, ratio;
    double n_begin, n_total;

    double count(double z) const;
    double density(double z) const;
  };
} // namespace semilunar::mesh

#endif
