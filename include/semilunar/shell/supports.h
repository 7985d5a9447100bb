// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_shell_supports_h
#define semilunar_shell_supports_h

#include <semilunar/shell/equations.h>
#include <semilunar/shell/location.h>

#include <deal.II/base/parameter_handler.h>

namespace semilunar::shell
{
  /// The list of supports, in the words of a scene file.
  struct SupportParameters
  {
    std::string supports;
    bool may_move_rigidly = false; ///< pieces that are not held: for inertia only

    void add_parameters(dealii::ParameterHandler &prm);
  };

  /// Build the equations of a surface under these supports.
  /// @throws InputError for an unknown verb or place, and for a rigid motion of a piece of the
  /// surface that the supports leave free (unless it may)
  Equations make_equations(const spline::Surface &surface, const SupportParameters &parameters);

  /// Number of independent rigid motions (0 to 6) of each connected piece that the equations leave
  /// free, alone or together with pieces that are tied to it.
  std::vector<unsigned int> free_rigid_motions(const spline::Surface &surface,
                                               const Equations &equations);
} // namespace semilunar::shell

#endif
