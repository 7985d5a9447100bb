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

    /// The largest strain on either face further away from the commissures than that.
    double strain_off_commissures(const ShellModel &model, const shell::ControlVectors &x,
                                  const valve::Design &design)
    {
      std::vector<spline::Tensor<1, 3>> commissures;
      for (const auto &point : model.surface.control_points)
        if (point.position[2] > (1. - 1e-12) * design.commissure_height)
          commissures.push_back(point.position);
      const double radius = commissure_neighbourhood * model.section->thickness();
      const auto counts = [&](const unsigned int q)
      {
        const auto position = spline::evaluate(
            model.surface, {model.points.element(q), model.points.xi(q)})[spline::value];
        return std::none_of(commissures.begin(), commissures.end(),
                            [&](const auto &c) { return (c - position).norm() < radius; });
      };
      return std::max(largest_strain(model, x, 1, counts).value,
                      largest_strain(model, x, -1, counts).value);
    }
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
        {"max_mipe_off_commissures", strain_off_commissures(model, x, source.design), "-"});
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
