// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/archive.h>
#include <semilunar/scene/valve_motion.h>
#include <semilunar/spline/closest_point.h>
#include <semilunar/valve/leaflets.h>
#include <semilunar/valve/orifice.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace semilunar::scene
{
  namespace
  {
    using Areas = std::vector<std::pair<double, double>>;
    constexpr unsigned int n_curve_points = 41;

    /// Where a point of the surface is if the control points are at x.
    spline::Tensor<1, 3> place(const spline::Surface &surface, const shell::ControlVectors &x,
                               const spline::SurfacePoint &point)
    {
      spline::BasisValues basis;
      evaluate_basis(surface, point.element, point.xi, basis);
      return interpolate(surface.elements[point.element], basis, x)[spline::value];
    }

    double largest_of(const Areas &areas)
    {
      double largest = 0.;
      for (const auto &sample : areas)
        largest = std::max(largest, sample.second);
      return largest;
    }

    /// The first time from sample @p begin on at which the area passes a level, upwards or
    /// downwards.
    double first_passage(const Areas &areas, const std::size_t begin, const double level,
                         const bool upwards)
    {
      for (std::size_t i = begin; i < areas.size(); ++i)
      {
        const bool beyond = upwards ? areas[i].second >= level : areas[i].second <= level;
        if (!beyond)
          continue;
        if (i == begin)
          return areas[i].first;
        const auto &[t0, a0] = areas[i - 1];
        const auto &[t1, a1] = areas[i];
        return t0 + (t1 - t0) * (level - a0) / (a1 - a0);
      }
      return std::nan("");
    }
  } // namespace

  ValveTimes valve_times(const Areas &areas)
  {
    ValveTimes times{std::nan(""), std::nan(""), std::nan(""), std::nan("")};
    const double largest = largest_of(areas);
    if (!(largest > 0.))
      return times;
    const double low = ValveTimes::small_share * largest, high = ValveTimes::large_share * largest;
    times.opening_begins = first_passage(areas, 0, low, true);
    times.fully_open = first_passage(areas, 0, high, true);
    std::size_t last_open = 0;
    for (std::size_t i = 0; i < areas.size(); ++i)
      if (areas[i].second >= high)
        last_open = i;
    if (last_open + 1 < areas.size())
    {
      times.closing_begins = first_passage(areas, last_open, high, false);
      times.closed = first_passage(areas, last_open, low, false);
    }
    return times;
  }

  ValveMotion::ValveMotion(const ValveSource &source, ShellModel &model, const RunContext &context)
      : source(source), model(model), whole(model.symmetry.whole(model.surface)),
        profile(points_along(1)), edge(points_along(0)),
        profile_file(context.folder,
                     {{"time", "s"}, {"x", "cm"}, {"y", "cm"}, {"z", "cm"}, {"r", "cm"}},
                     "profile.csv", context.restart || context.dry_run),
        edge_file(context.folder,
                  {{"time", "s"}, {"x", "cm"}, {"y", "cm"}, {"z", "cm"}, {"r", "cm"}},
                  "free_edge.csv", context.restart || context.dry_run)
  {
  }

  /// Points of the first leaflet: along its free edge (0), or from its nadir to the middle of its
  /// free edge (1).
  std::vector<spline::SurfacePoint> ValveMotion::points_along(const unsigned int direction) const
  {
    const spline::NurbsPatch patch = valve::leaflet_patch(source.design);
    const auto at = [&patch](const unsigned int d, const double share)
    {
      const std::vector<double> &knots = patch.knots(d).knots();
      return knots.front() + share * (knots.back() - knots.front());
    };
    const auto x = spline::positions(model.surface);
    std::vector<spline::SurfacePoint> points;
    for (unsigned int i = 0; i < n_curve_points; ++i)
    {
      const double share = double(i) / (n_curve_points - 1);
      const spline::Point<2> u = direction == 0 ? spline::Point<2>(at(0, share), at(1, 1.))
                                                : spline::Point<2>(at(0, 0.5), at(1, share));
      points.push_back(closest_point(model.surface, x, patch.evaluate(u)).point);
    }
    return points;
  }

  std::vector<output::TimeSeries::Column> ValveMotion::columns() const
  {
    return {{"orifice_area", "cm^2"},
            {"coaptation_area", "cm^2 per leaflet"},
            {"tip_radius", "cm"},
            {"tip_height", "cm"}};
  }

  std::vector<double> ValveMotion::row(const double time, const shell::ControlVectors &x)
  {
    const double area = valve::orifice_area(whole, model.symmetry.whole(x), source.design.radius,
                                            model.section->thickness());
    largest_strain_seen = std::max({largest_strain_seen, largest_strain(model, x, 1).value,
                                    largest_strain(model, x, -1).value});
    write_curve(time, x, profile, profile_file);
    write_curve(time, x, edge, edge_file);
    double coaptation = std::nan("");
    if (model.contact)
    {
      const std::vector<double> parts = model.contact->contact_areas();
      coaptation = std::accumulate(parts.begin(), parts.end(), 0.) / parts.size();
    }
    areas.emplace_back(time, area);
    coaptations.emplace_back(time, coaptation);
    const auto tip = place(model.surface, x, profile.back());
    return {area, coaptation, std::hypot(tip[0], tip[1]), tip[2]};
  }

  void ValveMotion::write_curve(const double time, const shell::ControlVectors &x,
                                const std::vector<spline::SurfacePoint> &points,
                                output::TimeSeries &file)
  {
    for (const auto &point : points)
    {
      const auto p = place(model.surface, x, point);
      file.add_row({time, p[0], p[1], p[2], std::hypot(p[0], p[1])});
    }
  }

  template <class Archive>
  void ValveMotion::serialize(Archive &archive, const unsigned int /*version*/)
  {
    std::uintmax_t sizes[] = {profile_file.size(), edge_file.size()};
    archive &areas &coaptations &largest_strain_seen &sizes[0] & sizes[1];
    if (Archive::is_loading::value)
    {
      profile_file.go_on_at(sizes[0]);
      edge_file.go_on_at(sizes[1]);
    }
  }

  void ValveMotion::add_to(Checkpoints &checkpoints)
  {
    checkpoints.add_object("valve", *this);
  }

  void ValveMotion::add_quantities(RunResults &results) const
  {
    const ValveTimes times = valve_times(areas);
    const double largest = largest_of(areas);
    const double complete = ValveTimes::large_share * largest_of(coaptations);
    results.quantities.insert(
        results.quantities.end(),
        {{"largest_orifice_area", largest, "cm^2"},
         {"final_orifice_area", areas.back().second, "cm^2"},
         {"opening_begins", times.opening_begins, "s"},
         {"fully_open", times.fully_open, "s"},
         {"closing_begins", times.closing_begins, "s"},
         {"closed", times.closed, "s"},
         {"coaptation_complete",
          complete > 0. ? first_passage(coaptations, 0, complete, true) : std::nan(""), "s"},
         {"opening_time", times.fully_open - times.opening_begins, "s"},
         {"closing_time", times.closed - times.closing_begins, "s"},
         {"max_mipe_over_time", largest_strain_seen, "-"}});
  }
} // namespace semilunar::scene
