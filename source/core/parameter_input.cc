// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/core/nearest_name.h>
#include <semilunar/core/parameter_input.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace semilunar
{
  namespace
  {
    /// Without surrounding blanks, inner runs of blanks replaced by one (as deal.II does).
    std::string normalise(const std::string &text)
    {
      std::istringstream words(text);
      std::string word, result;
      while (words >> word)
        result += (result.empty() ? "" : " ") + word;
      return result;
    }

    std::string trim(const std::string &text)
    {
      const char *const blanks = " \t\r";
      const auto begin = text.find_first_not_of(blanks);
      if (begin == std::string::npos)
        return "";
      return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
    }

    std::string join(const std::string &section, const std::string &name)
    {
      return section.empty() ? name : section + "/" + name;
    }

    std::ifstream open_scene_file(const std::string &filename)
    {
      if (std::filesystem::is_directory(filename))
        throw InputError(filename, "", "is a directory", "give a scene file (*.prm)");
      if (!std::filesystem::exists(filename))
      {
        std::vector<std::string> neighbours;
        const std::filesystem::path folder = std::filesystem::path(filename).parent_path();
        std::error_code ignored;
        for (const auto &entry :
             std::filesystem::directory_iterator(folder.empty() ? "." : folder, ignored))
          if (entry.path().extension() == ".prm")
            neighbours.push_back((folder / entry.path().filename()).string());
        const std::string nearest = nearest_name(filename, neighbours);
        throw InputError(filename, "", "there is no such scene file",
                         nearest.empty() ? "--list-scenes prints the scene files that come with "
                                           "the program"
                                         : "did you mean '" + nearest + "'?");
      }
      std::ifstream file(filename);
      if (!file)
        throw InputError(filename, "", "the scene file cannot be opened",
                         "check that you may read it");
      return file;
    }
  } // namespace

  ParameterInput ParameterInput::read(const std::string &filename)
  {
    return read(filename, {});
  }

  ParameterInput ParameterInput::read(const std::string &filename, std::vector<std::string> readers)
  {
    ParameterInput input;
    input.file = filename;
    readers.push_back(std::filesystem::weakly_canonical(filename).string());
    std::ifstream file = open_scene_file(filename);
    std::vector<SectionStart> open;
    std::string line, statement, where;
    for (unsigned int number = 1; std::getline(file, line); ++number)
    {
      if (statement.empty())
        where = filename + ":" + std::to_string(number);
      std::string part = trim(line.substr(0, line.find('#')));
      const bool continues = !part.empty() && part.back() == '\\';
      if (continues)
        part = trim(part.substr(0, part.size() - 1)) + " ";
      statement += part;
      if (continues)
        continue;
      if (trim(statement).rfind("include ", 0) == 0)
        input.include(trim(trim(statement).substr(8)), where, readers);
      else
        input.add_line(trim(statement), where, open);
      statement.clear();
    }
    if (!statement.empty())
      throw InputError(where, "", "the last line ends in '\\' and nothing follows",
                       "remove the '\\'");
    if (!open.empty())
      throw InputError(open.back().where, "",
                       "the file ends inside of subsection " + open.back().path,
                       "close it with a line 'end'");
    return input;
  }

  void ParameterInput::include(const std::string &filename, const std::string &where,
                               const std::vector<std::string> &readers)
  {
    if (!entries.empty() || !section_starts.empty())
      throw InputError(where, "include " + filename, "other statements come before it",
                       "make it the first one");
    const std::filesystem::path path = std::filesystem::path(file).parent_path() / filename;
    const std::string canonical = std::filesystem::weakly_canonical(path).string();
    if (std::find(readers.begin(), readers.end(), canonical) != readers.end())
      throw InputError(where, "include " + filename, "the file includes itself", "remove the line");
    ParameterInput included = read(path.string(), readers);
    entries = std::move(included.entries);
    section_starts = std::move(included.section_starts);
    for (const Assignment &entry : entries)
      included_paths.insert(entry.path);
  }

  void ParameterInput::add_line(const std::string &line, const std::string &where,
                                std::vector<SectionStart> &open)
  {
    if (line.empty())
      return;
    const std::string word = line.substr(0, line.find_first_of(" \t"));
    const std::string rest = trim(line.substr(word.size()));
    const std::string section = open.empty() ? "" : open.back().path;
    if (word == "subsection")
    {
      if (rest.empty())
        throw InputError(where, line, "the subsection has no name", "write 'subsection NAME'");
      open.push_back({join(section, normalise(rest)), where});
      section_starts.push_back(open.back());
    }
    else if (word == "end")
    {
      if (!rest.empty())
        throw InputError(where, line, "'end' stands alone", "remove '" + rest + "'");
      if (open.empty())
        throw InputError(where, line, "there is no open subsection here", "remove the line");
      open.pop_back();
    }
    else if (word == "set")
      add_assignment(rest, where, section);
    else
      throw InputError(where, line, "this is no statement",
                       "a line is 'subsection NAME', 'set ENTRY = VALUE', 'end', 'include FILE' or "
                       "'# comment'");
  }

  void ParameterInput::add_assignment(const std::string &statement, const std::string &where,
                                      const std::string &section)
  {
    const auto equals = statement.find('=');
    const std::string name = normalise(statement.substr(0, equals));
    if (equals == std::string::npos || name.empty())
      throw InputError(where, "set " + statement, "this sets nothing", "write 'set ENTRY = VALUE'");
    const std::string path = join(section, name);
    const Assignment *const earlier = find(path);
    if (earlier && included_paths.erase(path) == 0)
      throw InputError(where + ", " + path, trim(statement.substr(equals + 1)),
                       "the entry was set before, at " + earlier->where, "keep one of the two");
    const auto directory = std::filesystem::absolute(file).parent_path().string();
    replace({path, trim(statement.substr(equals + 1)), where, directory});
  }

  void ParameterInput::override_with(const std::string &argument)
  {
    const auto equals = argument.find('=');
    std::string path, name;
    std::istringstream names(argument.substr(0, equals));
    while (std::getline(names, name, '/'))
      path = join(path, normalise(name));
    if (equals == std::string::npos || path.empty())
      throw InputError("--set", argument, "this sets nothing",
                       "write --set \"Section/Entry=value\"");
    const Assignment replacement = {path, trim(argument.substr(equals + 1)), "--set",
                                    std::filesystem::current_path().string()};
    const Assignment *const earlier = find(path);
    if (earlier && earlier->where == "--set")
      throw InputError("--set, " + path, replacement.value,
                       "the entry was set before, to \"" + earlier->value + "\"",
                       "keep one of the two");
    replace(replacement);
  }

  void ParameterInput::replace(const Assignment &replacement)
  {
    const auto same =
        std::find_if(entries.begin(), entries.end(),
                     [&](const Assignment &entry) { return entry.path == replacement.path; });
    if (same == entries.end())
      entries.push_back(replacement);
    else
      *same = replacement;
  }

  const ParameterInput::Assignment *ParameterInput::find(const std::string &path) const
  {
    for (const Assignment &entry : entries)
      if (entry.path == path)
        return &entry;
    return nullptr;
  }

  std::string ParameterInput::locate(const std::string &path) const
  {
    const Assignment *const assignment = find(path);
    return assignment ? assignment->where + ", " + path : path;
  }
} // namespace semilunar
