// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_scene_valve_motion_h
#define semilunar_scene_valve_motion_h

#include <semilunar/scene/dynamic_analysis.h>
#include <semilunar/scene/valve_source.h>

namespace semilunar::scene
{
  /// When a valve opens and closes, from the orifice area over time. Times lie between samples by
  /// linear interpolation; what does not happen is a NaN. Shares refer to the largest area.
  struct ValveTimes
  {
    double opening_begins; ///< area first reaches the small share
    double fully_open;     ///< area first reaches the large share
    double closing_begins; ///< area last falls below the large share
    double closed;         ///< area then first falls below the small share
    static constexpr double small_share = 0.05, large_share = 0.95;
  };
  /// @param areas pairs of time and orifice area, by ascending time
  ValveTimes valve_times(const std::vector<std::pair<double, double>> &areas);

  /// Watches a valve: orifice, coaptation (complete when the area in contact first reaches the
  /// large share of its largest value), and the shape of the first leaflet, whose profile in its
  /// symmetry plane goes to profile.csv and whose free edge to free_edge.csv.
  class ValveMotion : public MotionObserver
  {
  public:
    ValveMotion(const ValveSource &source, ShellModel &model, const RunContext &context);

    std::vector<output::TimeSeries::Column> columns() const override;
    std::vector<double> row(double time, const shell::ControlVectors &x) override;
    void add_to(Checkpoints &checkpoints) override;
    void add_quantities(RunResults &results) const;

    /// Save or restore.
    template <class Archive>
    void serialize(Archive &archive, unsigned int version);

  private:
    const ValveSource &source;
    ShellModel &model;
    const spline::Surface whole; // all leaflets
    std::vector<spline::SurfacePoint> profile, edge;
    output::TimeSeries profile_file, edge_file;
    std::vector<std::pair<double, double>> areas, coaptations;
    double largest_strain_seen = 0.;

    std::vector<spline::SurfacePoint> points_along(unsigned int direction) const;
    void write_curve(double time, const shell::ControlVectors &x,
                     const std::vector<spline::SurfacePoint> &points, output::TimeSeries &file);
  };
} // namespace semilunar::scene

#endif
