// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/scene/valve_statics.h>
#include <semilunar/valve/deployment.h>
#include <semilunar/valve/orifice.h>
#include <semilunar/valve/symmetry.h>

#include <algorithm>
#include <limits>
#include <numeric>

namespace semilunar::scene
{
  namespace
  {
    /// Vertical extent of the points that carry contact pressure.
    double coaptation_height(const ShellModel &model, const shell::ControlVectors &x)
    {
      double low = std::numeric_limits<double>::infinity(), high = -low;
      spline::BasisValues basis;
      for (const auto &point : model.contact->contact_points())
        if (point.pressure > 0.)
        {
          const auto &element = model.surface.elements[model.points.element(point.q)];
          const double *R = model.points.basis(point.q, spline::value);
          double z = 0.;
          for (unsigned int a = 0; a < element.n_functions(); ++a)
            z += R[a] * x[element.control_points[a]][2];
          low = std::min(low, z);
          high = std::max(high, z);
        }
      return std::max(0., high - low);
    }
    /// Where a free edge meets a clamped one, strain is singular in the limit of fine meshes, and a
    /// shell theory says nothing within about a thickness: so many thicknesses are left out.
    constexpr double commissure_neighbourhood = 2.;

    /// The largest strain on either face further away from the commissures than that. Strain rises
    /// towards them: elements around the limit are looked at in many points, or the value would
    /// depend on where the next Gauss point lies.
    class StrainOffCommissures
    {
    public:
      StrainOffCommissures(const ShellModel &model, const shell::ControlVectors &x,
                           const valve::Design &design)
          : model(model), x(x), half_thickness(0.5 * model.section->thickness()),
            limit(commissure_neighbourhood * model.section->thickness())
      {
        for (const auto &point : model.surface.control_points)
          if (point.position[2] > (1. - 1e-12) * design.commissure_height)
            commissures.push_back(point.position);
      }

      double operator()() const
      {
        double largest = 0.;
        for (unsigned int e = 0; e < model.surface.elements.size(); ++e)
        {
          double nearest = std::numeric_limits<double>::infinity();
          for (unsigned int q = model.points.first_point(e); q < model.points.first_point(e + 1);
               ++q)
            nearest = std::min(nearest, look_at({e, model.points.xi(q)}, largest));
          if (nearest < 2. * limit)
            for (unsigned int k = 0; k < (n_samples + 1) * (n_samples + 1); ++k)
              look_at({e,
                       {double(k % (n_samples + 1)) / n_samples,
                        double(k / (n_samples + 1)) / n_samples}},
                      largest);
        }
        return largest;
      }

    private:
      static constexpr unsigned int n_samples = 20; ///< in each direction
      const ShellModel &model;
      const shell::ControlVectors &x;
      const double half_thickness, limit;
      std::vector<spline::Tensor<1, 3>> commissures;

      /// Take a point into account. @return its distance from the nearest commissure
      double look_at(const spline::SurfacePoint &point, double &largest) const
      {
        const auto position = spline::evaluate(model.surface, point)[spline::value];
        double nearest = std::numeric_limits<double>::infinity();
        for (const auto &c : commissures)
          nearest = std::min(nearest, (c - position).norm());
        if (nearest >= limit)
          for (const double xi : {half_thickness, -half_thickness})
            largest = std::max(largest,
                               principal_strains(model.assembly.section_strain(x, point), xi)[0]);
        return nearest;
      }
    };
  } // namespace

  void ValveStatics::add_parameters(dealii::ParameterHandler &prm)
  {
    source.add_parameters(prm);
    analysis.add_parameters(prm);
    adaptivity.add_parameters(prm);
  }

  void ValveStatics::check() const
  {
    source.check();
    adaptivity.check(analysis, source.design);
  }

  void ValveStatics::run(RunContext &context)
  {
    if (adaptivity.n_rounds > 0)
    {
      solve_adaptively(
          source, analysis, adaptivity,
          [this](ShellModel &model, const shell::ControlVectors &x, RunResults &results)
          { add_quantities(model, x, results); },
          context);
      return;
    }
    std::unique_ptr<ShellModel> model;
    {
      const Timers::Scope timer(context.timers, "set-up");
      model = std::make_unique<ShellModel>(source.build(), analysis.shell, context.timers,
                                           source.n_sectors());
    }
    const shell::ControlVectors x = analysis.run(*model, context);
    if (!context.dry_run)
      add_quantities(*model, x, context.results);
  }

  void ValveStatics::add_quantities(ShellModel &model, const shell::ControlVectors &x,
                                    RunResults &results) const
  {
    auto &quantities = results.quantities;
    const double thickness = model.section->thickness();
    // what the leaflets of an oval stent leave free, seen on the round one
    const valve::CrossSection section = valve::cross_section(source.design);
    const double orifice =
        section.longer * section.shorter *
        valve::orifice_area(model.symmetry.whole(model.surface),
                            valve::undeployed(model.symmetry.whole(x), source.design),
                            source.design.radius, thickness);
    quantities.push_back({"orifice_area", orifice, "cm^2"});
    if (source.n_sectors() == 1)
      quantities.push_back(
          {"rotational_asymmetry", valve::rotational_asymmetry(model.surface, x), "-"});
    quantities.push_back(
        {"max_mipe_off_commissures", StrainOffCommissures(model, x, source.design)(), "-"});
    if (!model.contact)
      return;
    model.contact->update(x);
    const std::vector<double> areas = model.contact->contact_areas();
    const double area = std::accumulate(areas.begin(), areas.end(), 0.) / areas.size();
    const double penetration = model.contact->largest_penetration();
    quantities.insert(quantities.end(),
                      {{"coaptation_area", area, "cm^2 per leaflet"},
                       {"coaptation_height", coaptation_height(model, x), "cm"},
                       {"largest_penetration", penetration, "cm"},
                       {"largest_penetration_of_thickness", penetration / thickness, "-"}});
  }
} // namespace semilunar::scene
