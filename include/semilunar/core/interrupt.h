// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_core_interrupt_h
#define semilunar_core_interrupt_h

namespace semilunar
{
  /// From now on SIGINT (Ctrl-C) and SIGTERM only raise a flag, so that a run can stop at its next
  /// accepted step with all files in order. A second signal ends the program at once.
  void catch_interrupts();

  /// Whether such a signal has come to any rank. Collective: all ranks get the same answer, so that
  /// they stop together.
  bool interrupted();
} // namespace semilunar

#endif
