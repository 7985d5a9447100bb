// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_scene_expression_h
#define semilunar_scene_expression_h

#include <deal.II/base/point.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace semilunar::scene
{
  /// Names that stand for numbers in expressions, beside pi and mmHg.
  using Constants = std::map<std::string, double>;

  template <int dim>
  using VectorField =
      std::function<dealii::Tensor<1, dim>(const dealii::Point<dim> &x, double time)>;
  template <int dim>
  using ScalarField = std::function<double(const dealii::Point<dim> &x, double time)>;

  /// "inlet: A; outlet: B": the texts by name, in the order in which they stand.
  /// @throws InputError naming @p entry if a part has no name or a name comes twice
  std::vector<std::pair<std::string, std::string>> named_parts(const std::string &list,
                                                               const std::string &entry);

  /// "(a, b, c)": the texts between the commas that are not in parentheses of their own.
  /// @throws InputError naming @p entry unless there are @p n of them
  std::vector<std::string> components(const std::string &text, unsigned int n,
                                      const std::string &entry);

  /// "(u, v, w)", expressions in x, y, z, t as muParser reads them.
  /// @throws InputError naming @p entry
  template <int dim>
  VectorField<dim> vector_field(const std::string &text, const Constants &constants,
                                const std::string &entry);

  /// The same, or no function if there is no text.
  template <int dim>
  VectorField<dim> field_if_given(const std::string &text, const Constants &constants,
                                  const std::string &entry)
  {
    return text.empty() ? VectorField<dim>() : vector_field<dim>(text, constants, entry);
  }

  /// An expression in x, y, z, t.
  template <int dim>
  ScalarField<dim> scalar_field(const std::string &text, const Constants &constants,
                                const std::string &entry);

  /// An expression in t.
  std::function<double(double)> time_function(const std::string &text, const Constants &constants,
                                              const std::string &entry);

  /// An expression of constants.
  double number(const std::string &text, const Constants &constants, const std::string &entry);
} // namespace semilunar::scene

#endif
