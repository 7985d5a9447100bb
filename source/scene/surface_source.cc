// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/core/parameters.h>
#include <semilunar/scene/surface_source.h>
#include <semilunar/shell/location.h>
#include <semilunar/spline/cad_file.h>
#include <semilunar/spline/iga_file.h>
#include <semilunar/spline/patches.h>
#include <semilunar/spline/primitives.h>
#include <semilunar/valve/deployment.h>
#include <semilunar/valve/leaflets.h>
#include <semilunar/valve/stent.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/utilities.h>
#include <deal.II/physics/transformations.h>

#include <regex>

namespace semilunar::scene
{
  namespace
  {
    constexpr double degrees = dealii::numbers::PI / 180.;

    void require_increasing(const std::array<double, 2> &range, const std::string &entry)
    {
      if (!(range[0] < range[1]))
        throw InputError(entry,
                         dealii::Utilities::to_string(range[0]) + ", " +
                             dealii::Utilities::to_string(range[1]),
                         "the range is empty", "give the smaller number first");
    }

    void scale_coordinates(spline::Surface &surface, const double factor)
    {
      for (spline::ControlPoint &point : surface.control_points)
        point.position *= factor;
    }

    /// "turn x 90 (1, 0, 0)": a rotation about an axis through the origin, and a shift after it.
    spline::Surface copy(spline::Surface surface, const std::string &description)
    {
      const char *const entry = "Surface/Copies";
      static const std::regex form(R"((?:turn\s+([xyz])\s+(\S+)\s*)?(\(.*\)))");
      std::smatch match;
      if (!std::regex_match(description, match, form))
        throw InputError(entry, description, "this is not a copy",
                         "write (x, y, z), or turn x DEGREES (x, y, z)");
      dealii::Tensor<2, 3> rotation = dealii::unit_symmetric_tensor<3, double>();
      if (match[1].matched)
      {
        spline::Point<3> axis;
        axis[match[1].str()[0] - 'x'] = 1.;
        rotation = dealii::Physics::Transformations::Rotations::rotation_matrix_3d(
            axis, degrees * shell::parse_number(match[2], entry));
      }
      const auto shift = shell::parse_vector(match[3], entry);
      for (spline::ControlPoint &point : surface.control_points)
        point.position = spline::Point<3>(rotation * point.position + shift);
      return surface;
    }

    void add_copies(const std::string &list, spline::Surface &surface)
    {
      const double merge_nothing = -1.;
      const spline::Surface original = surface;
      for (const std::string &item : dealii::Utilities::split_string_list(list, ';'))
        if (!item.empty())
          spline::append(surface, copy(original, item), merge_nothing);
    }

    /// The mistakes that @p build finds, with the entry that causes them.
    template <typename Build>
    auto naming_entry(const std::string &entry, const Build &build)
    {
      try
      {
        return build();
      }
      catch (const InputError &error)
      {
        throw error.at(entry);
      }
    }
  } // namespace

  spline::Surface SurfaceSource::build() const
  {
    spline::Surface surface;
    if (source == "iga")
    {
      if (file.empty())
        throw InputError("Surface/File", "", "is not set", "name an .iga file");
      surface = spline::read_iga(file, scale);
    }
    else if (source == "cad")
    {
      if (!spline::is_cad_file(file))
        throw InputError("Surface/File", file, "is no CAD file",
                         "name a .step, .stp, .iges or .igs file");
      surface = spline::join(spline::read_cad(file), degree, join_tolerance);
      scale_coordinates(surface, scale);
    }
    else if (source == "leaflets" || source == "stent" || source == "valve")
      surface = parts_of_valve();
    else
      surface = patch();
    add_copies(copies, surface);
    spline::check(surface, "Surface");
    return surface;
  }

  spline::Surface SurfaceSource::patch() const
  {
    spline::NurbsPatch patch = source == "nurbs" ? nurbs_patch() : simple_shape();
    elevate_and_refine(patch);
    spline::Surface surface = spline::to_surface(patch);
    scale_coordinates(surface, scale);
    return surface;
  }

