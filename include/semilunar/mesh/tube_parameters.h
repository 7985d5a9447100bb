// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_mesh_tube_parameters_h
#define semilunar_mesh_tube_parameters_h

#include <limits>
#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace semilunar::mesh
{
  /// A round tube along z, with or without a three-lobed sinus and a wall (doc/theory/mesh.md).
  /// Lengths in cm.
  struct TubeParameters
  {
    double radius = std::numeric_limits<double>::signaling_NaN();
    double begin = std::numeric_limits<double>::signaling_NaN(); ///< z of the inlet
    double end = std::numeric_limits<double>::signaling_NaN();   ///< z of the outlet

    struct
    {
      bool exists = false;
      double begin = 0., peak = 1., end = 2.6; ///< z of its ends and of its widest cross-section
      double lobe_radius = 1.95;               ///< largest radius, behind the leaflets
      double commissure_radius = 1.45;         ///< half way between the lobes
    } sinus;

    unsigned int n_cells_around = 24; ///< a multiple of 6
    unsigned int n_layers = 0;        ///< between core and wall; 0: in proportion
    unsigned int n_cells_along = 0;   ///< 0: in proportion
    double core_radius = 0.6;         ///< of the hexagon, relative to the radius
    double wall_clustering = 3.;      ///< thickness of the innermost over the outermost layer
    double zone_begin = 0., zone_end = 0., zone_transition = 1.; ///< of shorter cells, along z
    double zone_ratio = 1.;                                      ///< how much shorter they are

    double wall_thickness = 0.; ///< 0: there is no wall
    unsigned int n_wall_layers = 2;

    /// The artery around the valve: inner diameter 2.6, 5 upstream and 11 downstream of it.
    static TubeParameters artery();
    /// A straight pipe of this length around z = 0.
    static TubeParameters pipe(double radius, double length);

    /// Declare and bind the entries in the current section.
    void add_parameters(dealii::ParameterHandler &prm, bool is_artery);
    /// @param section where the entries stand, for the message
    /// @throws InputError for a tube that cannot be
    void check(const std::string &section) const;

    unsigned int layers() const;
    unsigned int cells_along() const;
    unsigned int n_lumen_cells() const;
    /// Volume of the lumen [cm^3], (H3).
    double lumen_volume() const;
  };
} // namespace semilunar::mesh

#endif
