// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_core_parameter_input_h
#define semilunar_core_parameter_input_h

#include <set>
#include <string>
#include <vector>

namespace semilunar
{
  /// What a user wrote, before anyone knows which entries exist: the statements of a scene file
  ///
  ///     # comment
  ///     subsection Surface
  ///       set Source = cylinder
  ///     end
  ///
  /// (a line that ends in \ goes on in the next one; "include FILE" as the first statement takes
  /// over another scene file, whose entries may then be set otherwise) and of --set "Section/Entry=value" arguments,
  /// each with the place where it was written.
  class ParameterInput
  {
  public:
    struct Assignment
    {
      std::string path; ///< "Section/Subsection/Entry"
      std::string value;
      std::string where;     ///< "scene.prm:12" or "--set"
      std::string directory; ///< what a relative file name in the value refers to
    };
    struct SectionStart
    {
      std::string path, where;
    };

    /// Read a scene file.
    /// @throws InputError with file and line if the file cannot be read, a statement is unknown, a
    /// section is not closed or an entry is set twice.
    static ParameterInput read(const std::string &filename);

    /// Replace or add an assignment from the command line, "Section/Entry=value".
    /// @throws InputError if it does not have this form or the same entry was given before.
    void override_with(const std::string &argument);

    /// Replace or add an assignment.
    void replace(const Assignment &replacement);

    const std::vector<Assignment> &assignments() const { return entries; }
    /// The sections the file opens, including those without entries.
    const std::vector<SectionStart> &sections() const { return section_starts; }
    /// The assignment to this entry, or nullptr.
    const Assignment *find(const std::string &path) const;
    /// "scene.prm:12, Section/Entry" if the entry was set, otherwise the path itself: where to
    /// look for a mistake that shows only later.
    std::string locate(const std::string &path) const;

    const std::string &filename() const { return file; }

  private:
    /// @param readers the files that include this one
    static ParameterInput read(const std::string &filename, std::vector<std::string> readers);
    void include(const std::string &filename, const std::string &where,
                 const std::vector<std::string> &readers);
    void add_line(const std::string &line, const std::string &where,
                  std::vector<SectionStart> &open);
    void add_assignment(const std::string &statement, const std::string &where,
                        const std::string &section);

    std::string file;
    std::vector<Assignment> entries;
    std::set<std::string> included_paths; ///< of entries that may still be set otherwise
    std::vector<SectionStart> section_starts;
  };
} // namespace semilunar

#endif
