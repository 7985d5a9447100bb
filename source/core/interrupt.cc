// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/interrupt.h>

#include <deal.II/base/mpi.h>

#include <csignal>

namespace semilunar
{
  namespace
  {
    volatile std::sig_atomic_t signal_received = 0;

    extern "C" void remember_signal(const int signal)
    {
      signal_received = 1;
      std::signal(signal, SIG_DFL);
    }
  } // namespace

  void catch_interrupts()
  {
    std::signal(SIGINT, remember_signal);
    std::signal(SIGTERM, remember_signal);
  }

  bool interrupted()
  {
    return dealii::Utilities::MPI::max(signal_received != 0 ? 1 : 0, MPI_COMM_WORLD) == 1;
  }
} // namespace semilunar
