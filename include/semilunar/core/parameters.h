// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_core_parameters_h
#define semilunar_core_parameters_h

#include <semilunar/core/parameter_input.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <functional>

namespace semilunar
{
  /// Any finite number greater than zero.
  dealii::Patterns::Double positive_number();

  /// A declared entry.
  struct ParameterDescription
  {
    std::string path; ///< "Section/Subsection/Entry"
    std::string value, default_value, documentation;
    std::string pattern; ///< deal.II's description of the pattern
  };

  /// All declared entries in the order of their declaration.
  std::vector<ParameterDescription> list_parameters(const dealii::ParameterHandler &prm);

  /// The pattern in words: "a number greater than 0", "one of 'a', 'b'".
  std::string allowed_values(const std::string &pattern);

  /// For the message about a section that this scene does not have: the kinds of scenes that do.
  using KindsWithSection = std::function<std::vector<std::string>(const std::string &path)>;

  /// Give the entries that the user wrote to the declared entries; strict, nothing is ignored.
  /// Relative names of input files become absolute: relative to the scene file if they stand in it,
  /// to the current directory if they come from the command line.
  /// @throws InputError for sections and entries that are not declared and values that do not
  /// match.
  void assign(const ParameterInput &input, dealii::ParameterHandler &prm,
              const KindsWithSection &kinds_with_section);

  enum class ParameterFormat
  {
    prm, ///< an input file, documentation as comments
    json,
    markdown ///< a table for each section
  };

  /// Print all entries with values and documentation.
  void print_parameters(const dealii::ParameterHandler &prm, ParameterFormat format,
                        std::ostream &out);
} // namespace semilunar

#endif
