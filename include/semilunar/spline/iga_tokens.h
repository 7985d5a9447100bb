// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_spline_iga_tokens_h
#define semilunar_spline_iga_tokens_h

#include <string>
#include <string_view>

namespace semilunar::spline
{
  /// Hands out the lines of a text file that are not blank, and the tokens of the present line. All
  /// functions that meet something unexpected throw InputError with file and line.
  class IgaTokens
  {
  public:
    /// @throws InputError if the file cannot be read or is empty
    explicit IgaTokens(const std::string &filename);

    /// Go to the next line that holds something. @return false at the end of the file
    bool next_line();
    /// The same where the file must not end yet.
    void next_line(const std::string &expected);

    bool at_end_of_line() const { return rest.empty(); }
    /// Insist that the line holds nothing more.
    void end_of_line(const char *expected);

    /// The next token of the line.
    std::string_view token(const char *expected);
    /// The next token, which must be this word.
    void keyword(const char *expected);
    /// A finite number in any decimal C form.
    double number(const char *expected);
    /// A whole number >= 0.
    unsigned int index(const char *expected);
    /// A whole number from 0 to bound - 1.
    unsigned int index(const char *expected, unsigned int bound);

    [[noreturn]] void fail(const std::string &value, const std::string &problem,
                           const std::string &remedy) const;
    [[noreturn]] void fail_at(unsigned int line, const std::string &value,
                              const std::string &problem, const std::string &remedy) const;

    unsigned int line_number() const { return line; }
    /// In bytes: no true count in the file can exceed this.
    std::size_t size() const { return text.size(); }

  private:
    std::string filename, text;
    std::size_t position = 0;
    unsigned int line = 0;
    std::string_view rest; ///< of the present line, from the next token on

    void skip_blanks();
    std::string_view next_token();
  };
} // namespace semilunar::spline

#endif
