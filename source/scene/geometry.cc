// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/core/first_rank.h>
#include <semilunar/output/pvd.h>
#include <semilunar/output/surface_stl.h>
#include <semilunar/output/time_series.h>
#include <semilunar/scene/geometry.h>
#include <semilunar/scene/surface_report.h>
#include <semilunar/spline/cad_file.h>
#include <semilunar/spline/evaluation.h>
#include <semilunar/spline/iga_file.h>

namespace semilunar::scene
{
  void Geometry::add_parameters(dealii::ParameterHandler &prm)
  {
    source.add_parameters(prm);
    prm.enter_subsection("Output");
    vtu.add_parameters(prm);
    prm.add_parameter("CAD file", cad_file,
                      "Also write the surface as patches to a file of this name, surface.step or "
                      "surface.iges; none if empty. Parts of valves are written unrefined, other "
                      "surfaces as one patch for each element. Lengths are taken for cm.",
                      dealii::Patterns::Selection("|surface.step|surface.iges"));
    prm.leave_subsection();
  }

  void Geometry::run(RunContext &context)
  {
    spline::Surface surface;
    SurfaceReport measured;
    {
      const Timers::Scope timer(context.timers, "geometry");
      surface = source.build();
      measured = report(surface);
    }
    print(measured, context.log);
    if (context.dry_run)
      return;

    const Timers::Scope timer(context.timers, "output");
    on_first_rank(
        [&]()
        {
          spline::write_iga(surface, (context.folder / "surface.iga").string());
          output::write_stl(surface, (context.folder / "surface.stl").string(), vtu.subdivisions);
          if (!cad_file.empty())
            spline::write_cad(source.patches(surface), (context.folder / cad_file).string());
          output::write_surface_vtu((context.folder / "surface.vtu").string(), surface,
                                    spline::positions(surface), {}, vtu, 0.);
          output::PvdCollection((context.folder / "surface.pvd").string()).add(0., "surface.vtu");
        });
    output::TimeSeries(context.folder, {{"step", "-"}, {"area", "length^2"}})
        .add_row({0., measured.area});
    add_quantities(measured, context.results);
  }
} // namespace semilunar::scene
