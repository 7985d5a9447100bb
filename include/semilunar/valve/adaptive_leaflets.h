// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_valve_adaptive_leaflets_h
#define semilunar_valve_adaptive_leaflets_h

#include <semilunar/spline/t_spline.h>
#include <semilunar/valve/design.h>

namespace semilunar::valve
{
  /// Leaflets that are refined where elements are marked. All keep the same mesh, symmetric about
  /// the middle of the leaflet, whatever is marked.
  class AdaptiveLeaflets
  {
  public:
    /// @param n_leaflets that the surface consists of: one, or all of the design's
    /// @throws InputError for a design whose layout is not that of T-splines
    AdaptiveLeaflets(const Design &design, unsigned int n_leaflets);

    /// As leaflet() or leaflets() of leaflets.h.
    spline::Surface surface() const;

    /// The mesh of a leaflet.
    const spline::TSpline &leaflet() const { return t_spline; }

    /// Halve the elements of which a Bezier element of the surface is marked, and their images on
    /// the other leaflets and in the mirror, with what (T5) adds. The surface stays what it is.
    /// @return the matrix that maps homogeneous control points of the old surface to the new one:
    /// for positions as for deformed positions
    spline::RefinementMatrix refine(const std::vector<unsigned int> &marked);

  private:
    const Design design;
    const unsigned int n;
    spline::TSpline t_spline;
  };
} // namespace semilunar::valve

#endif
