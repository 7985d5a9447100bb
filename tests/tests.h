// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_tests_h
#define semilunar_tests_h

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <string>

namespace semilunar::tests
{
  /// The file that is compared with the reference of the test.
  inline std::ostream &log()
  {
    static std::ofstream file("output");
    file << std::setprecision(8);
    return file;
  }

  /// Log whether an error is within its bound; a failed check prints the figure and fails the test.
  inline void check(const std::string &what, const double error, const double bound)
  {
    if (std::abs(error) <= bound) // false for a NaN as well
      log() << what << ": within " << bound << std::endl;
    else
    {
      log() << what << ": " << error << " EXCEEDS " << bound << std::endl;
      std::fprintf(stderr, "%s: %g exceeds %g\n", what.c_str(), error, bound);
      std::exit(1);
    }
  }
} // namespace semilunar::tests

#endif
