// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/core/first_rank.h>

#include <deal.II/base/mpi.h>

#include <memory>

namespace semilunar
{
  void on_first_rank(const std::function<void()> &action)
  {
    std::unique_ptr<InputError> error;
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      try
      {
        action();
      }
      catch (const InputError &e)
      {
        error = std::make_unique<InputError>(e);
      }
    const bool failed = dealii::Utilities::MPI::max(error ? 1 : 0, MPI_COMM_WORLD) == 1;
    if (error)
      throw *error;
    if (failed)
      throw InputError("first rank", "", "failed", "see its message");
  }
} // namespace semilunar
