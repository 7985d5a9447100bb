// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/checkpoint.h>
#include <semilunar/core/exceptions.h>
#include <semilunar/core/first_rank.h>
#include <semilunar/core/parameters.h>
#include <semilunar/output/atomic_file.h>
#include <semilunar/output/run_folder.h>

#include <set>

namespace semilunar::output
{
  namespace fs = std::filesystem;

  namespace
  {
    bool belongs_to_a_run(const fs::path &file)
    {
      static const std::set<std::string> names = {
          "parameters.prm", "summary.json",  "timeseries.csv",     "profile.csv",
          "free_edge.csv",  "deviation.csv", "speed_vs_error.csv", "speed_vs_error.svg",
          "adaptivity.csv", "elements.csv"};
      static const std::set<std::string> extensions = {".pvd", ".vtu", ".part"};
      return names.count(file.filename().string()) > 0 ||
             extensions.count(file.extension().string()) > 0;
    }

    void make_empty(const fs::path &folder)
    {
      if (fs::exists(folder) && !fs::is_directory(folder))
        throw InputError("--output", folder.string(), "this is a file", "give a folder");
      fs::create_directories(folder);
      if (!fs::is_empty(folder) && !fs::exists(folder / "parameters.prm"))
        throw InputError("--output", folder.string(),
                         "the folder holds files that are not from a run",
                         "give an empty or a new folder");
      for (const fs::directory_entry &file : fs::directory_iterator(folder))
        if (file.is_regular_file() && belongs_to_a_run(file.path()))
          fs::remove(file.path());
      remove_checkpoints(folder);
    }
  } // namespace

  void create_run_folder(const fs::path &folder)
  {
    on_first_rank(
        [&]()
        {
          try
          {
            make_empty(folder);
          }
          catch (const fs::filesystem_error &error)
          {
            throw InputError("--output", folder.string(),
                             "the folder cannot be made: " + error.code().message(),
                             "give a folder that you may write to");
          }
        });
  }

  void write_parameters(const fs::path &folder, const dealii::ParameterHandler &parameters,
                        const std::string &version)
  {
    on_first_rank(
        [&]()
        {
          write_atomically((folder / "parameters.prm").string(),
                           [&](std::ostream &out)
                           {
                             out << "# " << version << "\n\n";
                             print_parameters(parameters, ParameterFormat::prm, out);
                           });
        });
  }
} // namespace semilunar::output
