// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_shell_materials_symmetric_tensors_h
#define semilunar_shell_materials_symmetric_tensors_h

#include <semilunar/shell/section.h>

namespace semilunar::shell
{
  /// A linear map between symmetric in-plane tensors with major and minor symmetries: components
  /// 1111, 1122, 1112, 2222, 2212, 1212.
  using SymmetricMap = std::array<double, 6>;

  inline double determinant(const Symmetric &A)
  {
    return A[0] * A[1] - A[2] * A[2];
  }

  /// A^ab B_ab
  inline double contract(const Symmetric &A, const Symmetric &B)
  {
    return A[0] * B[0] + A[1] * B[1] + 2. * A[2] * B[2];
  }

  /// A^ab A^cd
  inline SymmetricMap outer_product(const Symmetric &A)
  {
    return {{A[0] * A[0], A[0] * A[1], A[0] * A[2], A[1] * A[1], A[1] * A[2], A[2] * A[2]}};
  }

  /// A^ab B^cd + B^ab A^cd
  inline SymmetricMap symmetric_product(const Symmetric &A, const Symmetric &B)
  {
    return {{2. * A[0] * B[0], A[0] * B[1] + A[1] * B[0], A[0] * B[2] + A[2] * B[0],
             2. * A[1] * B[1], A[1] * B[2] + A[2] * B[1], 2. * A[2] * B[2]}};
  }

  /// A^ac A^bd + A^ad A^bc
  inline SymmetricMap exchange_product(const Symmetric &A)
  {
    return {{2. * A[0] * A[0], 2. * A[2] * A[2], 2. * A[0] * A[2], 2. * A[1] * A[1],
             2. * A[1] * A[2], A[0] * A[1] + A[2] * A[2]}};
  }
} // namespace semilunar::shell

#endif
