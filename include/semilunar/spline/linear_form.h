// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_spline_linear_form_h
#define semilunar_spline_linear_form_h

#include <map>

namespace semilunar::spline
{
  /// A linear combination of control points: their numbers and factors.
  class LinearForm
  {
  public:
    LinearForm() = default;
    explicit LinearForm(const unsigned int control_point) { terms[control_point] = 1.; }

    void add(const double factor, const LinearForm &other)
    {
      for (const auto &[i, x] : other.terms)
        terms[i] += factor * x;
    }

    double factor(const unsigned int control_point) const
    {
      const auto found = terms.find(control_point);
      return found == terms.end() ? 0. : found->second;
    }

    std::map<unsigned int, double> terms;
  };
} // namespace semilunar::spline

#endif
