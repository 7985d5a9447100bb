// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_output_atomic_file_h
#define semilunar_output_atomic_file_h

#include <functional>
#include <iosfwd>
#include <string>

namespace semilunar::output
{
  /// Write a file so that readers see either the old contents or all of the new: under another name
  /// in the same folder, renamed at the end.
  /// @throws InputError naming the file if it cannot be created, written (full disk) or replaced.
  void write_atomically(const std::string &filename,
                        const std::function<void(std::ostream &)> &write);
} // namespace semilunar::output

#endif
