// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/spline/iga_tokens.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace semilunar::spline
{
  namespace
  {
    constexpr const char *blanks = " \t\r\f\v";

    std::string contents(const std::string &filename)
    {
      std::ifstream file(filename, std::ios::binary);
      std::ostringstream text;
      // a directory opens, but does not read
      if (file && file.peek() != std::ifstream::traits_type::eof())
        text << file.rdbuf();
      if (!file)
        throw InputError(filename, "", "the file cannot be read, or is empty",
                         "give the name of an .iga file");
      return text.str();
    }
  } // namespace

  IgaTokens::IgaTokens(const std::string &filename) : filename(filename), text(contents(filename))
  {
  }

  void IgaTokens::skip_blanks()
  {
    rest.remove_prefix(std::min(rest.find_first_not_of(blanks), rest.size()));
  }

  bool IgaTokens::next_line()
  {
    while (position < text.size())
    {
      const std::size_t end = std::min(text.find('\n', position), text.size());
      rest = std::string_view(text).substr(position, end - position);
      position = end + 1;
      ++line;
      skip_blanks();
      if (!rest.empty())
        return true;
    }
    return false;
  }

  void IgaTokens::next_line(const std::string &expected)
  {
    if (!next_line())
      fail("", "the file ends early", "expected " + expected);
  }

  void IgaTokens::end_of_line(const char *expected)
  {
    if (!rest.empty())
      fail(std::string(next_token()), "too many entries on the line",
           std::string("expected ") + expected);
  }

  std::string_view IgaTokens::next_token()
  {
    const std::size_t end = std::min(rest.find_first_of(blanks), rest.size());
    const std::string_view result = rest.substr(0, end);
    rest.remove_prefix(end);
    skip_blanks();
    return result;
  }

  std::string_view IgaTokens::token(const char *expected)
  {
    if (rest.empty())
      fail("", "the line ends early", std::string("expected ") + expected);
    return next_token();
  }

  void IgaTokens::keyword(const char *expected)
  {
    const std::string_view word = token(expected);
    if (word != expected)
      fail(std::string(word), "unexpected keyword", std::string("expected ") + expected);
  }

  double IgaTokens::number(const char *expected)
  {
    const std::string_view word = token(expected);
    // a plus is valid in C, but not for from_chars
    const std::size_t sign = word.size() > 1 && word[0] == '+' && word[1] != '-' ? 1 : 0;
    const char *const end = word.data() + word.size();
    double result = 0.;
    const auto [stop, error] = std::from_chars(word.data() + sign, end, result);
    if (error == std::errc::invalid_argument || stop != end)
      fail(std::string(word), "not a number", std::string("expected ") + expected);
    if (error == std::errc::result_out_of_range) // tell overflow from harmless underflow
      result = std::strtod(std::string(word).c_str(), nullptr);
    if (!std::isfinite(result))
      fail(std::string(word), "the number is not finite", "");
    return result;
  }

  unsigned int IgaTokens::index(const char *expected)
  {
    const std::string_view word = token(expected);
    const char *const end = word.data() + word.size();
    unsigned int result = 0;
    const auto [stop, error] = std::from_chars(word.data(), end, result);
    if (error != std::errc() || stop != end)
      fail(std::string(word), "not a whole number >= 0", std::string("expected ") + expected);
    return result;
  }

  unsigned int IgaTokens::index(const char *expected, const unsigned int bound)
  {
    const unsigned int result = index(expected);
    if (result >= bound)
      fail(std::to_string(result), std::string("out of range for ") + expected,
           "there are " + std::to_string(bound) + ", counted from 0");
    return result;
  }

  void IgaTokens::fail(const std::string &value, const std::string &problem,
                       const std::string &remedy) const
  {
    fail_at(line, value, problem, remedy);
  }

  void IgaTokens::fail_at(const unsigned int line, const std::string &value,
                          const std::string &problem, const std::string &remedy) const
  {
    throw InputError(filename + ":" + std::to_string(line), value, problem, remedy);
  }
} // namespace semilunar::spline
