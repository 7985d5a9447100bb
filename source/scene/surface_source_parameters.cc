// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/parameters.h>
#include <semilunar/scene/surface_source.h>

namespace semilunar::scene
{
  namespace
  {
    using dealii::ParameterHandler;
    namespace Patterns = dealii::Patterns;

    /// Exactly two numbers.
    Patterns::List pair_of(const Patterns::PatternBase &pattern)
    {
      return Patterns::List(pattern, 2, 2);
    }

    const char *const angles_text = "First and last angle from the x axis [degree].";

    void add_quadrilateral(ParameterHandler &prm, std::vector<std::vector<double>> &corners)
    {
      prm.enter_subsection("Quadrilateral");
      prm.add_parameter("Corners", corners,
                        "x, y, z of the corners (0,0); (1,0); (0,1); (1,1) of the parameter "
                        "space [length].",
                        Patterns::List(Patterns::List(Patterns::Double(), 3, 3), 4, 4, ";"));
      prm.leave_subsection();
    }
  } // namespace

  void SurfaceSource::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Surface");
    prm.add_parameter("Source", source,
                      "Where the surface comes from: one of the simple shapes, a NURBS patch or "
                      "an .iga file, each described by the section of that name, the B-spline "
                      "surfaces of a STEP or IGES file (cad, converted to cm), or the leaflets, "
                      "the stent or both (valve) of the design in section Valve.",
                      Patterns::Selection("quadrilateral|cylinder|sphere|annulus|leaflets|stent|"
                                          "valve|nurbs|iga|cad"));
    prm.add_parameter("Degree", degree,
                      "Polynomial degree in both directions, raised to this one without a change "
                      "of shape (not for iga and the parts of a valve, which are cubic).",
                      Patterns::Integer(1, 8));
    prm.add_parameter("Elements", n_elements,
                      "Number of elements in the first and the second direction (not for iga and "
                      "the parts of a valve, which have entries of their own).",
                      pair_of(Patterns::Integer(1, 10000)));
    prm.add_parameter("Scale factor", scale,
                      "All coordinates are multiplied by this, as with 0.1 for a file in mm in a "
                      "scene in cm [-].",
                      positive_number());
    prm.add_parameter(
        "File", file,
        "The .iga, STEP or IGES file. Its name is relative to the scene file, or to the current "
        "directory if given by --set.",
        Patterns::FileName());
    prm.add_parameter("Join tolerance", join_tolerance,
                      "Control points of patches of a CAD file that are not farther apart become "
                      "one [cm]: patches are joined where they share edges.",
                      Patterns::Double(0.));
    prm.add_parameter("Copies", copies,
                      "Further pieces of the same shape, separated by semicolons: '(x, y, z)' is "
                      "one that is shifted by this, 'turn z 90 (x, y, z)' one that is turned about "
                      "an axis through the origin [degree] before.");
    add_quadrilateral(prm, corners);

    prm.enter_subsection("Cylinder");
    prm.add_parameter("Radius", cylinder_radius, "Radius about the z axis [length].",
                      positive_number());
    prm.add_parameter("Angles", cylinder_angles, angles_text, pair_of(Patterns::Double(-360, 360)));
    prm.add_parameter("Heights", cylinder_heights, "First and last z [length].",
                      pair_of(Patterns::Double()));
    prm.leave_subsection();

    prm.enter_subsection("Sphere");
    prm.add_parameter("Radius", sphere_radius, "Radius about the origin [length].",
                      positive_number());
    prm.add_parameter("Longitudes", longitudes, angles_text, pair_of(Patterns::Double(-360, 360)));
    prm.add_parameter("Latitudes", latitudes, "First and last angle from the equator [degree].",
                      pair_of(Patterns::Double(-90, 90)));
    prm.leave_subsection();

    prm.enter_subsection("Annulus");
    prm.add_parameter("Radii", annulus_radii, "Inner and outer radius about the origin [length].",
                      pair_of(positive_number()));
    prm.add_parameter("Angles", annulus_angles, angles_text, pair_of(Patterns::Double(-360, 360)));
    prm.leave_subsection();

    prm.enter_subsection("Valve");
    design.add_parameters(prm);
    prm.leave_subsection();

    prm.enter_subsection("NURBS");
    prm.add_parameter("Degrees", nurbs_degrees, "Degrees of the given net.",
                      pair_of(Patterns::Integer(1, 8)));
    for (unsigned int direction = 0; direction < 2; ++direction)
      prm.add_parameter("Knots " + std::to_string(direction + 1), nurbs_knots[direction],
                        "Knot vector of direction " + std::to_string(direction + 1) +
                            ", end knots repeated degree + 1 times.");
    prm.add_parameter("Control net", control_net,
                      "x, y, z, weight of the control points, the first direction fastest; "
                      "coordinates are not multiplied by the weight [length].",
                      Patterns::List(Patterns::List(Patterns::Double(), 4, 4), 4,
                                     Patterns::List::max_int_value, ";"));
    prm.leave_subsection();
    prm.leave_subsection();
  }
} // namespace semilunar::scene
