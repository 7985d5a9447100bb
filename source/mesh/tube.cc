// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/mesh/tube.h>
#include <semilunar/mesh/tube_shape.h>

#include <deal.II/base/numbers.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold.h>

#include <array>
#include <cmath>

namespace semilunar::mesh
{
  namespace
  {
    using dealii::Point;
    constexpr double pi = dealii::numbers::PI;

    enum ManifoldId : dealii::types::manifold_id
    {
      core_manifold = 0,
      shell_manifold = 1
    };

    enum BoundaryId : dealii::types::boundary_id
    {
      inlet = 1,
      outlet = 2,
      lumen_wall = 3,
      outer_wall = 4,
      wall_inlet = 5,
      wall_outlet = 6
    };

    class TubeManifold : public dealii::ChartManifold<3, 3, 3>
    {
    public:
      TubeManifold(const TubeShape &shape, const TubeShape::Chart chart)
          : ChartManifold(chart == TubeShape::Chart::shell ? dealii::Tensor<1, 3>({0., 2. * pi, 0.})
                                                           : dealii::Tensor<1, 3>()),
            shape(shape), chart(chart)
      {
      }

      std::unique_ptr<dealii::Manifold<3, 3>> clone() const override
      {
        return std::make_unique<TubeManifold>(shape, chart);
      }

      Point<3> pull_back(const Point<3> &position) const override
      {
        return shape.coordinates(chart, position);
      }

      Point<3> push_forward(const Point<3> &coordinates) const override
      {
        return shape.position(chart, coordinates);
      }

      dealii::DerivativeForm<1, 3, 3>
      push_forward_gradient(const Point<3> &coordinates) const override
      {
        return shape.gradient(chart, coordinates);
      }

    private:
      const TubeShape shape;
      const TubeShape::Chart chart;
    };

    /// The regular grid of a tube: cross-sections of three rhombi and rings around them.
    class TubeGrid
    {
    public:
      TubeGrid(const TubeParameters &tube, const TubeShape &shape)
          : shape(shape), n(tube.n_cells_around / 6), n_layers(tube.layers()),
            n_rings(n_layers + (tube.wall_thickness > 0. ? tube.n_wall_layers : 0)),
            n_wall_layers(n_rings - n_layers), n_along(tube.cells_along()),
            core_radius(tube.core_radius)
      {
        add_vertices();
        add_cells();
      }

      std::vector<Point<3>> vertices;
      std::vector<dealii::CellData<3>> cells;

    private:
      const TubeShape &shape;
      const unsigned int n, n_layers, n_rings, n_wall_layers, n_along;
      const double core_radius;

      unsigned int n_core_points() const { return 3 * n * (n + 1) + 1; }
      unsigned int n_section_points() const { return n_core_points() + 6 * n * n_rings; }

      /// Point (i, j) of rhombus k, counted from the axis along its two sides there.
      unsigned int core_point(const unsigned int k, const unsigned int i,
                              const unsigned int j) const
      {
        if (i == 0 && j == 0)
          return 0;
        if (i == 0)
          return core_point((k + 1) % 3, j, 0);
        return 1 + k * n * (n + 1) + (i - 1) * (n + 1) + j;
      }

      /// Point p of ring l, counted around; ring 0 is the hexagon.
      unsigned int ring_point(const unsigned int l, unsigned int p) const
      {
        p %= 6 * n;
        if (l > 0)
          return n_core_points() + (l - 1) * 6 * n + p;
        const unsigned int k = p / (2 * n), s = p % (2 * n);
        return s <= n ? core_point(k, n, s) : core_point(k, 2 * n - s, n);
      }

      Point<2> in_disc(const unsigned int k, const double i, const double j) const
      {
        const double a = 2. * pi / 3. * k, b = 2. * pi / 3. * (k + 1), h = core_radius / n;
        return {h * (i * std::cos(a) + j * std::cos(b)), h * (i * std::sin(a) + j * std::sin(b))};
      }

      /// Chart and coordinates of the points of a cross-section, zeta left open.
      std::vector<std::pair<TubeShape::Chart, Point<2>>> section() const
      {
        std::vector<std::pair<TubeShape::Chart, Point<2>>> points(n_section_points());
        for (unsigned int k = 0; k < 3; ++k)
          for (unsigned int i = 0; i <= n; ++i)
            for (unsigned int j = 0; j <= n; ++j)
              points[core_point(k, i, j)] = {TubeShape::Chart::core, in_disc(k, i, j)};
        for (unsigned int p = 0; p < 6 * n; ++p)
        {
          const Point<2> corner = points[ring_point(0, p)].second;
          double theta = std::atan2(corner[1], corner[0]);
          theta += theta < 0. ? 2. * pi : 0.;
          for (unsigned int l = 1; l <= n_rings; ++l)
          {
            const double tau =
                l <= n_layers ? double(l) / n_layers : 1. + double(l - n_layers) / n_wall_layers;
            points[ring_point(l, p)] = {TubeShape::Chart::shell, Point<2>(tau, theta)};
          }
        }
        return points;
      }

