// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/mesh/cell_blocks.h>
#include <semilunar/mesh/flag_channel.h>

#include <deal.II/grid/manifold_lib.h>

#include <cmath>

namespace semilunar::mesh
{
  namespace
  {
    using dealii::Point;
    using Positions = CellBlocks::Positions;

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

    /// Coordinates of the rectangles: short at the flag and behind its tip.
    struct Grid
    {
      const double top = centre[1] + half_thickness, bottom = centre[1] - half_thickness;
      const Positions flag = {bottom, top};
      const Positions below = CellBlocks::between(0., centre[1] - box, 2);
      const Positions above = CellBlocks::between(centre[1] + box, height, 2);
      const Positions under_flag = CellBlocks::growing(centre[1] - box, bottom, 3, 1. / 1.8);
      const Positions over_flag = CellBlocks::growing(top, centre[1] + box, 3, 1.8);
      const Positions upstream = CellBlocks::between(0., centre[0] - box, 2);
      const Positions around = CellBlocks::between(centre[0] - box, centre[0] + box, 4);
      const Positions along = CellBlocks::growing(centre[0] + box, flag_end, 7, 0.85);
      const Positions downstream = CellBlocks::growing(flag_end, length, 16, 1.15);

      /// All heights of the square.
      Positions beside() const
      {
        return CellBlocks::joined(CellBlocks::joined(under_flag, flag), over_flag);
      }
    };

    Point<2> on_cylinder(const double angle)
    {
      return centre + radius * Point<2>(std::cos(angle), std::sin(angle));
    }

    /// Cells from the cylinder to points on the square around it, between two angles (with
    /// increasing angle).
    void add_sector(CellBlocks &blocks, const std::vector<Point<2>> &outer, const double first,
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

    /// From the cylinder (0) to the square (1).
    const Positions radial = {0., 0.22, 0.53, 1.};
    const double at_flag = std::asin(half_thickness / radius); // angle of its upper edge

    void add_flag_at_cylinder(CellBlocks &blocks)
    {
      const double right = centre[0] + box;
      add_sector(blocks,
                 {Point<2>(right, centre[1] - half_thickness),
                  Point<2>(right, centre[1] + half_thickness)},
                 -at_flag, at_flag, radial, wall);
    }

    void add_cells_around_cylinder(CellBlocks &blocks, const Positions &x, const Positions &y)
    {
      constexpr double degree = dealii::numbers::PI / 180.;
      const double left = centre[0] - box, right = centre[0] + box, low = centre[1] - box,
                   high = centre[1] + box;
      std::vector<Point<2>> upper, lower, side, above, below;
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
      }
      add_sector(blocks, upper, at_flag, 45. * degree, radial, lumen);
      add_sector(blocks, lower, -45. * degree, -at_flag, radial, lumen);
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
    const Grid grid;
    CellBlocks blocks;
    add_cells_around_cylinder(blocks, grid.around, grid.beside());
    add_flag_at_cylinder(blocks);
    const Positions all_x = CellBlocks::joined(
        CellBlocks::joined(CellBlocks::joined(grid.upstream, grid.around), grid.along),
        grid.downstream);
    for (const Positions &y : {grid.below, grid.above})
      blocks.add_rectangles(all_x, y, lumen);
    blocks.add_rectangles(grid.upstream, grid.beside(), lumen);
    blocks.add_rectangles(grid.downstream, grid.beside(), lumen);
    blocks.add_rectangles(grid.along, grid.under_flag, lumen);
    blocks.add_rectangles(grid.along, grid.over_flag, lumen);
    blocks.add_rectangles(grid.along, grid.flag, wall);
    blocks.create(mesh.triangulation);
    set_boundaries(mesh.triangulation);
    mesh.boundary_ids = {{"inlet", inlet},
                         {"outlet", outlet},
                         {"cylinder", cylinder},
                         {"wall", walls},
                         {"root", root}};
  }

  void make_flag(Mesh<2> &mesh)
  {
    const Grid grid;
    CellBlocks blocks;
    add_flag_at_cylinder(blocks);
    blocks.add_rectangles(grid.along, grid.flag, wall);
    blocks.create(mesh.triangulation);
    set_boundaries(mesh.triangulation);
    mesh.boundary_ids = {{"sides", walls}, {"root", root}};
  }
} // namespace semilunar::mesh
