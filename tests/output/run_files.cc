// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The folder of a run: created, cleared of an earlier run, never taken from someone else's files;
// the summary and the time series.

#include <semilunar/core/exceptions.h>
#include <semilunar/output/run_folder.h>
#include <semilunar/output/summary.h>
#include <semilunar/output/time_series.h>

#include <deal.II/base/mpi.h>

#include <limits>

#include "../tests.h"

using namespace semilunar;
using tests::log;
namespace fs = std::filesystem;

namespace
{
  void copy_to_log(const fs::path &file)
  {
    log() << std::ifstream(file).rdbuf();
  }

  void run_folder()
  {
    const fs::path folder = "a/new/folder";
    fs::remove_all("a");
    output::create_run_folder(folder);
    dealii::ParameterHandler prm;
    prm.declare_entry("Scene", "geometry", dealii::Patterns::Anything(), "Kind of scene.");
    output::write_parameters(folder, prm, "semilunar 1");
    copy_to_log(folder / "parameters.prm");

    for (const char *const name : {"old.vtu", "summary.json", "notes.txt", "surface.iga"})
      std::ofstream(folder / name) << "old";
    output::create_run_folder(folder);
    for (const char *const name :
         {"old.vtu", "summary.json", "parameters.prm", "notes.txt", "surface.iga"})
      log() << name << (fs::exists(folder / name) ? " kept" : " removed") << std::endl;
    for (const fs::path &wrong : {folder, folder / "notes.txt", folder / "notes.txt/x"})
      try
      {
        output::create_run_folder(wrong);
        log() << "NO MESSAGE for " << wrong << std::endl;
      }
      catch (const InputError &error)
      {
        log() << error.what() << std::endl;
      }
  }

  void summary()
  {
    output::Summary summary;
    summary.scene = "a \"quoted\\ name\"\n";
    log() << output::to_json(summary);
    summary.results.quantities = {{"max_mipe", 0.319, "-"},
                                  {"gap", std::numeric_limits<double>::quiet_NaN(), "cm"},
                                  {"speed", std::numeric_limits<double>::infinity(), "cm/s"}};
    summary.results.steps = 12;
    summary.results.newton_iterations = 57;
    summary.cost = {1.5, 2.5, 128.};
    summary.phases = {{"assembly", 0.75}, {"linear solver", 0.5}};
    summary.version = "1";
    output::write_summary("a", summary);
    copy_to_log("a/summary.json");
  }

  void time_series()
  {
    output::TimeSeries series("a", {{"load_factor", "-"}, {"volume", "cm^3"}});
    series.add_row({0., 1. / 3.});
    copy_to_log("a/timeseries.csv"); // on disk while the series is still open
    series.add_row({1., std::numeric_limits<double>::quiet_NaN()});
    copy_to_log("a/timeseries.csv");
  }
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  run_folder();
  summary();
  time_series();
}
