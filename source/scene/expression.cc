// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/core/units.h>
#include <semilunar/scene/expression.h>

#include <deal.II/base/function_parser.h>
#include <deal.II/base/numbers.h>
#include <deal.II/base/utilities.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <sstream>

namespace semilunar::scene
{
  namespace
  {
    using dealii::FunctionParser;

    /// Parts of a text between separators outside of parentheses, without surrounding blanks.
    std::vector<std::string> split(const std::string &text, const char separator)
    {
      std::vector<std::string> parts(1);
      int depth = 0;
      for (const char c : text)
      {
        depth += (c == '(') - (c == ')');
        if (c == separator && depth == 0)
          parts.emplace_back();
        else
          parts.back() += c;
      }
      for (std::string &part : parts)
        part = dealii::Utilities::trim(part);
      return parts;
    }

    Constants with_units(Constants constants)
    {
      constants.insert({"pi", dealii::numbers::PI});
      constants.insert({"mmHg", mmHg});
      return constants;
    }

    /// Keeps what is written to std::cerr from the terminal while it exists.
    class Silence
    {
    public:
      Silence() : original(std::cerr.rdbuf(swallowed.rdbuf())) {}
      ~Silence() { std::cerr.rdbuf(original); }
      Silence(const Silence &) = delete;

    private:
      std::ostringstream swallowed;
      std::streambuf *const original;
    };

    /// An expression ready to be evaluated, tried once.
    template <int dim>
    std::shared_ptr<FunctionParser<dim>>
    parse(const std::vector<std::string> &expressions, const std::string &variables,
          const Constants &constants, const std::string &text, const std::string &entry)
    {
      auto parser = std::make_shared<FunctionParser<dim>>(expressions.size());
      const Silence silence; // deal.II prints muParser's complaint, which takes lines
      try
      {
        parser->initialize(variables, expressions, with_units(constants), true);
        dealii::Vector<double> values(expressions.size());
        parser->vector_value(dealii::Point<dim>(), values);
      }
      catch (const dealii::ExceptionBase &)
      {
        throw InputError(entry, text, "this is no expression",
                         "use " + variables +
                             ", pi, mmHg, the constants of the scene, + - * / ^ "
                             "and functions as sin, exp, if(condition, a, b)");
      }
      return parser;
    }

    std::string variables(const unsigned int dim)
    {
      return dim == 1 ? "x,t" : dim == 2 ? "x,y,t" : "x,y,z,t";
    }
  } // namespace

  std::vector<std::pair<std::string, std::string>> named_parts(const std::string &list,
                                                               const std::string &entry)
  {
    std::vector<std::pair<std::string, std::string>> result;
    for (const std::string &part : split(list, ';'))
    {
      if (part.empty())
        continue;
      const auto colon = part.find(':');
      if (colon == std::string::npos || colon == 0)
        throw InputError(entry, part, "this has no name", "write 'NAME: VALUE; NAME: VALUE'");
      const std::string name = dealii::Utilities::trim(part.substr(0, colon));
      if (std::any_of(result.begin(), result.end(),
                      [&](const auto &other) { return other.first == name; }))
        throw InputError(entry, list, "'" + name + "' comes twice", "keep one of the two");
      result.emplace_back(name, dealii::Utilities::trim(part.substr(colon + 1)));
    }
    return result;
  }

  std::vector<std::string> components(const std::string &text, const unsigned int n,
                                      const std::string &entry)
  {
    std::string inner = dealii::Utilities::trim(text);
    std::vector<std::string> parts;
    if (inner.size() >= 2 && inner.front() == '(' && inner.back() == ')')
      parts = split(inner.substr(1, inner.size() - 2), ',');
    if (parts.size() != n || std::count(parts.begin(), parts.end(), "") > 0)
      throw InputError(entry, text, "this is no list of " + std::to_string(n) + " components",
                       n == 2 ? "write '(A, B)'" : "write '(A, B, C)'");
    return parts;
  }

  template <int dim>
  VectorField<dim> vector_field(const std::string &text, const Constants &constants,
                                const std::string &entry)
  {
    const auto parser =
        parse<dim>(components(text, dim, entry), variables(dim), constants, text, entry);
    return [parser](const dealii::Point<dim> &x, const double time)
    {
      parser->set_time(time);
      dealii::Vector<double> values(dim);
      parser->vector_value(x, values);
      dealii::Tensor<1, dim> result;
      for (unsigned int d = 0; d < dim; ++d)
        result[d] = values[d];
      return result;
    };
  }

  template <int dim>
  ScalarField<dim> scalar_field(const std::string &text, const Constants &constants,
                                const std::string &entry)
  {
    const auto parser = parse<dim>({text}, variables(dim), constants, text, entry);
    return [parser](const dealii::Point<dim> &x, const double time)
    {
      parser->set_time(time);
      return parser->value(x);
    };
  }

  std::function<double(double)> time_function(const std::string &text, const Constants &constants,
                                              const std::string &entry)
  {
    const auto parser = parse<1>({text}, "x,t", constants, text, entry);
    return [parser](const double time)
    {
      parser->set_time(time);
      return parser->value(dealii::Point<1>());
    };
  }

  double number(const std::string &text, const Constants &constants, const std::string &entry)
  {
    const double value = time_function(text, constants, entry)(0.);
    if (!std::isfinite(value))
      throw InputError(entry, text, "this is no number", "give a finite number");
    return value;
  }

  template VectorField<2> vector_field(const std::string &, const Constants &, const std::string &);
  template VectorField<3> vector_field(const std::string &, const Constants &, const std::string &);
  template ScalarField<2> scalar_field(const std::string &, const Constants &, const std::string &);
  template ScalarField<3> scalar_field(const std::string &, const Constants &, const std::string &);
} // namespace semilunar::scene
