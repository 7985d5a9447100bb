// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_core_units_h
#define semilunar_core_units_h

namespace semilunar
{
  /// One millimetre of mercury in dyn/cm^2 (the program computes in CGS units).
  constexpr double mmHg = 1333.22;
} // namespace semilunar

#endif
