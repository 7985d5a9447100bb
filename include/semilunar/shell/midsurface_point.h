// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_shell_midsurface_point_h
#define semilunar_shell_midsurface_point_h

#include <semilunar/shell/section.h>
#include <semilunar/spline/evaluation.h>

namespace semilunar::shell
{
  /// First and second derivatives of an energy (or a force and its derivative) at a point of the
  /// midsurface with respect to the jet r, r_,1, r_,2, r_,11, r_,22, r_,12 of the deformed
  /// midsurface: g[d][i] and H[d][i][e][j], per undeformed area.
  struct PointResponse
  {
    double gradient[spline::n_derivatives][3] = {};
    double hessian[spline::n_derivatives][3][spline::n_derivatives][3] = {};
  };

  /// First and second fundamental forms of the midsurface with this jet.
  struct FundamentalForms
  {
    Symmetric a, b;
    spline::Tensor<1, 3> normal;
  };
  FundamentalForms fundamental_forms(const spline::SurfaceJet &jet);

  /// Kirchhoff-Love strain energy of the point: equations (K5) to (K9) of doc/theory/shell.md.
  /// Derivatives in the jet are with respect to the orthonormal coordinates of the undeformed
  /// point. Overwrites the response; its Hessian only if with_tangent. @return energy per
  /// undeformed area
  /// @param predicted resultants of the geometric part of the Hessian in place of the state's own,
  /// unless null
  double strain_response(const Section &section, const spline::SurfaceJet &jet, const Symmetric &b0,
                         const std::array<double, 2> &fibre, bool with_tangent,
                         PointResponse &response, const Resultants *predicted = nullptr);

  /// The resultants that the linearisation at a midsurface predicts after a change: (K12).
  Resultants predict_resultants(const Section &section, const spline::SurfaceJet &jet,
                                const spline::SurfaceJet &change, const Symmetric &b0,
                                const std::array<double, 2> &fibre);

  /// Add the follower pressure p acting against the normal, force -p n per deformed area: (K10).
  void add_pressure(const spline::SurfaceJet &jet, double pressure, bool with_tangent,
                    PointResponse &response);
} // namespace semilunar::shell

#endif
