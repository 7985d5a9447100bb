// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>

namespace semilunar
{
  InputError::InputError(const std::string &where, const std::string &value,
                         const std::string &problem, const std::string &remedy)
      : std::runtime_error(where + (value.empty() ? "" : " = \"" + value + "\"") + ": " + problem +
                           (remedy.empty() ? "" : "; " + remedy)),
        place(where)
  {
  }

  InputError::InputError(const std::string &message, const std::string &where)
      : std::runtime_error(message), place(where)
  {
  }

  InputError InputError::at(const std::string &better_place) const
  {
    return InputError(better_place + std::string(what()).substr(place.size()), better_place);
  }

  NumericsError::NumericsError(const std::string &what, const std::string &when,
                               const std::string &last_good_state)
      : std::runtime_error(
            what + " at " + when +
            (last_good_state.empty() ? "" : "; the last good state is in " + last_good_state))
  {
  }

  NumericsError::NumericsError(const std::string &message) : std::runtime_error(message) {}

  NumericsError NumericsError::after(const std::string &last_good_state) const
  {
    return NumericsError(std::string(what()) + "; the last good state is in " + last_good_state);
  }
} // namespace semilunar
