// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/mesh/flag_channel.h>

#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include <cmath>

namespace semilunar::mesh
{
  namespace
  {
    using dealii::Point;
    using Positions = std::vector<double>;

    // Turek and Hron 2006; lengths as printed there.
    constexpr double height = 0.41, length = 2.5, radius = 0.05, flag_end = 0.6,
                     half_thickness = 0.01, box = 0.1; // half the side of the square of cells
                                                       // around the cylinder
    const Point<2> centre(0.2, 0.2);

    enum BoundaryId : dealii::types::boundary_id
    {
      inlet = 0,
      outlet = 1,
      cylinder = 2,
      walls = 3,
      root = 4
    };

    /// Blocks of cells whose common points are found by their positions.
    class Blocks
    {
    public:
      /// @param position of the point (i, j), 0 <= i <= n, 0 <= j <= m
      template <class Position>
      void add(const unsigned int n, const unsigned int m, const Position &position,
               const Material material)
      {
        const unsigned int first = vertices.size();
        for (unsigned int j = 0; j <= m; ++j)
          for (unsigned int i = 0; i <= n; ++i)
            vertices.push_back(position(i, j));
        for (unsigned int j = 0; j < m; ++j)
          for (unsigned int i = 0; i < n; ++i)
          {
            dealii::CellData<2> cell;
            for (unsigned int v = 0; v < 4; ++v)
              cell.vertices[v] = first + (j + v / 2) * (n + 1) + i + v % 2;
            cell.material_id = material;
            cells.push_back(cell);
          }
      }

      void add_rectangles(const Positions &x, const Positions &y, const Material material)
      {
        add(
            x.size() - 1, y.size() - 1,
            [&](const unsigned int i, const unsigned int j) { return Point<2>(x[i], y[j]); },
            material);
      }

      void create(dealii::Triangulation<2> &triangulation)
      {
        dealii::SubCellData none;
        std::vector<unsigned int> considered;
        dealii::GridTools::delete_duplicated_vertices(vertices, cells, none, considered, 1e-10);
        dealii::GridTools::consistently_order_cells(cells);
        triangulation.create_triangulation(vertices, cells, none);
      }

    private:
      std::vector<Point<2>> vertices;
      std::vector<dealii::CellData<2>> cells;
    };

    Positions between(const double a, const double b, const unsigned int n)
    {
      Positions result;
      for (unsigned int i = 0; i <= n; ++i)
        result.push_back(a + (b - a) * i / n);
      return result;
    }

    Positions joined(Positions a, const Positions &b)
    {
      a.insert(a.end(), b.begin() + 1, b.end());
      return a;
    }

    /// Cells that grow by a factor.
    Positions growing(const double a, const double b, const unsigned int n, const double factor)
    {
      Positions result;
      for (unsigned int i = 0; i <= n; ++i)
        result.push_back(a + (b - a) * (std::pow(factor, i) - 1.) / (std::pow(factor, n) - 1.));
      return result;
    }

    Point<2> on_cylinder(const double angle)
    {
      return centre + radius * Point<2>(std::cos(angle), std::sin(angle));
    }

    /// Cells from the cylinder to points on the square around it, between two angles (with
    /// increasing angle).
    void add_sector(Blocks &blocks, const std::vector<Point<2>> &outer, const double first,
                    const double last, const Positions &radial, const Material material)
    {
      blocks.add(
          radial.size() - 1, outer.size() - 1,
          [&](const unsigned int i, const unsigned int j)
          {
            const double angle = first + (last - first) * j / (outer.size() - 1);
            return Point<2>((1. - radial[i]) * on_cylinder(angle) + radial[i] * outer[j]);
          },
          material);
    }

    void add_cells_around_cylinder(Blocks &blocks, const Positions &x, const Positions &y)
    {
      constexpr double degree = dealii::numbers::PI / 180.;
      const double at_flag = std::asin(half_thickness / radius);
      const Positions radial = {0., 0.35, 1.};
      const double left = centre[0] - box, right = centre[0] + box, low = centre[1] - box,
                   high = centre[1] + box;
      std::vector<Point<2>> upper, lower, side, above, below, flag;
      for (const double at : x)
      {
        above.insert(above.begin(), Point<2>(at, high));
        below.emplace_back(at, low);
      }
      for (const double at : y)
      {
        side.insert(side.begin(), Point<2>(left, at));
        if (at > centre[1] + half_thickness - 1e-10)
          upper.emplace_back(right, at);
        if (at < centre[1] - half_thickness + 1e-10)
          lower.emplace_back(right, at);
        if (std::abs(at - centre[1]) < half_thickness + 1e-10)
          flag.emplace_back(right, at);
      }
      add_sector(blocks, upper, at_flag, 45. * degree, radial, lumen);
      add_sector(blocks, lower, -45. * degree, -at_flag, radial, lumen);
      add_sector(blocks, flag, -at_flag, at_flag, radial, wall);
      add_sector(blocks, above, 45. * degree, 135. * degree, radial, lumen);
      add_sector(blocks, below, 225. * degree, 315. * degree, radial, lumen);
      add_sector(blocks, side, 135. * degree, 225. * degree, radial, lumen);
    }

    void set_boundaries(dealii::Triangulation<2> &triangulation)
    {
      for (const auto &cell : triangulation.cell_iterators_on_level(0))
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary())
          {
            const Point<2> middle = face->center();
            if (middle.distance(centre) < radius + 1e-10)
            {
              face->set_boundary_id(cell->material_id() == wall ? root : cylinder);
              face->set_manifold_id(0);
            }
            else if (middle[0] < 1e-10)
              face->set_boundary_id(inlet);
            else
              face->set_boundary_id(middle[0] > length - 1e-10 ? outlet : walls);
          }
      triangulation.set_manifold(0, dealii::PolarManifold<2>(centre));
    }
  } // namespace

  void make_flag_channel(Mesh<2> &mesh)
  {
    const double top = centre[1] + half_thickness, bottom = centre[1] - half_thickness;
    const Positions below = between(0., centre[1] - box, 2),
                    above = between(centre[1] + box, height, 2),
                    beside = joined(joined(between(centre[1] - box, bottom, 2), {bottom, top}),
                                    between(top, centre[1] + box, 2)),
                    upstream = between(0., centre[0] - box, 2),
                    around = between(centre[0] - box, centre[0] + box, 4),
                    along = between(centre[0] + box, flag_end, 6),
                    downstream = growing(flag_end, length, 12, 1.15);
    Blocks blocks;
    add_cells_around_cylinder(blocks, around, beside);
    const Positions all_x = joined(joined(joined(upstream, around), along), downstream);
    for (const Positions &y : {below, above})
      blocks.add_rectangles(all_x, y, lumen);
    blocks.add_rectangles(upstream, beside, lumen);
    blocks.add_rectangles(downstream, beside, lumen);
    blocks.add_rectangles(along, between(centre[1] - box, bottom, 2), lumen);
    blocks.add_rectangles(along, between(top, centre[1] + box, 2), lumen);
    blocks.add_rectangles(along, {bottom, top}, wall);
    blocks.create(mesh.triangulation);
    set_boundaries(mesh.triangulation);
    mesh.boundary_ids = {{"inlet", inlet},
                         {"outlet", outlet},
                         {"cylinder", cylinder},
                         {"wall", walls},
                         {"root", root}};
  }
} // namespace semilunar::mesh
