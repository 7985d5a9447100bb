// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/spline/unstructured_functions.h>

namespace semilunar::spline
{
  using TurnedFace = QuadMesh::TurnedFace;

  UnstructuredFunctions::UnstructuredFunctions(const QuadMesh &mesh) : mesh(mesh)
  {
    for (unsigned int v = 0; v < mesh.n_vertices(); ++v)
    {
      first.push_back(n);
      n += !mesh.is_on_boundary(v) ? 1 : mesh.valence(v) == 1 ? 4 : 2;
    }
  }

  unsigned int UnstructuredFunctions::number(const TurnedFace &corner,
                                             const std::array<unsigned int, 2> &shifts) const
  {
    const unsigned int v = mesh.vertex(corner, 0, 0);
    if (!mesh.is_on_boundary(v))
      return first[v];
    if (mesh.valence(v) == 2)
      return first[v] + shifts[0] + shifts[1]; // one of them is across the boundary
    // number the shifts of a corner alike from whatever turn it is seen: by its only face
    return first[v] + shifts[0] + 2 * shifts[1];
  }

  std::vector<unsigned int> UnstructuredFunctions::at(const unsigned int vertex) const
  {
    const unsigned int end = vertex + 1 < first.size() ? first[vertex + 1] : n;
    std::vector<unsigned int> numbers;
    for (unsigned int i = first[vertex]; i < end; ++i)
      numbers.push_back(i);
    return numbers;
  }

  std::vector<ControlPoint> clamped_net(const QuadMesh &mesh, const std::vector<Point<3>> &places)
  {
    const UnstructuredFunctions functions(mesh);
    std::vector<ControlPoint> points(functions.size());
    for (unsigned int v = 0; v < mesh.n_vertices(); ++v)
      for (const TurnedFace &corner : mesh.faces_at(v))
        for (const unsigned int outer_1 : {0u, 1u})
          for (const unsigned int outer_0 : {0u, 1u})
          {
            const bool across_0 = !mesh.left(corner), across_1 = !mesh.down(corner);
            if ((!across_0 && outer_0 == 1) || (!across_1 && outer_1 == 1))
              continue;
            const double s = across_0 && outer_0 == 0 ? 1. / 3. : 0.;
            const double t = across_1 && outer_1 == 0 ? 1. / 3. : 0.;
            const auto at = [&](const unsigned int i, const unsigned int j)
            { return places[mesh.vertex(corner, i, j)]; };
            points[functions.number(corner, {{outer_0, outer_1}})].position =
                (1. - t) * ((1. - s) * at(0, 0) + s * at(1, 0)) +
                t * ((1. - s) * at(0, 1) + s * at(1, 1));
          }
    return points;
  }
} // namespace semilunar::spline
