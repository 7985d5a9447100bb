// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_scene_surface_source_h
#define semilunar_scene_surface_source_h

#include <semilunar/spline/nurbs_patch.h>
#include <semilunar/valve/design.h>

#include <deal.II/base/parameter_handler.h>

namespace semilunar::scene
{
  /// Where the surface of a scene comes from: a simple shape, a valve design, a NURBS patch given
  /// by its control net, or a file (.iga, STEP, IGES).
  class SurfaceSource
  {
  public:
    /// Declare the section Surface.
    void add_parameters(dealii::ParameterHandler &prm);

    /// Build and check the surface.
    /// @throws InputError whose place is the entry to change, or the line of the .iga file
    spline::Surface build() const;

    /// The same as few patches, for CAD programs; a patch for each element if there are none.
    std::vector<spline::NurbsPatch> patches(const spline::Surface &surface) const;

  private:
    using Range = std::array<double, 2>;

    spline::NurbsPatch simple_shape() const;
    spline::NurbsPatch nurbs_patch() const;
    spline::Surface patch() const;
    spline::Surface parts_of_valve() const;
    void elevate_and_refine(spline::NurbsPatch &patch) const;

    std::string source = "quadrilateral";
    unsigned int degree = 3;
    std::array<unsigned int, 2> n_elements{{8, 8}};
    double scale = 1.;
    std::string file, copies;
    double join_tolerance = 1e-6;

    std::vector<std::vector<double>> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    double cylinder_radius = 1.;
    Range cylinder_angles{{0., 90.}}; ///< degrees
    Range cylinder_heights{{0., 1.}};
    double sphere_radius = 1.;
    Range longitudes{{0., 90.}}; ///< degrees
    Range latitudes{{0., 72.}};  ///< degrees
    Range annulus_radii{{1., 2.}};
    Range annulus_angles{{0., 90.}}; ///< degrees

    valve::Design design;

    std::array<unsigned int, 2> nurbs_degrees{{1, 1}};
    std::array<std::vector<double>, 2> nurbs_knots{{{0, 0, 1, 1}, {0, 0, 1, 1}}};
    std::vector<std::vector<double>> control_net{
        {0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}, {1, 1, 0, 1}};
  };
} // namespace semilunar::scene

#endif
