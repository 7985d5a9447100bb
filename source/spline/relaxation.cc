// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/spline/relaxation.h>

#include <algorithm>
#include <set>

namespace semilunar::spline
{
  void relax(const QuadMesh &mesh, std::vector<Point<2>> &places)
  {
    std::vector<std::set<unsigned int>> neighbours(mesh.n_vertices());
    for (unsigned int f = 0; f < mesh.n_faces(); ++f)
      for (unsigned int k = 0; k < 4; ++k)
      {
        const unsigned int v = mesh.face(f)[k], w = mesh.face(f)[(k + 1) % 4];
        neighbours[v].insert(w);
        neighbours[w].insert(v);
      }
    constexpr double over_relaxation = 1.8, converged = 1e-12;
    for (double change = 1.; change > converged;)
    {
      change = 0.;
      for (unsigned int v = 0; v < mesh.n_vertices(); ++v)
      {
        if (mesh.is_on_boundary(v))
          continue;
        Tensor<1, 2> mean;
        for (const unsigned int w : neighbours[v])
          mean += places[w] / double(neighbours[v].size());
        const Tensor<1, 2> step = over_relaxation * (mean - places[v]);
        places[v] += step;
        change = std::max(change, step.norm());
      }
    }
  }
} // namespace semilunar::spline
