// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/spline/cyclic_symmetry.h>

#include <deal.II/base/numbers.h>

#include <cmath>

namespace semilunar::spline
{
  CyclicSymmetry::CyclicSymmetry(const unsigned int n_sectors)
  {
    for (unsigned int k = 0; k < n_sectors; ++k)
    {
      const double angle = 2. * dealii::numbers::PI * k / n_sectors;
      dealii::Tensor<2, 3> turn = dealii::unit_symmetric_tensor<3>();
      turn[0][0] = turn[1][1] = std::cos(angle);
      turn[1][0] = std::sin(angle);
      turn[0][1] = -turn[1][0];
      turns.push_back(turn);
    }
  }

  Surface CyclicSymmetry::whole(const Surface &sector) const
  {
    Surface all;
    for (const dealii::Tensor<2, 3> &turn : turns)
    {
      Surface image = sector;
      for (ControlPoint &point : image.control_points)
        point.position = Point<3>(turn * point.position);
      const double merge_nothing = -1.;
      append(all, image, merge_nothing);
    }
    return all;
  }

  std::vector<Tensor<1, 3>> CyclicSymmetry::whole(const std::vector<Tensor<1, 3>> &sector) const
  {
    std::vector<Tensor<1, 3>> all;
    all.reserve(turns.size() * sector.size());
    for (const dealii::Tensor<2, 3> &turn : turns)
      for (const Tensor<1, 3> &vector : sector)
        all.push_back(turn * vector);
    return all;
  }
} // namespace semilunar::spline
