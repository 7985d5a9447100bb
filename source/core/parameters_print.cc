// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/nearest_name.h>
#include <semilunar/core/parameters.h>

#include <deal.II/base/utilities.h>

#include <regex>
#include <set>
#include <sstream>

namespace semilunar
{
  namespace
  {
    // As deal.II prints the bounds of numbers.
    const char *const smallest_positive = "2.22507e-308";
    const std::set<std::string> no_bound = {"", "-MAX_DOUBLE", "MAX_DOUBLE", "2147483647",
                                            "-2147483648"};

    std::string range(const std::string &what, const std::string &low, const std::string &high)
    {
      std::string text = what;
      if (low == smallest_positive)
        text += " greater than 0";
      else if (no_bound.count(low) == 0)
        text += " of at least " + low;
      if (no_bound.count(high) == 0)
        text += std::string(text == what ? " of" : " and") + " at most " + high;
      return text;
    }

    std::string list_in_words(const std::string &item, const std::string &low,
                              const std::string &high, const std::string &separator)
    {
      std::string count = "any number of";
      if (low == high)
        count = low;
      else if (high != "4294967295")
        count = low + " to " + high;
      else if (low != "0")
        count = "at least " + low;
      return count + " items separated by '" + separator + "', each " + allowed_values(item);
    }

    std::string escape_table_cell(const std::string &text)
    {
      return std::regex_replace(text, std::regex("\\|"), "\\|");
    }

    void print_markdown(const dealii::ParameterHandler &prm, std::ostream &out)
    {
      std::string section = "none yet";
      for (const ParameterDescription &entry : list_parameters(prm))
      {
        const auto slash = entry.path.rfind('/');
        const std::string here =
            slash == std::string::npos ? "Top level" : entry.path.substr(0, slash);
        if (here != section)
          out << (section == "none yet" ? "" : "\n") << "### " << here << "\n\n"
              << "| entry | default | meaning | allowed |\n|---|---|---|---|\n";
        section = here;
        out << "| " << entry.path.substr(slash + 1) << " | "
            << (entry.value.empty() ? "" : "`" + escape_table_cell(entry.value) + "`") << " | "
            << escape_table_cell(entry.documentation) << " | "
            << escape_table_cell(allowed_values(entry.pattern)) << " |\n";
      }
    }
  } // namespace

  std::string allowed_values(const std::string &pattern)
  {
    std::smatch match;
    if (std::regex_match(pattern, match, std::regex("\\[Double (\\S+)\\.\\.\\.(\\S+) .*\\]")))
      return range("a number", match[1], match[2]);
    if (std::regex_match(pattern, match,
                         std::regex("\\[Integer(?: range (\\S+)\\.\\.\\.(\\S+) .*)?\\]")))
      return range("a whole number", match[1], match[2]);
    if (std::regex_match(pattern, match, std::regex("\\[Selection (.*?) *\\]")))
      return "one of " + quoted_list(dealii::Utilities::split_string_list(match[1], '|'));
    if (std::regex_match(pattern, match,
                         std::regex("\\[List of <(.*)> of length (\\d+)\\.\\.\\.(\\d+) "
                                    "\\(inclusive\\)(?: separated by <(.*)>)?\\]")))
      return list_in_words(match[1], match[2], match[3], match[4].matched ? match[4].str() : ",");
    if (pattern == "[Bool]")
      return "true or false";
    if (pattern.find("[FileName") == 0)
      return "the name of a file";
    if (pattern.find("[Anything") == 0)
      return "any text";
    return pattern;
  }

  void print_parameters(const dealii::ParameterHandler &prm, const ParameterFormat format,
                        std::ostream &out)
  {
    using Handler = dealii::ParameterHandler;
    if (format == ParameterFormat::prm)
      prm.print_parameters(out, Handler::PRM | Handler::KeepDeclarationOrder);
    else if (format == ParameterFormat::json)
      prm.print_parameters(out, Handler::JSON | Handler::KeepDeclarationOrder);
    else
      print_markdown(prm, out);
  }
} // namespace semilunar
