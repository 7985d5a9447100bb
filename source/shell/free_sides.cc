// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/shell/free_sides.h>
#include <semilunar/shell/oriented_box.h>
#include <semilunar/shell/spatial_hash.h>

#include <algorithm>
#include <limits>

namespace semilunar::shell
{
  using namespace spline;

  std::vector<std::array<bool, 4>> free_sides(const Surface &surface)
  {
    constexpr double relative_tolerance = 1e-6; // of the smallest element's longest extent
    const std::vector<Tensor<1, 3>> x = positions(surface);
    std::vector<BezierPatch> patches;
    std::vector<OrientedBox> oriented;
    double size = std::numeric_limits<double>::max();
    for (unsigned int e = 0; e < surface.elements.size(); ++e)
    {
      patches.push_back(bezier_patch(surface, e, x));
      oriented.emplace_back(patches.back());
      const Tensor<1, 3> extent = oriented[e].upper_corner() - oriented[e].lower_corner();
      size = std::min(size, std::max({extent[0], extent[1], extent[2]}));
    }
    const double tolerance = relative_tolerance * size;

    Tensor<1, 3> margin;
    for (unsigned int d = 0; d < 3; ++d)
      margin[d] = tolerance;
    std::vector<SpatialHash::Box> boxes;
    for (const OrientedBox &box : oriented)
      boxes.push_back({box.lower_corner() - margin, box.upper_corner() + margin});
    SpatialHash hash;
    hash.build(boxes, tolerance);

    const std::array<Point<2>, 4> midpoints{
        {Point<2>(0., 0.5), Point<2>(1., 0.5), Point<2>(0.5, 0.), Point<2>(0.5, 1.)}};
    std::vector<std::array<bool, 4>> result(patches.size());
    for (unsigned int e = 0; e < patches.size(); ++e)
      for (unsigned int side = 0; side < 4; ++side)
      {
        const Tensor<1, 3> midpoint = evaluate(patches[e], midpoints[side])[spline::value];
        const auto near = hash.near(midpoint);
        result[e][side] = std::none_of(
            near.begin(), near.end(),
            [&](const unsigned int other)
            {
              return other != e && oriented[other].distance(midpoint) < tolerance &&
                     project(patches[other], midpoint, oriented[other].guess(midpoint)).distance <
                         tolerance;
            });
      }
    return result;
  }
} // namespace semilunar::shell
