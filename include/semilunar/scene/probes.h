// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_scene_probes_h
#define semilunar_scene_probes_h

#include <semilunar/core/run_context.h>
#include <semilunar/output/time_series.h>
#include <semilunar/shell/assembly.h>

namespace semilunar::scene
{
  /// Named points of a surface whose displacement is recorded.
  class Probes
  {
  public:
    /// @param list "A: (x, y, z); B: (x, y, z)": the points of the undeformed surface nearest to
    /// these
    /// @throws InputError naming @p entry
    Probes(const std::string &list, const spline::Surface &surface, const std::string &entry);

    std::vector<output::TimeSeries::Column> columns() const;
    std::vector<std::string> names() const;
    /// Displacement components of all probes, in the order of the columns.
    std::vector<double> displacements(const shell::ControlVectors &x) const;
    /// The same as quantities.
    void add_quantities(const shell::ControlVectors &x, RunResults &results) const;

  private:
    struct Probe
    {
      std::string name;
      spline::SurfacePoint point;
    };
    const spline::Surface &surface;
    std::vector<Probe> probes;
  };
} // namespace semilunar::scene

#endif
