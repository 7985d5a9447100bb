// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_valve_design_h
#define semilunar_valve_design_h

#include <semilunar/valve/refinement_zones.h>

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace semilunar::valve
{
  /// How the elements of a leaflet are arranged.
  enum class LeafletLayout
  {
    uniform,     ///< one grid of elements of nearly equal width
    t_spline,    ///< a coarse grid, locally refined (section T-spline)
    unstructured ///< with extraordinary points (section Unstructured)
  };

  /// The unstructured layout: layers along the attachment edge around a core.
  struct UnstructuredLayout
  {
    unsigned int n_core_along = 14;  ///< from side to side
    unsigned int n_core_across = 12; ///< up to the free edge
    unsigned int n_layers = 8;
  };

  /// The parametric design of a stented valve with equal leaflets (theory: doc/theory/valve.md).
  /// z is the flow axis, z = 0 the lower plane of the suture ring; leaflet 1 is symmetric about the
  /// half plane y = 0, x > 0. Lengths in cm. The defaults are a 23 mm valve.
  struct Design
  {
    unsigned int n_leaflets = 3;
    double radius = 1.1175;          ///< R, of the stent's wall and of the attachment edge
    double commissure_height = 0.94; ///< z at the top of the posts
    double post_foot_height = 0.33;  ///< z where the post turns into the scallop
    double nadir_height = 0.096;     ///< z at the lowest point of the scallop
    double post_width = 0.031;       ///< distance of neighboring leaflets' commissure lines
    double free_edge_height = 0.852; ///< z of the free edge's middle
    double free_edge_gap = 0.033;    ///< distance of the free edge's middle from the axis
    double belly = 1.;               ///< 0: straight ruling, 1: full belly
    double belly_height = -0.1;      ///< z of the corner of the middle profile (V6)
    double belly_width = 0.75;       ///< share of the leaflet's width that the belly takes
    double post_lean = 0.;           ///< of the commissure lines towards the axis [degree]
    double expansion = 1.;           ///< circumference of the stent relative to the design
    double ellipticity = 1.;         ///< of the stent: shorter by longer axis
    double ellipse_direction = 0.;   ///< of the longer axis, from x towards y [degree]
    LeafletLayout layout = LeafletLayout::uniform;
    unsigned int n_elements_along = 22;  ///< from commissure to commissure, uniform layout
    unsigned int n_elements_across = 22; ///< from attachment to free edge, uniform layout
    RefinementZones zones;               ///< T-spline layout
    UnstructuredLayout unstructured;

    struct
    {
      double ring_outer_radius = 1.40;
      unsigned int n_elements_along = 22; ///< of wall and ring below a leaflet
      unsigned int n_wall_elements = 5;   ///< from the ring up to the scallop or post foot
      unsigned int n_ring_elements = 6;   ///< across the ring
      unsigned int n_elements_across_post = 2;
      unsigned int n_elements_up_post = 15; ///< from the post foot to the commissure
      unsigned int degree_across = 3;       ///< all parts are straight across: 1 describes them
    } stent;

    /// Declare and bind the entries in the current section of the parameter file.
    void add_parameters(dealii::ParameterHandler &prm);

    /// @param section where the entries stand, for the message
    /// @throws InputError naming the entry, its value and what would be possible, for a design that
    /// no valve can have
    void check(const std::string &section = "Valve") const;

    /// Half of the angle at the axis between the two commissure lines of a leaflet [rad], (V1).
    double half_angle() const;

    /// Distance of the commissures from the axis [cm], (V8), and half of the angle between those of
    /// a leaflet [rad].
    double commissure_radius() const;
    double half_commissure_angle() const;

    /// Distance from the axis at which the two planes that keep the leaflet half a post width away
    /// from its neighbors meet [cm], (V3). The free edge's middle must lie further out.
    double smallest_gap() const;
  };
} // namespace semilunar::valve

#endif
