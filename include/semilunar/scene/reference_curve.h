// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_scene_reference_curve_h
#define semilunar_scene_reference_curve_h

#include <semilunar/core/run_context.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace semilunar::scene
{
  /// The states of a run: load factor and recorded quantities, in order.
  struct LoadPath
  {
    std::vector<std::string> names; ///< of the quantities
    std::vector<double> loads;
    std::vector<std::vector<double>> values; ///< [state][quantity]
  };

  /// How a published point is compared with a load path.
  enum class Comparison
  {
    at_load,  ///< with the state at its load factor
    with_path ///< with the nearest point of the path, which may turn back
  };

  /// Published values of quantities over the load factor, and how far a run is from them.
  class ReferenceCurve
  {
  public:
    /// A file with the columns quantity, load_factor, value, source. A quantity "-tip_ux" is
    /// tip_ux with the other sign.
    /// @throws InputError naming the line of the file
    explicit ReferenceCurve(const std::string &file);

    /// All load factors above 0 and up to 1, each once, in order.
    std::vector<double> load_factors() const;

    /// @throws InputError naming the line if a quantity is none of these
    void check(const std::vector<std::string> &names) const;

    /// Compare all points that the path reaches. Deviations refer to the largest value of the
    /// quantity in the file; along a path, load factors to the largest one there. Writes
    /// deviation.csv (collective; the first rank writes) and adds the quantities
    /// largest_deviation, mean_deviation and points_within_1_percent, a fraction.
    void compare(const LoadPath &path, Comparison comparison, const std::filesystem::path &folder,
                 RunResults &results) const;

  private:
    struct Row
    {
      std::string quantity;
      double sign, load, value;
      std::string where; ///< file:line
    };
    std::vector<Row> rows;

    /// What deviations refer to: the largest value of each quantity and the largest load factor.
    struct Scales
    {
      std::map<std::string, double> values;
      double load = 0.;
    };
    Scales largest() const;

    /// What a row is compared with; NaN if the path does not come that far.
    struct Found
    {
      double value, deviation;
    };
    Found find(const Row &row, const LoadPath &path, Comparison comparison,
               const Scales &scales) const;
  };
} // namespace semilunar::scene

#endif
