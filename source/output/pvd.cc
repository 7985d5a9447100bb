// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/output/atomic_file.h>
#include <semilunar/output/pvd.h>

#include <deal.II/base/data_out_base.h>

#include <iomanip>
#include <limits>
#include <ostream>

namespace semilunar::output
{
  PvdCollection::PvdCollection(std::string filename) : filename(std::move(filename)) {}

  void PvdCollection::add(const double time, const std::string &vtu)
  {
    records.emplace_back(time, vtu);
    write_atomically(filename,
                     [this](std::ostream &file)
                     {
                       file << std::setprecision(std::numeric_limits<double>::max_digits10);
                       dealii::DataOutBase::write_pvd_record(file, records);
                     });
  }
} // namespace semilunar::output
