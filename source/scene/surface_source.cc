// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/core/parameters.h>
#include <semilunar/scene/surface_source.h>
#include <semilunar/spline/iga_file.h>
#include <semilunar/spline/primitives.h>
#include <semilunar/valve/leaflets.h>
#include <semilunar/valve/stent.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/utilities.h>

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
    else if (source == "leaflets" || source == "stent" || source == "valve")
      surface = parts_of_valve();
    else
      surface = patch();
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
