// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_mesh_quality_h
#define semilunar_mesh_quality_h

#include <semilunar/mesh/mesh.h>

#include <deal.II/fe/mapping.h>

namespace semilunar::mesh
{
  /// How good a mesh is (doc/theory/mesh.md).
  struct Quality
  {
    double min_scaled_jacobian; ///< over all cells: 1 for boxes, <= 0 for cells that are degenerate
    double mean_scaled_jacobian;              ///< mean of the cells' smallest values
    double min_size, max_size;                ///< diameters of cells [cm]
    double volume;                            ///< of all cells of the material [cm^dim]
    dealii::types::global_cell_index n_cells; ///< of the material
  };

  /// Measure the cells of a material as the mapping bends them. Collective.
  template <int dim>
  Quality measure(const dealii::Triangulation<dim> &triangulation,
                  const dealii::Mapping<dim> &mapping, Material material = lumen);

  /// "25,000 lumen cells, ...": one line for the log.
  std::string describe(const Quality &quality);
} // namespace semilunar::mesh

#endif
