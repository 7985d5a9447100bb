// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_scene_levels_h
#define semilunar_scene_levels_h

#include <semilunar/core/parameter_input.h>
#include <semilunar/core/parameters.h>
#include <semilunar/core/run_context.h>

namespace semilunar::scene
{
  /// What a scene says about its own accuracy: which entries make it finer, and what its quantities
  /// should be.
  struct LevelsParameters
  {
    std::string finer;
    std::string references;
    std::string quantities; ///< names separated by commas; "" for all

    /// Declare the section Levels.
    void add_parameters(dealii::ParameterHandler &prm);
  };

  /// "Surface/Elements * 2" or "Surface/Elements: 4 | 6 | 9": how an entry changes from one level
  /// to the next.
  struct Refinement
  {
    std::string entry;
    char operation;                  ///< '*', '/', '+', or ':' for a list
    double by;                       ///< of a list: nothing
    std::vector<std::string> values; ///< of a list, one for each level

    /// Mesh size or time step of a level, up to a factor.
    double size(unsigned int level) const;
    /// The entry's value at a level: of a list, the one given there; otherwise every number of the
    /// value refined @p level times; whole numbers stay whole if they must.
    std::string apply(const std::string &value, unsigned int level, bool whole_numbers) const;
  };

  /// @throws InputError at Levels/Finer
  std::vector<Refinement> parse_refinements(const std::string &list);

  /// The input of a level: entries changed from what they are in @p declared, which has the values
  /// of level 0.
  /// @throws InputError at Levels/Finer for entries that do not exist or hold no number
  ParameterInput input_of_level(const ParameterInput &input,
                                const std::vector<ParameterDescription> &declared,
                                const std::vector<Refinement> &refinements, unsigned int level);

  /// What a quantity should be.
  struct Reference
  {
    std::string quantity;
    double value;
  };

  /// "name: value (source); ..."
  /// @throws InputError at Levels/References
  std::vector<Reference> parse_references(const std::string &list);

  /// Fill in reference and error of the quantities that have one.
  void compare(RunResults &results, const std::vector<Reference> &references);

  /// @throws InputError at Levels/References if one of them belongs to no quantity
  void check_references(const RunResults &results, const std::vector<Reference> &references);

  /// Whether a comma-separated list of names is empty or holds this one.
  bool is_selected(const std::string &names, const std::string &name);
} // namespace semilunar::scene

#endif
