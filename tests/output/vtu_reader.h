// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_tests_vtu_reader_h
#define semilunar_tests_vtu_reader_h

#include <deal.II/base/exceptions.h>
#include <deal.II/base/utilities.h>

#include <cstdint>
#include <cstring>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>
#include <zlib.h>

namespace semilunar::tests
{
  inline std::string contents(const std::string &filename)
  {
    std::ifstream file(filename, std::ios::binary);
    AssertThrow(file, dealii::ExcFileNotOpen(filename));
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
  }

  /// The arrays of a VTU file with base64 data of 64 bit headers, by name.
  class VtuReader
  {
  public:
    explicit VtuReader(const std::string &filename)
        : text(contents(filename)), compressed(text.find("compressor=") != std::string::npos)
    {
    }

    bool has(const std::string &words) const { return text.find(words) != std::string::npos; }

    /// All numbers of an array, whatever their type in the file.
    std::vector<double> array(const std::string &name) const
    {
      const std::size_t tag = text.rfind("<DataArray", text.find(" Name=\"" + name + '"'));
      AssertThrow(tag != std::string::npos, dealii::ExcMessage("no array " + name));
      const std::size_t begin = text.find('\n', tag) + 1;
      const std::string type = text.substr(tag, begin - tag);
      const auto bytes = decode(text.substr(begin, text.find('\n', begin) - begin));
      if (type.find("Float32") != std::string::npos)
        return numbers<float>(bytes);
      if (type.find("Float64") != std::string::npos)
        return numbers<double>(bytes);
      if (type.find("Int64") != std::string::npos)
        return numbers<std::int64_t>(bytes);
      if (type.find("UInt8") != std::string::npos)
        return numbers<std::uint8_t>(bytes);
      return numbers<std::int32_t>(bytes);
    }

  private:
    using Bytes = std::vector<unsigned char>;

    Bytes decode(const std::string &base64) const
    {
      constexpr std::size_t header_bytes = 4 * sizeof(std::uint64_t), header_characters = 44;
      if (!compressed)
      {
        const Bytes all = dealii::Utilities::decode_base64(base64);
        const std::uint64_t size = static_cast<std::uint64_t>(numbers<std::int64_t>(all)[0]);
        AssertThrow(all.size() >= 8 + size, dealii::ExcMessage("array is too short"));
        return Bytes(all.begin() + 8, all.begin() + 8 + size);
      }
      Bytes head = dealii::Utilities::decode_base64(base64.substr(0, header_characters));
      head.resize(header_bytes);
      const std::vector<double> sizes = numbers<std::int64_t>(head);
      AssertThrow(sizes[0] == 1 && sizes[1] == sizes[2], dealii::ExcMessage("not a single block"));
      const Bytes block = dealii::Utilities::decode_base64(base64.substr(header_characters));
      Bytes result(sizes[1]);
      uLongf n = result.size();
      AssertThrow(uncompress(result.data(), &n, block.data(), sizes[3]) == Z_OK && n == sizes[1],
                  dealii::ExcMessage("corrupt block"));
      return result;
    }

    template <class Number>
    static std::vector<double> numbers(const Bytes &bytes)
    {
      std::vector<Number> values(bytes.size() / sizeof(Number));
      std::memcpy(values.data(), bytes.data(), values.size() * sizeof(Number));
      return std::vector<double>(values.begin(), values.end());
    }

    const std::string text;
    const bool compressed;
  };
} // namespace semilunar::tests

#endif
