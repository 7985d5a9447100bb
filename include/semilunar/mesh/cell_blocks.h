// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_mesh_cell_blocks_h
#define semilunar_mesh_cell_blocks_h

#include <semilunar/mesh/mesh.h>

#include <vector>

namespace semilunar::mesh
{
  /// A plane mesh of blocks of cells whose common points are found by their positions.
  class CellBlocks
  {
  public:
    using Positions = std::vector<double>;

    /// A block of n x m cells.
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

    /// Rectangles between the coordinates.
    void add_rectangles(const Positions &x, const Positions &y, Material material);

    void create(dealii::Triangulation<2> &triangulation);

    /// n equal cells.
    static Positions between(double a, double b, unsigned int n);
    /// n cells, each longer than the one before by a factor (not 1).
    static Positions growing(double a, double b, unsigned int n, double factor);
    /// Two parts with a common point.
    static Positions joined(Positions a, const Positions &b);

  private:
    std::vector<dealii::Point<2>> vertices;
    std::vector<dealii::CellData<2>> cells;
  };
} // namespace semilunar::mesh

#endif
