// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_flow_lanes_h
#define semilunar_flow_lanes_h

#include <cmath>

namespace semilunar::flow
{
  /// Cells that are worked on at once, one in each lane of a SIMD register.
  constexpr unsigned int n_lanes = 8;

  /// One number of each cell of a batch. Arithmetic works lane by lane, with plain numbers for all
  /// lanes (vector extension of GCC and Clang; lowered to what the processor has). deal.II's
  /// VectorizedArray is as wide as the library was compiled for, which is one number in Debian's.
  using Lanes = double __attribute__((vector_size(n_lanes * sizeof(double))));

  inline Lanes square_root(const Lanes &a)
  {
    Lanes root = {};
    for (unsigned int lane = 0; lane < n_lanes; ++lane)
      root[lane] = std::sqrt(a[lane]);
    return root;
  }
} // namespace semilunar::flow

#endif
