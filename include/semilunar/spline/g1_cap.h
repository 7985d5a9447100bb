// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_spline_g1_cap_h
#define semilunar_spline_g1_cap_h

#include <semilunar/spline/linear_form.h>
#include <semilunar/spline/quad_mesh.h>

#include <map>
#include <vector>

namespace semilunar::spline
{
  /// The Bernstein coefficients of a face as combinations of control points, index j (d+1) + i for
  /// degree d.
  using FaceCoefficients = std::vector<LinearForm>;

  /// Degree of the faces around extraordinary points.
  constexpr unsigned int cap_degree = 5;

  /// Number of the coefficient that is `along` from corner `side` and `inside` from that side.
  unsigned int side_index(unsigned int degree, unsigned int side, unsigned int along,
                          unsigned int inside);

  /// Raise a face from bicubic to biquintic.
  FaceCoefficients elevated(const FaceCoefficients &bicubic);

  /// Faces around extraordinary points that join each other G1 and their regular neighbours C1.
  struct G1Cap
  {
    std::map<unsigned int, FaceCoefficients> faces;
    /// What the control points of the cap's own functions are combinations of: these functions
    /// have the numbers first_own, first_own + 1, ...
    std::vector<LinearForm> own;
  };

  /// Coefficients of such faces with the smallest change of given ones, (U4) to (U7).
  /// @param faces    irregular faces that share edges; none of their irregular neighbours is
  /// missing
  /// @param regular  elevated coefficients of the regular neighbours of these faces
  /// @param initial  elevated coefficients of the faces to start from
  /// @param with_own_functions  make all coefficients that are free control points, (U8)
  /// @throws NumericsError if the conditions contradict each other
  G1Cap g1_cap(const QuadMesh &mesh, const std::vector<unsigned int> &faces,
               const std::map<unsigned int, FaceCoefficients> &regular,
               const std::map<unsigned int, FaceCoefficients> &initial, bool with_own_functions,
               unsigned int first_own);
} // namespace semilunar::spline

#endif
