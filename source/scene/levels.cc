// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/core/nearest_name.h>
#include <semilunar/scene/levels.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <sstream>

namespace semilunar::scene
{
  namespace
  {
    const char *const finer_entry = "Levels/Finer";
    const char *const references_entry = "Levels/References";

    /// The parts of a list, without surrounding blanks; none of an empty list.
    std::vector<std::string> parts(const std::string &list, const char separator)
    {
      std::vector<std::string> result;
      for (const std::string &part : dealii::Utilities::split_string_list(list, separator))
        if (!part.empty())
          result.push_back(part);
      return result;
    }

    /// The first number of a text, which must hold one.
    double first_number(const std::string &text)
    {
      return std::stod(text.substr(text.find_first_of("+-.0123456789")));
    }

    Refinement parse_list(const std::string &entry, const std::string &list)
    {
      Refinement refinement{entry, ':', 0., parts(list, '|')};
      for (const std::string &value : refinement.values)
        if (value.find_first_of("0123456789") == std::string::npos)
          throw InputError(finer_entry, value, "this is no resolution", "give numbers");
      return refinement;
    }

    Refinement parse_refinement(const std::string &text)
    {
      const std::size_t colon = text.find(':');
      if (colon != std::string::npos)
        return parse_list(dealii::Utilities::trim(text.substr(0, colon)), text.substr(colon + 1));
      // The blanks tell a division from the slashes of the entry's path.
      static const std::regex form(R"((.*\S)\s+([*/+])\s+([0-9.]+))");
      std::smatch match;
      if (!std::regex_match(text, match, form))
        throw InputError(finer_entry, text, "this changes no entry",
                         "write 'Section/Entry * 2', 'Section/Entry / 2', 'Section/Entry + 1' or "
                         "'Section/Entry: VALUE | VALUE'");
      const Refinement refinement{match[1], match[2].str()[0], std::stod(match[3]), {}};
      const bool is_sum = refinement.operation == '+';
      if (is_sum ? refinement.by < 1. || refinement.by != std::floor(refinement.by)
                 : refinement.by <= 1.)
        throw InputError(finer_entry, text, "this makes nothing finer",
                         is_sum ? "add a whole number" : "give a factor greater than 1");
      return refinement;
    }

    Reference parse_reference(const std::string &text)
    {
      static const std::regex form(R"(([^:]*\S)\s*:\s*([-+0-9.eE]+)\s*(\(.*\))?)");
      std::smatch match;
      std::size_t used = 0;
      double value = 0.;
      if (std::regex_match(text, match, form))
        value = std::stod(match[2], &used);
      if (used == 0 || used != match[2].str().size())
        throw InputError(references_entry, text, "this is no reference",
                         "write 'quantity: value (source)'");
      return {match[1], value};
    }
  } // namespace

