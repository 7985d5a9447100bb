// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_core_first_rank_h
#define semilunar_core_first_rank_h

#include <functional>

namespace semilunar
{
  /// Do something on the first MPI rank only, as writing a file. Collective: an InputError there
  /// becomes an InputError on all ranks, so that they stop together.
  void on_first_rank(const std::function<void()> &action);
} // namespace semilunar

#endif
