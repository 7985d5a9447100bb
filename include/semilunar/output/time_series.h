// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_output_time_series_h
#define semilunar_output_time_series_h

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace semilunar::output
{
  /// A table of a run, timeseries.csv unless it has another name: a row for each accepted load or
  /// time step. Rows are on disk once added, so that a running simulation can be plotted. The first
  /// rank writes.
  class TimeSeries
  {
  public:
    struct Column
    {
      std::string name; ///< as in load_factor
      std::string unit; ///< "-" for pure numbers
    };

    /// Create the file and write its header, "load_factor [-],volume [cm^3]".
    /// @param resume leave the file of an earlier run as it is; go_on_at() must follow
    /// @throws InputError on all ranks if the file cannot be written
    TimeSeries(const std::filesystem::path &folder, const std::vector<Column> &columns,
               const std::string &name = "timeseries.csv", bool resume = false);

    /// Append a row, one value for each column; what does not exist is a NaN. Collective.
    /// @throws InputError on all ranks if the row cannot be written (full disk)
    void add_row(const std::vector<double> &values);

    /// Bytes written so far, on the first rank.
    std::uintmax_t size() const { return n_bytes; }
    /// Remove all that comes after the first bytes, and append to them. Collective.
    /// @throws InputError on all ranks if the file is shorter
    void go_on_at(std::uintmax_t size);

  private:
    void write_line(const std::string &line);

    const std::filesystem::path filename;
    const std::size_t n_columns;
    std::ofstream file;
    std::uintmax_t n_bytes = 0;
  };
} // namespace semilunar::output

#endif
