// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_core_blas_threads_h
#define semilunar_core_blas_threads_h

namespace semilunar
{
  /// Let the BLAS compute with one thread if it is OpenBLAS. The dense blocks of a shell's sparse
  /// factorisation are too small for more: its threads then mostly wait for each other, at the cost
  /// of those that assemble (measured in doc/results/linear-solvers.md). An environment that sets
  /// OPENBLAS_NUM_THREADS is respected.
  void use_one_blas_thread();
} // namespace semilunar

#endif
