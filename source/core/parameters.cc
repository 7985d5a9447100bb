// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/core/nearest_name.h>
#include <semilunar/core/parameters.h>

#include <deal.II/base/utilities.h>

#include <boost/property_tree/json_parser.hpp>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <set>
#include <sstream>

namespace semilunar
{
  namespace
  {
    using Tree = boost::property_tree::ptree;

    void collect(const Tree &tree, const std::string &section,
                 std::vector<ParameterDescription> &list)
    {
      for (const auto &[name, child] : tree)
      {
        const std::string path = section + (section.empty() ? "" : "/") + name;
        const auto pattern = child.find("pattern_description");
        if (pattern == child.not_found())
          collect(child, path, list);
        else
          list.push_back({path, child.get<std::string>("value"),
                          child.get<std::string>("default_value"),
                          child.get<std::string>("documentation"), pattern->second.data()});
      }
    }

    std::string section_of(const std::string &path)
    {
      const auto slash = path.rfind('/');
      return slash == std::string::npos ? "" : path.substr(0, slash);
    }

    std::string name_of(const std::string &path)
    {
      return path.substr(path.rfind('/') + 1);
    }

    /// All sections with declared entries, and the sections around these.
    std::set<std::string> sections_of(const std::vector<ParameterDescription> &declared)
    {
      std::set<std::string> sections;
      for (const ParameterDescription &entry : declared)
        for (std::string s = section_of(entry.path); !s.empty(); s = section_of(s))
          sections.insert(s);
      return sections;
    }

    void check_section(const std::string &path, const std::string &where,
                       const std::vector<ParameterDescription> &declared,
                       const KindsWithSection &kinds_with_section)
    {
      const std::set<std::string> sections = sections_of(declared);
      if (path.empty() || sections.count(path) > 0)
        return;
      const std::vector<std::string> kinds =
          kinds_with_section ? kinds_with_section(path) : std::vector<std::string>();
      std::string remedy = "remove it: it belongs to scenes of kind " + quoted_list(kinds);
      if (kinds.empty())
        remedy = suggest(path, {sections.begin(), sections.end()});
      throw InputError(where + ", section " + path, "", "this kind of scene has no such section",
                       remedy);
    }

    /// What to do about an entry that does not exist.
    std::string remedy_for_unknown(const std::string &path,
                                   const std::vector<ParameterDescription> &declared)
    {
      std::vector<std::string> siblings, all;
      for (const ParameterDescription &entry : declared)
      {
        all.push_back(entry.path);
        if (section_of(entry.path) == section_of(path))
          siblings.push_back(name_of(entry.path));
        else if (name_of(entry.path) == name_of(path))
          return "there is '" + entry.path + "': put it into that section";
      }
      const std::string sibling = nearest_name(name_of(path), siblings);
      if (!sibling.empty())
        return "did you mean '" + sibling + "'?";
      for (const ParameterDescription &entry : declared)
        if (!nearest_name(name_of(path), {name_of(entry.path)}).empty())
          return "did you mean '" + entry.path + "', in another section?";
      return "known here are " + quoted_list(siblings.empty() ? all : siblings);
    }

    std::string absolute_if_file(const ParameterInput::Assignment &assignment,
                                 const std::string &pattern)
    {
      if (pattern.find("[FileName (Type: input)]") != 0 || assignment.value.empty())
        return assignment.value;
      // operator/ keeps a name that is absolute already
      return (std::filesystem::path(assignment.directory) / assignment.value)
          .lexically_normal()
          .string();
    }

    void set_entry(const std::string &path, const std::string &value, dealii::ParameterHandler &prm)
    {
      const auto sections = dealii::Utilities::split_string_list(section_of(path), '/');
      for (const std::string &section : sections)
        prm.enter_subsection(section);
      prm.set(name_of(path), value);
      for (std::size_t i = 0; i < sections.size(); ++i)
        prm.leave_subsection();
    }
  } // namespace

  dealii::Patterns::Double positive_number()
  {
    return dealii::Patterns::Double(std::numeric_limits<double>::min());
  }

  std::vector<ParameterDescription> list_parameters(const dealii::ParameterHandler &prm)
  {
    std::stringstream json;
    prm.print_parameters(json, dealii::ParameterHandler::JSON |
                                   dealii::ParameterHandler::KeepDeclarationOrder);
    Tree tree;
    boost::property_tree::read_json(json, tree);
    std::vector<ParameterDescription> list;
    collect(tree, "", list);
    return list;
  }

  void assign(const ParameterInput &input, dealii::ParameterHandler &prm,
              const KindsWithSection &kinds_with_section)
  {
    const std::vector<ParameterDescription> declared = list_parameters(prm);
    for (const ParameterInput::SectionStart &section : input.sections())
      check_section(section.path, section.where, declared, kinds_with_section);
    for (const ParameterInput::Assignment &assignment : input.assignments())
    {
      const std::string place = assignment.where + ", " + assignment.path;
      check_section(section_of(assignment.path), assignment.where, declared, kinds_with_section);
      const auto entry = std::find_if(declared.begin(), declared.end(),
                                      [&](const auto &e) { return e.path == assignment.path; });
      if (entry == declared.end())
        throw InputError(place, assignment.value, "there is no such entry",
                         remedy_for_unknown(assignment.path, declared));
      try
      {
        set_entry(assignment.path, absolute_if_file(assignment, entry->pattern), prm);
      }
      catch (const dealii::ExceptionBase &)
      {
        throw InputError(place, assignment.value,
                         assignment.value.empty() ? "there is no value"
                                                  : "the value is not allowed",
                         "give " + allowed_values(entry->pattern));
      }
    }
  }
} // namespace semilunar
