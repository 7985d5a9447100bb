// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_core_checkpoint_h
#define semilunar_core_checkpoint_h

#include <chrono>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace semilunar
{
  struct CheckpointParameters
  {
    unsigned int step_interval = 0;
    double wall_interval = 600.; ///< [s]
    bool at_interrupt = true;

    /// Declare the section Checkpoints.
    void add_parameters(dealii::ParameterHandler &prm);
  };

  /// Saves the state of a run in its folder and restores it. There are two slots, checkpoint-0 and
  /// checkpoint-1: each new checkpoint is written aside and then takes the place of the older one,
  /// so that whenever the program is killed there is a complete one. All functions are collective.
  class Checkpoints
  {
  public:
    /// @param folder of the run
    /// @param fit    what a checkpoint must have in common with this scene, in words for a user:
    /// "a shell of 484 elements and 1,323 equations"
    Checkpoints(const std::filesystem::path &folder, const CheckpointParameters &parameters,
                const std::string &fit);

    /// A part of the state that all ranks hold alike. The first rank saves it, all ranks load it.
    void add(const std::string &name, const std::function<void(std::ostream &)> &save,
             const std::function<void(std::istream &)> &load);
    /// A part that is distributed over the ranks: saves to, and loads from files of its own in a
    /// folder.
    void add_distributed(const std::string &name,
                         const std::function<void(const std::filesystem::path &)> &save,
                         const std::function<void(const std::filesystem::path &)> &load);
    /// Anything that boost can serialise, the same on all ranks. Include archive.h for it.
    template <typename T>
    void add_object(const std::string &name, T &object);

    /// Whether the intervals ask for a checkpoint at this step, or the run is interrupted.
    bool due(unsigned int step);
    /// @throws InputError if it cannot be written
    void write(unsigned int step, double time);

    /// Load the newest complete checkpoint. @return the step that it was written at
    /// @throws InputError if there is none, or none that fits this scene
    unsigned int restore();

  private:
    struct Part
    {
      std::string name;
      std::function<void(const std::filesystem::path &)> save, load;
    };
    struct Slot;
    std::filesystem::path slot_folder(unsigned int slot) const;
    Slot read_manifest(unsigned int slot) const;

    const std::filesystem::path folder;
    const CheckpointParameters parameters;
    const std::string fit;
    std::vector<Part> parts;
    std::vector<std::string> replicated_files;
    std::chrono::steady_clock::time_point last_write;
    unsigned int next_slot = 0;
  };

  /// Whether a folder holds a checkpoint.
  bool has_checkpoint(const std::filesystem::path &folder);
  /// Remove the checkpoints of an earlier run. Not collective.
  void remove_checkpoints(const std::filesystem::path &folder);
} // namespace semilunar

#endif
