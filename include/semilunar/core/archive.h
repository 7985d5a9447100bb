// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_core_archive_h
#define semilunar_core_archive_h

#include <semilunar/core/checkpoint.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/serialization/array.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

namespace semilunar
{
  template <typename T>
  void Checkpoints::add_object(const std::string &name, T &object)
  {
    add(
        name,
        [&object](std::ostream &out)
        {
          boost::archive::binary_oarchive archive(out);
          archive << const_cast<const T &>(object);
        },
        [&object](std::istream &in)
        {
          boost::archive::binary_iarchive archive(in);
          archive >> object;
        });
  }
} // namespace semilunar

#endif
