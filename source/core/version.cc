// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/version.h>

#include <deal.II/base/config.h>

#include <semilunar_build.h> // configured from contrib/cmake/semilunar_build.h.in

namespace semilunar
{
  std::string version()
  {
    return std::string("semilunar ") + build::version + " (revision " + build::revision +
           "), deal.II " + DEAL_II_PACKAGE_VERSION + ", " + build::type;
  }

  std::string scene_file_folder()
  {
    return build::scene_file_folder;
  }
} // namespace semilunar