  spline::Surface SurfaceSource::parts_of_valve() const
  {
    design.check("Surface/Valve");
    spline::Surface surface;
    const double merge_nothing = -1.;
    if (source != "stent")
      spline::append(surface, valve::leaflets(design), merge_nothing);
    if (source != "leaflets")
      spline::append(surface, valve::stent(design), merge_nothing);
    scale_coordinates(surface, scale);
    return surface;
  }

  std::vector<spline::NurbsPatch> SurfaceSource::patches(const spline::Surface &surface) const
  {
    std::vector<spline::NurbsPatch> result;
    const bool is_part_of_valve = source == "leaflets" || source == "stent" || source == "valve";
    if (!is_part_of_valve || scale != 1. || !copies.empty())
      return spline::bezier_patches(surface);
    if (source != "stent")
      for (unsigned int k = 0; k < design.n_leaflets; ++k)
        result.push_back(valve::in_place(valve::leaflet_patch(design), k, design));
    if (source != "leaflets")
      for (const spline::NurbsPatch &patch : valve::stent_patches(design))
        result.push_back(patch);
    return result;
  }

  spline::NurbsPatch SurfaceSource::simple_shape() const
  {
    if (source == "cylinder")
    {
      require_increasing(cylinder_angles, "Surface/Cylinder/Angles");
      require_increasing(cylinder_heights, "Surface/Cylinder/Heights");
      return spline::cylinder(cylinder_radius, degrees * cylinder_angles[0],
                              degrees * cylinder_angles[1], cylinder_heights[0],
                              cylinder_heights[1]);
    }
    if (source == "sphere")
    {
      require_increasing(longitudes, "Surface/Sphere/Longitudes");
      require_increasing(latitudes, "Surface/Sphere/Latitudes");
      return spline::sphere(sphere_radius, degrees * longitudes[0], degrees * longitudes[1],
                            degrees * latitudes[0], degrees * latitudes[1]);
    }
    if (source == "annulus")
    {
      require_increasing(annulus_radii, "Surface/Annulus/Radii");
      require_increasing(annulus_angles, "Surface/Annulus/Angles");
      return spline::annulus(annulus_radii[0], annulus_radii[1], degrees * annulus_angles[0],
                             degrees * annulus_angles[1]);
    }
    std::array<spline::Point<3>, 4> points;
    for (unsigned int i = 0; i < 4; ++i)
      points[i] = spline::Point<3>(corners[i][0], corners[i][1], corners[i][2]);
    return spline::quadrilateral(points);
  }

  spline::NurbsPatch SurfaceSource::nurbs_patch() const
  {
    const auto knot_vector = [this](const unsigned int direction)
    {
      return naming_entry(
          "Surface/NURBS/Knots " + std::to_string(direction + 1),
          [&]() { return spline::KnotVector(nurbs_degrees[direction], nurbs_knots[direction]); });
    };
    const std::array<spline::KnotVector, 2> knots{{knot_vector(0), knot_vector(1)}};
    const std::size_t n_points = knots[0].n_functions() * knots[1].n_functions();
    if (control_net.size() != n_points)
      throw InputError("Surface/NURBS/Control net", "",
                       std::to_string(control_net.size()) + " control points are given",
                       "degrees and knots ask for " + std::to_string(n_points));
    std::vector<spline::ControlPoint> net;
    for (const std::vector<double> &point : control_net)
    {
      if (!(point[3] > 0.))
        throw InputError("Surface/NURBS/Control net", dealii::Utilities::to_string(point[3]),
                         "the weight of control point " + std::to_string(net.size()) +
                             " is not positive",
                         "give weights greater than 0");
      net.push_back({spline::Point<3>(point[0], point[1], point[2]), point[3]});
    }
    return spline::NurbsPatch(knots, net);
  }

  void SurfaceSource::elevate_and_refine(spline::NurbsPatch &patch) const
  {
    for (unsigned int direction = 0; direction < 2; ++direction)
    {
      const unsigned int p = patch.knots(direction).degree();
      if (degree < p)
        throw InputError("Surface/Degree", std::to_string(degree), "is too small for this shape",
                         "give at least " + std::to_string(p));
      if (degree > p)
        patch.elevate_degree(direction, degree - p);
      naming_entry("Surface/Elements",
                   [&]() { patch.refine_to(direction, n_elements[direction]); });
    }
  }
} // namespace semilunar::scene
