// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_core_version_h
#define semilunar_core_version_h

#include <string>

namespace semilunar
{
  /// "semilunar 0.1.0 (revision 1a2b3c4), deal.II 9.4.1, Release": what results depend on.
  std::string version();

  /// The folder of scene files in the source tree that this program was built from.
  std::string scene_file_folder();
} // namespace semilunar

#endif
