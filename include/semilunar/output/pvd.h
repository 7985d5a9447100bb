// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_output_pvd_h
#define semilunar_output_pvd_h

#include <string>
#include <utility>
#include <vector>

namespace semilunar::output
{
  /// The time series of VTU files that ParaView opens as one data set. The collection on disk is
  /// complete after each added file, so a running or interrupted simulation can be looked at.
  class PvdCollection
  {
  public:
    /// @param filename of the collection (x.pvd); nothing is written yet
    explicit PvdCollection(std::string filename);

    /// Append a file and rewrite the collection.
    /// @param vtu name relative to the folder of the collection
    /// @throws InputError if the collection cannot be written
    void add(double time, const std::string &vtu);

    /// Save or restore which files there are; the collection on disk follows with the next one.
    template <class Archive>
    void serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &records;
    }

  private:
    std::string filename;
    std::vector<std::pair<double, std::string>> records;
  };
} // namespace semilunar::output

#endif
