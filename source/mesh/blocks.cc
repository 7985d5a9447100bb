// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/mesh/blocks.h>
#include <semilunar/mesh/cell_blocks.h>
#include <semilunar/mesh/parameters.h>

#include <deal.II/base/utilities.h>
#include <deal.II/grid/manifold_lib.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace semilunar::mesh
{
  namespace
  {
    using dealii::Point;
    constexpr double degree = dealii::numbers::PI / 180.;
    const std::array<std::string, 4> directions = {"left", "right", "bottom", "top"};

    /// Words of each row, the lowest row first.
    std::vector<std::vector<std::string>> rows_of(const std::string &materials)
    {
      std::vector<std::vector<std::string>> rows;
      for (const std::string &row : dealii::Utilities::split_string_list(materials, ';'))
        rows.push_back(dealii::Utilities::split_string_list(row, ' '));
      return rows;
    }

    void check_axis(const std::string &axis, const std::vector<double> &coordinates,
                    const std::vector<unsigned int> &n_cells)
    {
      const std::string section = "Mesh/Blocks/";
      for (unsigned int i = 1; i < coordinates.size(); ++i)
        if (!(coordinates[i - 1] < coordinates[i]))
          throw InputError(section + axis, std::to_string(coordinates[i]),
                           "the coordinates do not increase", "give them in order");
      if (n_cells.size() + 1 != coordinates.size())
        throw InputError(section + "Cells " + axis, "",
                         "there are " + std::to_string(coordinates.size()) + " coordinates and " +
                             std::to_string(n_cells.size()) + " numbers of cells",
                         "give a number of cells between each two coordinates");
    }

    /// Which side of its cell a face is on: 2 d + (0 or 1), d the direction in which they differ.
    unsigned int side_of(Point<2> face, Point<2> cell, const bool polar)
    {
      if (polar)
      {
        const double along = (cell[0] * face[1] - cell[1] * face[0]) / cell.norm();
        face = Point<2>(face.norm(), along);
        cell = Point<2>(cell.norm(), 0.);
      }
      const auto difference = face - cell;
      const unsigned int d = std::abs(difference[0]) > std::abs(difference[1]) ? 0 : 1;
      return 2 * d + (difference[d] > 0. ? 1 : 0);
    }

    void name_boundaries(Mesh<2> &mesh, const bool polar)
    {
      for (const auto &cell : mesh.triangulation.cell_iterators_on_level(0))
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary())
          {
            const bool of_wall = cell->material_id() == wall;
            const unsigned int side = side_of(face->center(), cell->center(), polar);
            face->set_boundary_id(side + (of_wall ? 4 : 0));
            mesh.boundary_ids[(of_wall ? "wall_" : "") + directions[side]] = face->boundary_id();
          }
    }
  } // namespace

  void BlocksParameters::check() const
  {
    check_axis("x", x, n_cells_x);
    check_axis("y", y, n_cells_y);
    if (polar && (!(x.front() > 0.) || y.back() - y.front() > 360.))
      throw InputError("Mesh/Blocks/Polar", "true",
                       "radii must be greater than 0, angles cover 360 degrees at most",
                       "change x (radii) or y (angles)");
    const auto rows = rows_of(materials);
    bool fits = rows.size() == n_cells_y.size();
    unsigned int n_filled = 0;
    for (const auto &row : rows)
    {
      fits = fits && row.size() == n_cells_x.size();
      for (const std::string &word : row)
        if (word != "lumen" && word != "wall" && word != "none")
          throw InputError("Mesh/Blocks/Materials", word, "there is no such material",
                           "choose lumen, wall or none");
        else
          n_filled += word != "none";
    }
    if (!fits || n_filled == 0)
      throw InputError("Mesh/Blocks/Materials", materials, "not a word for each block",
                       "give rows of " + std::to_string(n_cells_x.size()) +
                           " words, divided by semicolons, the lowest first");
  }

  void make_blocks(Mesh<2> &mesh, const BlocksParameters &parameters)
  {
    const auto rows = rows_of(parameters.materials);
    CellBlocks blocks;
    for (unsigned int j = 0; j < rows.size(); ++j)
      for (unsigned int i = 0; i < rows[j].size(); ++i)
        if (rows[j][i] != "none")
        {
          const unsigned int n = parameters.n_cells_x[i], m = parameters.n_cells_y[j];
          const auto x = CellBlocks::between(parameters.x[i], parameters.x[i + 1], n),
                     y = CellBlocks::between(parameters.y[j], parameters.y[j + 1], m);
          blocks.add(
              n, m,
              [&](const unsigned int k, const unsigned int l)
              {
                return parameters.polar ? Point<2>(x[k] * std::cos(degree * y[l]),
                                                   x[k] * std::sin(degree * y[l]))
                                        : Point<2>(x[k], y[l]);
              },
              rows[j][i] == "wall" ? wall : lumen);
        }
    blocks.create(mesh.triangulation);
    name_boundaries(mesh, parameters.polar);
    if (parameters.polar)
    {
      mesh.triangulation.set_all_manifold_ids(0);
      mesh.triangulation.set_manifold(0, dealii::PolarManifold<2>());
    }
  }
} // namespace semilunar::mesh
