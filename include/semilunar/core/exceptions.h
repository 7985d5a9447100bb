// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_core_exceptions_h
#define semilunar_core_exceptions_h

#include <stdexcept>
#include <string>

namespace semilunar
{
  /// Something the user gave is wrong: an entry, a file, an argument. Ends the program with exit
  /// code 1.
  class InputError : public std::runtime_error
  {
  public:
    /// @param where   file:line, Section/Entry or --option that holds the mistake
    /// @param value   the offending value as the user wrote it ("" if there is none)
    /// @param problem what is wrong with it
    /// @param remedy  what is allowed, or the nearest valid name
    InputError(const std::string &where, const std::string &value, const std::string &problem,
               const std::string &remedy);

    /// The place alone, as given.
    const std::string &where() const { return place; }

    /// The same mistake at a place that is known better, as in the file and line of an entry.
    InputError at(const std::string &better_place) const;

  private:
    InputError(const std::string &message, const std::string &where);

    std::string place;
  };

  /// The numerics gave up: no convergence, lost element, not a number. Ends the program with exit
  /// code 2.
  class NumericsError : public std::runtime_error
  {
  public:
    /// @param what  what failed
    /// @param when  load factor, time or step at which it failed
    /// @param last_good_state  where the last accepted state lies ("" if there is none)
    NumericsError(const std::string &what, const std::string &when,
                  const std::string &last_good_state);

    /// The same failure where the last good state is known.
    NumericsError after(const std::string &last_good_state) const;

  private:
    explicit NumericsError(const std::string &message);
  };
} // namespace semilunar

#endif
