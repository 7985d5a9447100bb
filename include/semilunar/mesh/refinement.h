// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_mesh_refinement_h
#define semilunar_mesh_refinement_h

#include <semilunar/mesh/mesh.h>

#include <deal.II/lac/vector.h>

#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace semilunar::mesh
{
  /// Where a mesh is finer from the start.
  struct RefinementParameters
  {
    unsigned int n_global = 0;              ///< refinements of all cells
    unsigned int n_boxes = 0;               ///< further refinements of the cells in the boxes
    std::vector<std::vector<double>> boxes; ///< corners: x, y, z, x, y, z (in the plane x, y, x, y)
    unsigned int n_boundaries = 0;          ///< further refinements of the cells at the boundaries
    std::vector<std::string> boundaries;

    void add_parameters(dealii::ParameterHandler &prm);
    void check(unsigned int dim) const;
  };

  /// Refine a coarse mesh. Collective.
  /// @throws InputError for a boundary that the mesh does not have
  template <int dim>
  void refine(Mesh<dim> &mesh, const RefinementParameters &parameters);

  /// How a mesh follows the flow.
  struct AdaptivityParameters
  {
    unsigned int interval = 0; ///< time steps between changes of the mesh; 0: none
    double refined_share = 0.1, coarsened_share = 0.1; ///< of the cells
    unsigned int max_cells = 50000;
    unsigned int max_level = 2;   ///< refinements of a coarse cell
    double vorticity_weight = 1.; ///< alpha in (H7)

    void add_parameters(dealii::ParameterHandler &prm);
  };

  /// Flag cells for refinement and coarsening by their indicators, within the bounds on number and
  /// level. Collective; the caller executes it and transfers its fields.
  /// @param indicators by active cell index; of locally owned cells
  /// @return whether any cell on any rank is flagged
  template <int dim>
  bool flag_cells(Mesh<dim> &mesh, const dealii::Vector<float> &indicators,
                  const AdaptivityParameters &parameters);
} // namespace semilunar::mesh

#endif
