// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/spline/boundary_rows.h>
#include <semilunar/spline/evaluation.h>
#include <semilunar/spline/fit.h>
#include <semilunar/spline/relaxation.h>
#include <semilunar/spline/unstructured_spline.h>
#include <semilunar/valve/leaflet_unstructured.h>
#include <semilunar/valve/leaflets.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace semilunar::valve
{
  using spline::ControlPoint;
  using spline::NurbsPatch;
  using spline::Point;
  using spline::QuadMesh;
  using spline::SetKind;
  using spline::Surface;

  namespace
  {
    /// The mesh and where its vertices lie in the parameter space of the leaflet's patch. Vertices
    /// are numbered by their place in layers: layer l of the core's column, row.
    class LayeredMesh
    {
    public:
      explicit LayeredMesh(const UnstructuredLayout &layout)
          : nx(layout.n_core_along), ny(layout.n_core_across), n_layers(layout.n_layers)
      {
        for (unsigned int j = 0; j < ny; ++j)
          for (unsigned int i = 0; i < nx; ++i)
            faces.push_back({{core(i, j), core(i + 1, j), core(i + 1, j + 1), core(i, j + 1)}});
        for (unsigned int l = 0; l < n_layers; ++l)
          for (unsigned int k = 0; k < n_around(); ++k)
            faces.push_back(
                {{around(k, l + 1), around(k + 1, l + 1), around(k + 1, l), around(k, l)}});
      }

      QuadMesh mesh() const { return QuadMesh(n_vertices(), faces, "Valve/Unstructured"); }

      /// Edges from commissure to commissure along the attachment.
      unsigned int n_around() const { return nx + 2 * ny; }
      unsigned int n_vertices() const { return (nx + 1) * (ny + 1) + n_layers * (n_around() + 1); }

      /// Vertex number k along the attachment's layer l: 0 is the core's outline.
      unsigned int around(const unsigned int k, const unsigned int l) const
      {
        if (l > 0)
          return (nx + 1) * (ny + 1) + (l - 1) * (n_around() + 1) + k;
        if (k <= ny)
          return core(0, ny - k);
        return k <= ny + nx ? core(k - ny, 0) : core(nx, k - ny - nx);
      }

      /// The vertices of the free edge in the order of u.
      std::vector<unsigned int> free_edge() const
      {
        std::vector<unsigned int> vertices;
        for (unsigned int l = n_layers; l > 0; --l)
          vertices.push_back(around(0, l));
        for (unsigned int i = 0; i <= nx; ++i)
          vertices.push_back(core(i, ny));
        for (unsigned int l = 1; l <= n_layers; ++l)
          vertices.push_back(around(n_around(), l));
        return vertices;
      }

      std::vector<unsigned int> attachment() const
      {
        std::vector<unsigned int> vertices;
        for (unsigned int k = 0; k <= n_around(); ++k)
          vertices.push_back(around(k, n_layers));
        return vertices;
      }

    private:
      const unsigned int nx, ny, n_layers;
      std::vector<QuadMesh::Face> faces;

      unsigned int core(const unsigned int i, const unsigned int j) const
      {
        return j * (nx + 1) + i;
      }
    };

    /// Points of the parameter space that divide a path of straight pieces into n parts of equal
    /// length on the surface.
    std::vector<Point<2>> equal_parts(const NurbsPatch &patch, const std::vector<Point<2>> &path,
                                      const unsigned int n)
    {
      constexpr unsigned int n_samples = 200; // for each piece
      std::vector<Point<2>> u;
      std::vector<double> length;
      for (unsigned int piece = 0; piece + 1 < path.size(); ++piece)
        for (unsigned int k = piece == 0 ? 0 : 1; k <= n_samples; ++k)
        {
          u.push_back(path[piece] + double(k) / n_samples * (path[piece + 1] - path[piece]));
          length.push_back(length.empty() ? 0.
                                          : length.back() + patch.evaluate(u.back()).distance(
                                                                patch.evaluate(u[u.size() - 2])));
        }
      std::vector<Point<2>> parts;
      for (unsigned int k = 0, s = 0; k <= n; ++k)
      {
        const double wanted = length.back() * k / n;
        while (s + 2 < length.size() && length[s + 1] < wanted)
          ++s;
        const double share = (wanted - length[s]) / (length[s + 1] - length[s]);
        parts.push_back(u[s] + std::clamp(share, 0., 1.) * (u[s + 1] - u[s]));
      }
      return parts;
    }

    /// Sides of elements along a chain of boundary vertices, as element and side.
    std::vector<spline::ElementSide> sides_along(const QuadMesh &mesh,
                                                 const std::vector<unsigned int> &vertices)
    {
      constexpr unsigned int side_of_corner[4] = {2, 1, 3, 0}; // between it and the next one
      const std::set<unsigned int> chain(vertices.begin(), vertices.end());
      std::vector<spline::ElementSide> sides;
      for (unsigned int f = 0; f < mesh.n_faces(); ++f)
        for (unsigned int s = 0; s < 4; ++s)
          if (!mesh.neighbour(f, s) && chain.count(mesh.face(f)[s]) > 0 &&
              chain.count(mesh.face(f)[(s + 1) % 4]) > 0)
            sides.push_back({f, side_of_corner[s]});
      return sides;
    }

    std::vector<Point<3>> in_space(const std::vector<Point<2>> &places)
    {
      std::vector<Point<3>> points;
      for (const Point<2> &u : places)
        points.emplace_back(u[0], u[1], 0.);
      return points;
    }

    std::vector<std::array<unsigned int, 2>>
    flattened(const std::vector<std::vector<spline::ElementSide>> &chains)
    {
      std::vector<std::array<unsigned int, 2>> result;
      for (const auto &sides : chains)
        for (const spline::ElementSide &side : sides)
          result.push_back({{side.element, side.side}});
      return result;
    }
  } // namespace

  Surface leaflet_unstructured(const Design &design)
  {
    const NurbsPatch patch = leaflet_patch(design);
    const LayeredMesh layers(design.unstructured);
    const QuadMesh mesh = layers.mesh();

    const std::vector<unsigned int> attachment = layers.attachment(),
                                    free_edge = layers.free_edge();
    std::vector<Point<2>> places(mesh.n_vertices(), Point<2>(0.5, 0.5));
    const auto place =
        [&](const std::vector<unsigned int> &chain, const std::vector<Point<2>> &path)
    {
      const auto parts = equal_parts(patch, path, chain.size() - 1);
      for (unsigned int k = 0; k < chain.size(); ++k)
        places[chain[k]] = parts[k];
    };
    place(attachment, {{0., 1.}, {0., 0.}, {0.5, 0.}, {1., 0.}, {1., 1.}});
    place(free_edge, {{0., 1.}, {0.5, 1.}, {1., 1.}});
    spline::relax(mesh, places);

    const Surface map = spline::to_surface(mesh, spline::clamped_net(mesh, in_space(places)));
    Surface leaflet = map;
    const auto target = [&](const spline::SurfacePoint &point)
    {
      const auto u = spline::evaluate(map, point)[spline::value];
      return patch.evaluate({std::clamp(u[0], 0., 1.), std::clamp(u[1], 0., 1.)});
    };
    const auto attached = sides_along(mesh, attachment), free = sides_along(mesh, free_edge);
    spline::fit(leaflet, target, flattened({attached, free}));
    leaflet.sets = {{SetKind::node, "attachment", spline::control_row(leaflet, attached, 0)},
                    {SetKind::node, "nextAttachment", spline::control_row(leaflet, attached, 1)},
                    {SetKind::node, "freeEdge", spline::control_row(leaflet, free, 0)}};
    return leaflet;
  }
} // namespace semilunar::valve
