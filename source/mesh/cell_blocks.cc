// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/mesh/cell_blocks.h>

#include <deal.II/grid/grid_tools.h>

#include <cmath>

namespace semilunar::mesh
{
  void CellBlocks::add_rectangles(const Positions &x, const Positions &y, const Material material)
  {
    add(
        x.size() - 1, y.size() - 1,
        [&](const unsigned int i, const unsigned int j) { return dealii::Point<2>(x[i], y[j]); },
        material);
  }

  void CellBlocks::create(dealii::Triangulation<2> &triangulation)
  {
    dealii::SubCellData none;
    std::vector<unsigned int> considered;
    dealii::GridTools::delete_duplicated_vertices(vertices, cells, none, considered, 1e-10);
    dealii::GridTools::consistently_order_cells(cells);
    triangulation.create_triangulation(vertices, cells, none);
  }

  CellBlocks::Positions CellBlocks::between(const double a, const double b, const unsigned int n)
  {
    Positions result;
    for (unsigned int i = 0; i <= n; ++i)
      result.push_back(a + (b - a) * i / n);
    return result;
  }

  CellBlocks::Positions CellBlocks::growing(const double a, const double b, const unsigned int n,
                                            const double factor)
  {
    Positions result;
    for (unsigned int i = 0; i <= n; ++i)
      result.push_back(a + (b - a) * (std::pow(factor, i) - 1.) / (std::pow(factor, n) - 1.));
    return result;
  }

  CellBlocks::Positions CellBlocks::joined(Positions a, const Positions &b)
  {
    a.insert(a.end(), b.begin() + 1, b.end());
    return a;
  }
} // namespace semilunar::mesh
