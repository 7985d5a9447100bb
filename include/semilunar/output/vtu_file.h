// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_output_vtu_file_h
#define semilunar_output_vtu_file_h

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace semilunar::output
{
  /// Numbers attached to the points or cells of a grid, tuple by tuple.
  struct VtuArray
  {
    std::string name;
    unsigned int n_components = 1;
    std::variant<std::vector<float>, std::vector<double>, std::vector<std::int32_t>,
                 std::vector<std::int64_t>, std::vector<std::uint8_t>>
        values;
    /// The data set attribute of VTK that the array is ("RationalWeights", "HigherOrderDegrees"),
    /// empty for a plain field.
    std::string attribute;
  };

  /// An unstructured grid as VTK knows it.
  struct VtuGrid
  {
    std::vector<double> points;             ///< x, y, z of each point
    std::vector<std::int64_t> connectivity; ///< the points of each cell, one cell after the other
    std::vector<std::int64_t> offsets;      ///< of each cell: where its points end in connectivity
    std::vector<std::uint8_t> types;        ///< VTK's number of each cell's type
    std::vector<VtuArray> point_data, cell_data;
  };

  /// Write an XML VTU file with base64 arrays, each compressed by zlib at its fastest level if
  /// @p compress (and if deal.II was built with zlib). @throws InputError if it cannot be written.
  void write_vtu(const std::string &filename, const VtuGrid &grid, double time, bool compress);
} // namespace semilunar::output

#endif
