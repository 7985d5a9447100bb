// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/core/first_rank.h>
#include <semilunar/output/time_series.h>

#include <deal.II/base/exceptions.h>

namespace semilunar::output
{
  TimeSeries::TimeSeries(const std::filesystem::path &folder, const std::vector<Column> &columns)
      : filename(folder / "timeseries.csv"), n_columns(columns.size())
  {
    on_first_rank(
        [&]()
        {
          file.open(filename);
          file.precision(12);
          for (std::size_t i = 0; i < columns.size(); ++i)
            file << (i == 0 ? "" : ",") << columns[i].name << " [" << columns[i].unit << "]";
          finish_line();
        });
  }

  void TimeSeries::add_row(const std::vector<double> &values)
  {
    AssertDimension(values.size(), n_columns);
    on_first_rank(
        [&]()
        {
          for (std::size_t i = 0; i < values.size(); ++i)
            file << (i == 0 ? "" : ",") << values[i];
          finish_line();
        });
  }

  void TimeSeries::finish_line()
  {
    file << std::endl;
    if (!file)
      throw InputError(filename.string(), "", "the file cannot be written",
                       "choose an output folder that is writable and has space left");
  }
} // namespace semilunar::output
