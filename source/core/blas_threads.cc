// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/blas_threads.h>

#include <cstdlib>

#include <dlfcn.h>

namespace semilunar
{
  void use_one_blas_thread()
  {
    if (std::getenv("OPENBLAS_NUM_THREADS") != nullptr)
      return;
    // Looked up at run time: Debian lets the machine choose the BLAS after linking.
    using SetThreads = void (*)(int);
    if (const auto set_threads =
            reinterpret_cast<SetThreads>(dlsym(RTLD_DEFAULT, "openblas_set_num_threads")))
      set_threads(1);
  }
} // namespace semilunar
