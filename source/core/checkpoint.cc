// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/checkpoint.h>
#include <semilunar/core/exceptions.h>
#include <semilunar/core/first_rank.h>
#include <semilunar/core/interrupt.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <boost/crc.hpp>

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

namespace semilunar
{
  namespace fs = std::filesystem;

  namespace
  {
    constexpr unsigned int n_slots = 2;
    const std::string title = "semilunar checkpoint, format 1";
    const char *const manifest_name = "manifest.txt";

    fs::path slot_in(const fs::path &folder, const unsigned int slot)
    {
      return folder / ("checkpoint-" + std::to_string(slot));
    }

    std::string contents(const fs::path &file)
    {
      std::ifstream in(file, std::ios::binary);
      return std::string(std::istreambuf_iterator<char>(in), {});
    }

    /// Size and check sum.
    std::string fingerprint(const std::string &bytes)
    {
      boost::crc_32_type crc;
      crc.process_bytes(bytes.data(), bytes.size());
      return std::to_string(bytes.size()) + " " + std::to_string(crc.checksum());
    }

    [[noreturn]] void cannot_write(const fs::path &folder)
    {
      throw InputError(folder.string(), "", "the checkpoint cannot be written",
                       "choose an output folder that is writable and has space left");
    }

    [[noreturn]] void cannot_restart(const fs::path &folder, const std::string &problem)
    {
      throw InputError("--restart", folder.string(), problem,
                       "restart with the scene that wrote it, or run without --restart");
    }

    void write_file(const fs::path &file, const std::function<void(std::ostream &)> &write)
    {
      std::ofstream out(file, std::ios::binary);
      if (out)
        write(out);
      out.close();
      if (!out)
        cannot_write(file.parent_path());
    }
  } // namespace

  /// What the manifest of a slot says.
  struct Checkpoints::Slot
  {
    bool complete = false;
    unsigned int step = 0;
    std::string fit;
    std::map<std::string, std::string> fingerprints; ///< of the replicated parts
  };

  void CheckpointParameters::add_parameters(dealii::ParameterHandler &prm)
  {
    using namespace dealii;
    prm.enter_subsection("Checkpoints");
    prm.add_parameter("Step interval", step_interval,
                      "Steps between checkpoints, from which --restart goes on; 0: none. A few "
                      "steps may pass until the state allows one.",
                      Patterns::Integer(0));
    prm.add_parameter("Wall interval", wall_interval, "The same in wall-clock time; 0: none [s].",
                      Patterns::Double(0.));
    prm.add_parameter("At interrupt", at_interrupt,
                      "Write one when the run is interrupted (Ctrl-C, SIGTERM).");
    prm.leave_subsection();
  }

  Checkpoints::Checkpoints(const fs::path &folder, const CheckpointParameters &parameters,
                           const std::string &fit)
      : folder(folder), parameters(parameters), fit(fit),
        last_write(std::chrono::steady_clock::now())
  {
  }

  fs::path Checkpoints::slot_folder(const unsigned int slot) const
  {
    return slot_in(folder, slot);
  }

  void Checkpoints::add(const std::string &name, const std::function<void(std::ostream &)> &save,
                        const std::function<void(std::istream &)> &load)
  {
    replicated_files.push_back(name);
    add_distributed(
        name,
        [name, save](const fs::path &slot)
        { on_first_rank([&] { write_file(slot / name, save); }); },
        [name, load](const fs::path &slot)
        {
          std::ifstream in(slot / name, std::ios::binary);
          try
          {
            load(in);
          }
          catch (const std::exception &)
          {
            cannot_restart(slot, "its part '" + name + "' does not belong to this version");
          }
        });
  }

  void Checkpoints::add_distributed(const std::string &name,
                                    const std::function<void(const fs::path &)> &save,
                                    const std::function<void(const fs::path &)> &load)
  {
    parts.push_back({name, save, load});
  }

  bool Checkpoints::due(const unsigned int step)
  {
    const std::chrono::duration<double> since = std::chrono::steady_clock::now() - last_write;
    const bool now = (parameters.step_interval > 0 && step % parameters.step_interval == 0) ||
                     (parameters.wall_interval > 0. && since.count() >= parameters.wall_interval);
    // clocks differ: the first rank's counts
    const unsigned int wanted =
        dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0 && now ? 1 : 0;
    return dealii::Utilities::MPI::max(wanted, MPI_COMM_WORLD) == 1 ||
           (parameters.at_interrupt && interrupted());
  }

  void Checkpoints::write(const unsigned int step, const double time)
  {
    const fs::path slot = slot_folder(next_slot), aside = slot.string() + ".part";
    const auto checked = [&](const std::function<void()> &action)
    {
      on_first_rank(
          [&]
          {
            try
            {
              action();
            }
            catch (const fs::filesystem_error &)
            {
              cannot_write(slot);
            }
          });
    };
    checked(
        [&]
        {
          fs::remove_all(aside);
          fs::create_directories(aside);
        });
    for (const Part &part : parts)
      part.save(aside);
    checked(
        [&]
        {
          write_file(aside / manifest_name,
                     [&](std::ostream &out)
                     {
                       out << title << '\n' << fit << '\n' << step << ' ' << time << '\n';
                       for (const std::string &name : replicated_files)
                         out << fingerprint(contents(aside / name)) << ' ' << name << '\n';
                     });
          fs::remove_all(slot);
          fs::rename(aside, slot);
        });
    next_slot = (next_slot + 1) % n_slots;
    last_write = std::chrono::steady_clock::now();
  }

  Checkpoints::Slot Checkpoints::read_manifest(const unsigned int slot) const
  {
    Slot result;
    std::ifstream in(slot_folder(slot) / manifest_name);
    std::string line;
    if (!std::getline(in, line) || line != title || !std::getline(in, result.fit) ||
        !std::getline(in, line) || !(std::istringstream(line) >> result.step))
      return result;
    result.complete = true;
    std::string size, sum, name;
    while (in >> size >> sum >> name)
    {
      result.fingerprints[name] = size + " " + sum;
      result.complete = result.complete && fingerprint(contents(slot_folder(slot) / name)) ==
                                               result.fingerprints[name];
    }
    return result;
  }

  unsigned int Checkpoints::restore()
  {
    const Slot slots[] = {read_manifest(0), read_manifest(1)};
    if (!slots[0].complete && !slots[1].complete)
      cannot_restart(folder, "there is no complete checkpoint of this version");
    const unsigned int newest =
        slots[1].complete && (!slots[0].complete || slots[1].step > slots[0].step) ? 1 : 0;
    if (slots[newest].fit != fit)
      cannot_restart(slot_folder(newest),
                     "the checkpoint is of " + slots[newest].fit + ", the scene has " + fit);
    for (const std::string &name : replicated_files)
      if (slots[newest].fingerprints.count(name) == 0)
        cannot_restart(slot_folder(newest), "the checkpoint has no part '" + name + "'");
    for (const Part &part : parts)
      part.load(slot_folder(newest));
    next_slot = (newest + 1) % n_slots;
    return slots[newest].step;
  }

  bool has_checkpoint(const fs::path &folder)
  {
    for (unsigned int slot = 0; slot < n_slots; ++slot)
      if (fs::exists(slot_in(folder, slot) / manifest_name))
        return true;
    return false;
  }

  void remove_checkpoints(const fs::path &folder)
  {
    for (unsigned int slot = 0; slot < n_slots; ++slot)
    {
      fs::remove_all(slot_in(folder, slot));
      fs::remove_all(slot_in(folder, slot).string() + ".part");
    }
  }
} // namespace semilunar
