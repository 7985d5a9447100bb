// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_spline_cyclic_symmetry_h
#define semilunar_spline_cyclic_symmetry_h

#include <semilunar/spline/surface.h>

namespace semilunar::spline
{
  /// One of n equal sectors stands for a body that looks the same after a turn about the z axis by
  /// 1/n of a full turn. Image k of something is itself turned by k/n, image 0 the sector.
  class CyclicSymmetry
  {
  public:
    /// @param n_sectors 1: no symmetry
    explicit CyclicSymmetry(unsigned int n_sectors = 1);

    unsigned int n_sectors() const { return turns.size(); }

    /// The rotation matrix of image k < n_sectors.
    const dealii::Tensor<2, 3> &turn(const unsigned int k) const { return turns[k]; }

    /// The whole body: the control points and elements of image 0, then those of image 1, ... Sets
    /// hold the members of all images.
    Surface whole(const Surface &sector) const;
    /// Vectors of all images in the order of whole().
    std::vector<Tensor<1, 3>> whole(const std::vector<Tensor<1, 3>> &sector) const;

  private:
    std::vector<dealii::Tensor<2, 3>> turns;
  };
} // namespace semilunar::spline

#endif
