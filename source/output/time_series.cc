// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/core/first_rank.h>
#include <semilunar/output/time_series.h>

#include <deal.II/base/exceptions.h>

#include <sstream>

namespace semilunar::output
{
  namespace
  {
    constexpr int digits = 12;
  }

  TimeSeries::TimeSeries(const std::filesystem::path &folder, const std::vector<Column> &columns,
                         const std::string &name, const bool resume)
      : filename(folder / name), n_columns(columns.size())
  {
    if (resume)
      return;
    std::string header;
    for (const Column &column : columns)
      header += (header.empty() ? "" : ",") + column.name + " [" + column.unit + "]";
    on_first_rank(
        [&]()
        {
          file.open(filename);
          write_line(header);
        });
  }

  void TimeSeries::add_row(const std::vector<double> &values)
  {
    AssertDimension(values.size(), n_columns);
    std::ostringstream row;
    row.precision(digits);
    for (std::size_t i = 0; i < values.size(); ++i)
      row << (i == 0 ? "" : ",") << values[i];
    on_first_rank([&]() { write_line(row.str()); });
  }

  void TimeSeries::go_on_at(const std::uintmax_t size)
  {
    on_first_rank(
        [&]()
        {
          std::error_code no_file;
          const auto found = std::filesystem::file_size(filename, no_file);
          if (no_file || found < size)
            throw InputError("--restart", filename.string(),
                             "the file is shorter than it was at the checkpoint",
                             "run without --restart");
          std::filesystem::resize_file(filename, size);
          file.open(filename, std::ios::app);
          n_bytes = size;
        });
  }

  void TimeSeries::write_line(const std::string &line)
  {
    file << line << std::endl;
    n_bytes += line.size() + 1;
    if (!file)
      throw InputError(filename.string(), "", "the file cannot be written",
                       "choose an output folder that is writable and has space left");
  }
} // namespace semilunar::output
