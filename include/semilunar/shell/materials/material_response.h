// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_shell_materials_material_response_h
#define semilunar_shell_materials_material_response_h

#include <semilunar/shell/materials/thickness_point.h>

namespace semilunar::shell
{
  /// What a plane-stress material law returns at a point. A law is a struct with a member
  /// `MaterialResponse evaluate(const ThicknessPoint &) const`, inlined into the thickness
  /// integration (what the caller does not use of the response costs nothing), and a constant
  /// `admits_any_deformation`: whether the law makes sense where C is not positive definite.
  struct MaterialResponse
  {
    double energy;        ///< strain energy per undeformed volume
    Symmetric stress;     ///< second Piola-Kirchhoff stress S^ab
    SymmetricMap tangent; ///< dS^ab / dE_cd
  };
} // namespace semilunar::shell

#endif
