// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_scene_displacement_limits_h
#define semilunar_scene_displacement_limits_h

#include <string>
#include <vector>

namespace semilunar::scene
{
  /// Displacements of probes that end a run.
  class DisplacementLimits
  {
  public:
    /// @param list  "tip_uz: 3; side_ux: 1"
    /// @param names of the components that are recorded
    /// @throws InputError for the entry Solver/Stop at
    DisplacementLimits(const std::string &list, const std::vector<std::string> &names);

    /// Whether one of the recorded components is as large in amount as its limit.
    bool reached(const std::vector<double> &values) const;

  private:
    struct Limit
    {
      unsigned int component;
      double value;
    };
    std::vector<Limit> limits;
  };
} // namespace semilunar::scene

#endif
