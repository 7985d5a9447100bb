// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_mesh_parameters_h
#define semilunar_mesh_parameters_h

#include <semilunar/mesh/mesh.h>
#include <semilunar/mesh/refinement.h>
#include <semilunar/mesh/tube_parameters.h>

#include <memory>
#include <vector>

namespace semilunar::mesh
{
  enum class Shape
  {
    box,
    channel,
    cylinder_in_channel,
    flag_in_channel,
    pipe,
    artery,
    file,
    flag,
    blocks
  };

  /// A box [lower, upper] of equal cells.
  struct BoxParameters
  {
    std::vector<double> lower = {0., 0., 0.}, upper = {1., 1., 1.}; ///< corners [cm]
    std::vector<unsigned int> n_cells = {4, 4, 4};                  ///< in each direction
  };

  /// Rectangular blocks of equal cells in the plane, or those of a ring around the origin.
  struct BlocksParameters
  {
    std::vector<double> x = {0., 1.}, y = {0., 1.}; ///< of their corners [cm]; radii, angles
    std::vector<unsigned int> n_cells_x = {4}, n_cells_y = {4};
    std::string materials = "lumen"; ///< words lumen, wall, none; rows divided by semicolons
    bool polar = false;              ///< x: radii, y: angles [degrees]

    /// @throws InputError for what does not fit together
    void check() const;
  };

  /// The channel with a cylinder of the DFG benchmarks.
  struct CylinderChannelParameters
  {
    double shell_width = 0.03; ///< of the shells of cells around the cylinder [length]
    unsigned int n_shells = 2;
    double skewness = 2.;          ///< how much they cluster towards the cylinder [-]
    unsigned int n_cells_deep = 4; ///< along the cylinder, in space
  };

  /// A mesh in a file that deal.II's GridIn reads.
  struct FileParameters
  {
    std::string name;
    double scale = 1.;      ///< all coordinates are multiplied by it
    BoundaryIds boundaries; ///< names of the boundary ids in the file
  };

  /// What mesh a scene wants.
  struct MeshParameters
  {
    Shape shape = Shape::box;
    BoxParameters box;
    BlocksParameters blocks;
    CylinderChannelParameters cylinder;
    TubeParameters pipe = TubeParameters::pipe(0.5, 2.), artery = TubeParameters::artery();
    FileParameters file;
    RefinementParameters refinement;

    /// Declare the section Mesh.
    void add_parameters(dealii::ParameterHandler &prm);
    /// @throws InputError for what no single entry can tell
    void check(unsigned int dim) const;
  };

  /// Make the mesh, refined as asked for. Collective.
  /// @throws InputError for parameters that make no mesh
  template <int dim>
  std::unique_ptr<Mesh<dim>> make_mesh(const MeshParameters &parameters, MPI_Comm communicator);
} // namespace semilunar::mesh

#endif
