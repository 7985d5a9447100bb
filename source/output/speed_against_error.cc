// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/first_rank.h>
#include <semilunar/output/atomic_file.h>
#include <semilunar/output/log_log_plot.h>
#include <semilunar/output/speed_against_error.h>

#include <algorithm>
#include <cmath>
#include <ostream>

namespace semilunar::output
{
  namespace
  {
    /// Errors are relative to the largest value, as the limit may be zero.
    double scale(const QuantityStudy &study)
    {
      double largest = std::abs(study.estimate.limit);
      for (const double value : study.values)
        largest = std::max(largest, std::abs(value));
      return largest > 0. ? largest : 1.;
    }

    void write_csv(std::ostream &out, const std::vector<LevelRun> &runs,
                   const std::vector<QuantityStudy> &studies)
    {
      out.precision(12);
      out << "quantity,unit,level,value,error,relative_error,estimated_by,order,unknowns,steps,"
             "wall_s,cpu_s,peak_memory_mib\n";
      for (const QuantityStudy &study : studies)
        for (unsigned int k = 0; k < runs.size(); ++k)
          out << study.name << ',' << study.unit << ',' << runs[k].level << ',' << study.values[k]
              << ',' << study.estimate.errors[k] << ',' << study.estimate.errors[k] / scale(study)
              << ',' << study.estimate.basis << ',' << study.estimate.orders[k] << ','
              << runs[k].results.unknowns << ',' << runs[k].results.steps << ','
              << runs[k].cost.wall_seconds << ',' << runs[k].cost.cpu_seconds << ','
              << runs[k].cost.peak_memory_mib << '\n';
    }

    LogLogPlot plot(const std::vector<LevelRun> &runs, const std::vector<QuantityStudy> &studies)
    {
      LogLogPlot plot{"Speed against error", "processor time [s]", "relative error", {}};
      for (const QuantityStudy &study : studies)
      {
        LogLogPlot::Curve curve{study.name, {}};
        for (unsigned int k = 0; k < runs.size(); ++k)
          curve.points.push_back(
              {{runs[k].cost.cpu_seconds, study.estimate.errors[k] / scale(study)}});
        plot.curves.push_back(curve);
      }
      return plot;
    }

    const Quantity *find(const RunResults &results, const std::string &name)
    {
      const auto found =
          std::find_if(results.quantities.begin(), results.quantities.end(),
                       [&](const Quantity &candidate) { return candidate.name == name; });
      return found == results.quantities.end() ? nullptr : &*found;
    }
  } // namespace

  std::vector<QuantityStudy> study_quantities(const std::vector<LevelRun> &runs)
  {
    std::vector<double> sizes;
    for (const LevelRun &run : runs)
      sizes.push_back(run.size);
    std::vector<QuantityStudy> studies;
    for (const Quantity &quantity : runs.back().results.quantities)
    {
      QuantityStudy study{quantity.name, quantity.unit, quantity.reference, {}, {}};
      for (const LevelRun &run : runs)
        if (const Quantity *const same = find(run.results, quantity.name))
          if (std::isfinite(same->value))
            study.values.push_back(same->value);
      if (study.values.size() != runs.size())
        continue;
      study.estimate = estimate_errors(study.values, sizes, study.reference);
      studies.push_back(study);
    }
    return studies;
  }

  void write_speed_against_error(const std::filesystem::path &folder,
                                 const std::vector<LevelRun> &runs,
                                 const std::vector<QuantityStudy> &studies)
  {
    on_first_rank(
        [&]()
        {
          write_atomically((folder / "speed_vs_error.csv").string(),
                           [&](std::ostream &out) { write_csv(out, runs, studies); });
          write_atomically((folder / "speed_vs_error.svg").string(),
                           [&](std::ostream &out) { write_svg(out, plot(runs, studies)); });
        });
  }
} // namespace semilunar::output
