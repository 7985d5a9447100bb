// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/output/atomic_file.h>

#include <cstdio>
#include <fstream>

namespace semilunar::output
{
  void write_atomically(const std::string &filename,
                        const std::function<void(std::ostream &)> &write)
  {
    const std::string partial = filename + ".part";
    std::ofstream file(partial, std::ios::binary);
    if (file)
      write(file);
    file.close();
    if (!file || std::rename(partial.c_str(), filename.c_str()) != 0)
    {
      std::remove(partial.c_str());
      throw InputError(filename, "", "the file cannot be written",
                       "choose an output folder that exists, is writable and has space left");
    }
  }
} // namespace semilunar::output
