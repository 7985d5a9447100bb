// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/output/atomic_file.h>
#include <semilunar/output/vtu_file.h>

#include <deal.II/base/config.h>
#include <deal.II/base/exceptions.h>
#include <deal.II/base/utilities.h>

#include <cstring>
#include <ostream>

#ifdef DEAL_II_WITH_ZLIB
#include <zlib.h>
#endif

namespace semilunar::output
{
  namespace
  {
    using Bytes = std::vector<unsigned char>;

    const char *vtk_type(const std::vector<float> &)
    {
      return "Float32";
    }
    const char *vtk_type(const std::vector<double> &)
    {
      return "Float64";
    }
    const char *vtk_type(const std::vector<std::int32_t> &)
    {
      return "Int32";
    }
    const char *vtk_type(const std::vector<std::int64_t> &)
    {
      return "Int64";
    }
    const char *vtk_type(const std::vector<std::uint8_t> &)
    {
      return "UInt8";
    }

    const char *byte_order()
    {
      const std::uint16_t one = 1;
      unsigned char first_byte;
      std::memcpy(&first_byte, &one, 1);
      return first_byte == 1 ? "LittleEndian" : "BigEndian";
    }

    bool can_compress()
    {
#ifdef DEAL_II_WITH_ZLIB
      return true;
#else
      return false;
#endif
    }

    /// The sizes that VTK wants ahead of the data.
    Bytes header(const std::vector<std::uint64_t> &sizes)
    {
      Bytes bytes(sizes.size() * sizeof(std::uint64_t));
      std::memcpy(bytes.data(), sizes.data(), bytes.size());
      return bytes;
    }

    /// Size and data, encoded as one piece.
    std::string encode_plain(const void *data, const std::size_t size)
    {
      Bytes bytes = header({size});
      const auto *begin = static_cast<const unsigned char *>(data);
      bytes.insert(bytes.end(), begin, begin + size);
      return dealii::Utilities::encode_base64(bytes);
    }

#ifdef DEAL_II_WITH_ZLIB
    /// A single block: number of blocks, block size, size of the last block, compressed size; then
    /// the data, encoded apart from the sizes.
    std::string encode_compressed(const void *data, const std::size_t size)
    {
      uLongf compressed_size = compressBound(size);
      Bytes compressed(compressed_size);
      const int status = compress2(compressed.data(), &compressed_size,
                                   static_cast<const Bytef *>(data), size, Z_BEST_SPEED);
      AssertThrow(status == Z_OK, dealii::ExcInternalError());
      compressed.resize(compressed_size);
      return dealii::Utilities::encode_base64(header({1, size, size, compressed_size})) +
             dealii::Utilities::encode_base64(compressed);
    }
#else
    std::string encode_compressed(const void *data, const std::size_t size)
    {
      return encode_plain(data, size);
    }
#endif

    class Writer
    {
    public:
      Writer(std::ostream &file, const bool compress) : file(file), compress(compress) {}

      void write(const VtuGrid &grid, const double time)
      {
        file << "<?xml version=\"1.0\"?>\n"
             << "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"" << byte_order()
             << "\" header_type=\"UInt64\""
             << (compress ? " compressor=\"vtkZLibDataCompressor\"" : "") << ">\n"
             << "<UnstructuredGrid>\n<FieldData>\n";
        write_array("TimeValue", 1, std::vector<double>{time}, " NumberOfTuples=\"1\"");
        file << "</FieldData>\n<Piece NumberOfPoints=\"" << grid.points.size() / 3
             << "\" NumberOfCells=\"" << grid.types.size() << "\">\n<Points>\n";
        write_array("Points", 3, grid.points);
        file << "</Points>\n<Cells>\n";
        write_array("connectivity", 1, grid.connectivity);
        write_array("offsets", 1, grid.offsets);
        write_array("types", 1, grid.types);
        file << "</Cells>\n";
        write_data("PointData", grid.point_data);
        write_data("CellData", grid.cell_data);
        file << "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
      }

    private:
      template <class Number>
      void write_array(const std::string &name, const unsigned int n_components,
                       const std::vector<Number> &values, const char *more_attributes = "")
      {
        const std::size_t size = values.size() * sizeof(Number);
        file << "<DataArray type=\"" << vtk_type(values) << "\" Name=\"" << name
             << "\" NumberOfComponents=\"" << n_components << '"' << more_attributes
             << " format=\"binary\">\n"
             << (compress ? encode_compressed(values.data(), size)
                          : encode_plain(values.data(), size))
             << "\n</DataArray>\n";
      }

      void write_data(const char *tag, const std::vector<VtuArray> &arrays)
      {
        file << '<' << tag;
        for (const VtuArray &array : arrays)
          if (!array.attribute.empty())
            file << ' ' << array.attribute << "=\"" << array.name << '"';
        file << ">\n";
        for (const VtuArray &array : arrays)
          std::visit([&](const auto &values)
                     { write_array(array.name, array.n_components, values); },
                     array.values);
        file << "</" << tag << ">\n";
      }

      std::ostream &file;
      const bool compress;
    };
  } // namespace

  void write_vtu(const std::string &filename, const VtuGrid &grid, const double time,
                 const bool compress)
  {
    write_atomically(filename, [&](std::ostream &file)
                     { Writer(file, compress && can_compress()).write(grid, time); });
  }
} // namespace semilunar::output
