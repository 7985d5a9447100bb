// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/spline/closest_point.h>
#include <semilunar/spline/patches.h>

#include <algorithm>
#include <numeric>

namespace semilunar::spline
{
  Surface join(std::vector<NurbsPatch> patches, const unsigned int degree, const double tolerance)
  {
    unsigned int highest = degree;
    for (const NurbsPatch &patch : patches)
      highest = std::max({highest, patch.knots(0).degree(), patch.knots(1).degree()});
    Surface surface;
    for (unsigned int k = 0; k < patches.size(); ++k)
    {
      for (unsigned int d = 0; d < 2; ++d)
        patches[k].elevate_degree(d, highest - patches[k].knots(d).degree());
      Surface part = to_surface(patches[k]);
      NamedSet all{SetKind::element, "patch" + std::to_string(k + 1),
                   std::vector<unsigned int>(part.elements.size())};
      std::iota(all.members.begin(), all.members.end(), 0u);
      part.sets = {all};
      append(surface, part, tolerance);
    }
    return surface;
  }

  std::vector<NurbsPatch> bezier_patches(const Surface &surface)
  {
    const std::vector<Tensor<1, 3>> x = positions(surface);
    std::vector<NurbsPatch> patches;
    for (unsigned int e = 0; e < surface.elements.size(); ++e)
    {
      const BezierPatch bezier = bezier_patch(surface, e, x);
      std::vector<ControlPoint> net;
      for (const auto &h : bezier.coefficients)
        net.push_back({Point<3>(h[0] / h[3], h[1] / h[3], h[2] / h[3]), h[3]});
      patches.emplace_back(std::array<KnotVector, 2>{{KnotVector::uniform(bezier.degree[0], 1),
                                                      KnotVector::uniform(bezier.degree[1], 1)}},
                           net);
    }
    return patches;
  }
} // namespace semilunar::spline