      void add_vertices()
      {
        const auto points = section();
        for (unsigned int layer = 0; layer <= n_along; ++layer)
          for (const auto &[chart, x] : points)
            vertices.push_back(
                shape.position(chart, Point<3>(x[0], x[1], double(layer) / n_along)));
      }

      /// Extrude a quadrilateral, vertices in lexicographic order.
      void add_column(const std::array<unsigned int, 4> &quad, const Material material,
                      const ManifoldId manifold)
      {
        for (unsigned int layer = 0; layer < n_along; ++layer)
        {
          dealii::CellData<3> cell;
          for (unsigned int v = 0; v < 8; ++v)
            cell.vertices[v] = quad[v % 4] + (layer + v / 4) * n_section_points();
          cell.material_id = material;
          cell.manifold_id = manifold;
          cells.push_back(cell);
        }
      }

      void add_cells()
      {
        for (unsigned int k = 0; k < 3; ++k)
          for (unsigned int i = 0; i < n; ++i)
            for (unsigned int j = 0; j < n; ++j)
              add_column({{core_point(k, i, j), core_point(k, i + 1, j), core_point(k, i, j + 1),
                           core_point(k, i + 1, j + 1)}},
                         lumen, core_manifold);
        for (unsigned int l = 0; l < n_rings; ++l)
          for (unsigned int p = 0; p < 6 * n; ++p)
            add_column({{ring_point(l, p), ring_point(l + 1, p), ring_point(l, p + 1),
                         ring_point(l + 1, p + 1)}},
                       l < n_layers ? lumen : wall, shell_manifold);
      }
    };

    /// All faces and edges of the core belong to it, also those shared with the layers around.
    void set_manifolds(dealii::Triangulation<3> &triangulation, const TubeShape &shape)
    {
      for (const ManifoldId id : {shell_manifold, core_manifold})
        for (const auto &cell : triangulation.cell_iterators_on_level(0))
          if (cell->manifold_id() == id)
            cell->set_all_manifold_ids(id);
      triangulation.set_manifold(core_manifold, TubeManifold(shape, TubeShape::Chart::core));
      triangulation.set_manifold(shell_manifold, TubeManifold(shape, TubeShape::Chart::shell));
    }

    void set_boundaries(dealii::Triangulation<3> &triangulation, const TubeParameters &tube)
    {
      const double tolerance = 1e-10 * (tube.end - tube.begin);
      for (const auto &cell : triangulation.cell_iterators_on_level(0))
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary())
          {
            const bool in_wall = cell->material_id() == wall;
            double low = face->vertex(0)[2], high = low;
            for (const unsigned int v : face->vertex_indices())
            {
              low = std::min(low, face->vertex(v)[2]);
              high = std::max(high, face->vertex(v)[2]);
            }
            if (high < tube.begin + tolerance)
              face->set_boundary_id(in_wall ? wall_inlet : inlet);
            else if (low > tube.end - tolerance)
              face->set_boundary_id(in_wall ? wall_outlet : outlet);
            else
              face->set_boundary_id(in_wall ? outer_wall : lumen_wall);
          }
    }
  } // namespace

  void make_tube(Mesh<3> &mesh, const TubeParameters &tube, const std::string &section)
  {
    tube.check(section);
    const TubeShape shape(tube);
    TubeGrid grid(tube, shape);
    dealii::GridTools::consistently_order_cells(grid.cells);
    mesh.triangulation.create_triangulation(grid.vertices, grid.cells, dealii::SubCellData());
    set_manifolds(mesh.triangulation, shape);
    set_boundaries(mesh.triangulation, tube);
    mesh.boundary_ids = {{"inlet", inlet}, {"outlet", outlet}};
    if (tube.wall_thickness > 0.)
      mesh.boundary_ids.insert(
          {{"outer_wall", outer_wall}, {"wall_inlet", wall_inlet}, {"wall_outlet", wall_outlet}});
    else
      mesh.boundary_ids["wall"] = lumen_wall;
  }
} // namespace semilunar::mesh
