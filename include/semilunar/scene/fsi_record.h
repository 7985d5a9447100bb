// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_scene_fsi_record_h
#define semilunar_scene_fsi_record_h

#include <semilunar/output/cross_section.h>
#include <semilunar/output/time_series.h>
#include <semilunar/scene/flow_through_valve.h>
#include <semilunar/scene/shell_output.h>
#include <semilunar/scene/valve_in_blood.h>
#include <semilunar/scene/valve_motion.h>
#include <semilunar/scene/wall_record.h>

namespace semilunar::scene
{
  /// What a run of a valve in blood leaves behind: time series, files of leaflets and blood,
  /// quantities.
  class FsiRecord
  {
  public:
    /// On a dry run nothing is written.
    FsiRecord(const ValveFsiParameters &parameters, ValveInBlood &valve, RunContext &context);

    /// The first rows and files, of the state at the start.
    void begin();
    /// After each step.
    void add(const coupling::CoupledReport &report);
    void count_rejected_step() { ++counts.rejected; }
    /// Files of the present state.
    void write();
    /// The blood's mesh has changed. Collective.
    void locate_sections();
    void add_quantities();
    /// Name of the last file of the leaflets.
    const std::string &last_file() const { return counts.last_file; }

    void add_to(Checkpoints &checkpoints);
    /// Before a checkpoint: how long the files are.
    void remember_sizes() { counts.series_size = series.size(); }
    /// After a checkpoint was restored: files go on from there.
    void go_on();

  private:
    const ValveFsiParameters &prm;
    ValveInBlood &valve;
    RunContext &context;
    std::array<output::CrossSection<3>, 2> sections;
    ValveMotion motion;
    const std::unique_ptr<WallRecord<3>> wall; ///< null: it is rigid
    output::TimeSeries series;
    ShellOutput shell_files;
    output::FlowVtu<3> flow_files;
    FlowThroughValve flow_through;

    struct Counts
    {
      double next_row = 0., next_shell_file = 0., next_flow_file = 0.; ///< [s]
      /// Largest relative imbalance of power, and largest penetration [cm], so far.
      double largest_imbalance = 0., largest_penetration = 0.;
      unsigned int steps = 0, iterations = 0, rejected = 0;
      /// With an elastic wall: what flowed in so far should be what is stored [cm^3], [cm^3/s].
      double volume_at_start = 0., net_inflow = 0., last_net_flow_rate = 0.,
             largest_volume_error = 0.;
      std::uintmax_t series_size = 0;
      std::string last_file{};

      template <class Archive>
      void serialize(Archive &archive, const unsigned int /*version*/)
      {
        archive &next_row &next_shell_file &next_flow_file &largest_imbalance &largest_penetration;
        archive &steps &iterations &rejected &series_size &last_file;
        archive &volume_at_start &net_inflow &last_net_flow_rate &largest_volume_error;
      }
    } counts;

    double pressure_difference() const;
    void balance_volumes(const coupling::CoupledReport &report);
    void add_row(const coupling::CoupledReport &report, double pressure_difference);
    void write_shell();
    void write_flow();
    void describe(const coupling::CoupledReport &report, double outflow) const;
  };
} // namespace semilunar::scene

#endif