  void LevelsParameters::add_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Levels");
    prm.add_parameter("Finer", finer,
                      "What --levels changes from one run to the next, separated by semicolons: "
                      "'Section/Entry * 2', 'Section/Entry / 2' or 'Section/Entry + 1', applied to "
                      "every number of the entry, or 'Section/Entry: VALUE | VALUE', a value for "
                      "each level. Orders of convergence refer to the first one; '+ 1' counts as a "
                      "refinement by two.");
    prm.add_parameter("References", references,
                      "Exact or published values of quantities, 'name: value (source)', separated "
                      "by semicolons; the summary compares them with the run's.");
    prm.add_parameter("Quantities", quantities,
                      "Names of the quantities that --levels reports, separated by commas; empty: "
                      "all.");
    prm.leave_subsection();
  }

  double Refinement::size(const unsigned int level) const
  {
    if (operation != ':')
      return std::pow(operation == '+' ? std::pow(2., by) : by, -double(level));
    // Numbers of cells grow, steps fall.
    const double first = first_number(values.front()), value = first_number(values[level]);
    return first_number(values.back()) > first ? first / value : value / first;
  }

  std::string Refinement::apply(const std::string &value, const unsigned int level,
                                const bool whole_numbers) const
  {
    if (operation == ':')
      return values[level];
    static const std::regex number(R"([-+]?[0-9.]+([eE][-+]?[0-9]+)?)");
    const double factor = std::pow(by, operation == '/' ? -double(level) : double(level));
    std::ostringstream result;
    result.precision(17);
    std::string::const_iterator rest = value.begin();
    for (std::sregex_iterator match(value.begin(), value.end(), number), end; match != end; ++match)
    {
      const double old = std::stod(match->str());
      const double refined = operation == '+' ? old + level * by : old * factor;
      result << std::string(rest, (*match)[0].first)
             << (whole_numbers ? std::round(refined) : refined);
      rest = (*match)[0].second;
    }
    return result.str() + std::string(rest, value.end());
  }

  std::vector<Refinement> parse_refinements(const std::string &list)
  {
    std::vector<Refinement> refinements;
    for (const std::string &text : parts(list, ';'))
      refinements.push_back(parse_refinement(text));
    if (refinements.empty())
      throw InputError(finer_entry, "", "the scene does not say what finer means",
                       "name the entries to change, as in 'Surface/Elements * 2'");
    const Refinement &first = refinements.front();
    for (unsigned int level = 1; level < first.values.size(); ++level)
      if (!(first.size(level) < first.size(level - 1)))
        throw InputError(finer_entry, first.values[level], "this makes nothing finer",
                         "order the values of " + first.entry + " from coarse to fine");
    return refinements;
  }

  ParameterInput input_of_level(const ParameterInput &input,
                                const std::vector<ParameterDescription> &declared,
                                const std::vector<Refinement> &refinements,
                                const unsigned int level)
  {
    ParameterInput result = input;
    for (const Refinement &refinement : refinements)
    {
      const auto entry =
          std::find_if(declared.begin(), declared.end(),
                       [&](const auto &candidate) { return candidate.path == refinement.entry; });
      if (entry == declared.end())
      {
        std::vector<std::string> paths;
        for (const auto &candidate : declared)
          paths.push_back(candidate.path);
        throw InputError(finer_entry, refinement.entry, "there is no such entry",
                         suggest(refinement.entry, paths));
      }
      if (entry->value.find_first_of("0123456789") == std::string::npos)
        throw InputError(finer_entry, refinement.entry, "the entry holds no number",
                         "name entries that give a resolution");
      if (refinement.operation == ':' && level >= refinement.values.size())
        throw InputError(finer_entry, refinement.entry,
                         "there are values for " + std::to_string(refinement.values.size()) +
                             " levels only",
                         "give more or ask for fewer levels");
      const bool whole_numbers = entry->pattern.find("Integer") != std::string::npos;
      result.replace({entry->path, refinement.apply(entry->value, level, whole_numbers),
                      "level " + std::to_string(level), ""});
    }
    return result;
  }

  std::vector<Reference> parse_references(const std::string &list)
  {
    std::vector<Reference> references;
    for (const std::string &text : parts(list, ';'))
      references.push_back(parse_reference(text));
    return references;
  }

  void compare(RunResults &results, const std::vector<Reference> &references)
  {
    for (Quantity &quantity : results.quantities)
      for (const Reference &reference : references)
        if (quantity.name == reference.quantity)
        {
          quantity.reference = reference.value;
          quantity.error = std::abs(quantity.value - reference.value);
        }
  }

  void check_references(const RunResults &results, const std::vector<Reference> &references)
  {
    std::vector<std::string> names;
    for (const Quantity &quantity : results.quantities)
      names.push_back(quantity.name);
    for (const Reference &reference : references)
      if (std::count(names.begin(), names.end(), reference.quantity) == 0)
        throw InputError(references_entry, reference.quantity, "the run has no such quantity",
                         suggest(reference.quantity, names));
  }

  bool is_selected(const std::string &names, const std::string &name)
  {
    const std::vector<std::string> selected = parts(names, ',');
    return selected.empty() || std::count(selected.begin(), selected.end(), name) > 0;
  }
} // namespace semilunar::scene
