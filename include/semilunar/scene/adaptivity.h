// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_scene_adaptivity_h
#define semilunar_scene_adaptivity_h

#include <semilunar/scene/static_analysis.h>
#include <semilunar/scene/valve_source.h>

namespace semilunar::scene
{
  /// How often and how much leaflets are refined where their solution asks for it.
  struct AdaptivityParameters
  {
    unsigned int n_rounds = 0; ///< 0: never
    double share = 0.6;        ///< of the estimated error, squared, that marked elements have

    /// Declare the section Adaptivity.
    void add_parameters(dealii::ParameterHandler &prm);

    /// @throws InputError for an analysis or a design that this does not go with
    void check(const StaticAnalysis &analysis, const valve::Design &design) const;
  };

  /// Quantities of a solution that a kind of scene has besides those of all shells.
  using AddQuantities =
      std::function<void(ShellModel &, const shell::ControlVectors &, RunResults &)>;

  /// Solve, and as often as the parameters ask for: estimate the error of each element, halve those
  /// with the largest ones, and go on from the same state on the finer mesh. Rounds but the last
  /// write to folders round-0, round-1, ... of their own; adaptivity.csv has a row for each,
  /// elements.csv the mesh of the last one. Quantities are those of the last.
  void solve_adaptively(const ValveSource &source, const StaticAnalysis &analysis,
                        const AdaptivityParameters &parameters, const AddQuantities &add_quantities,
                        RunContext &context);
} // namespace semilunar::scene

#endif
