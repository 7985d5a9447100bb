// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/spline/blossom.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

namespace semilunar::spline
{
  namespace
  {
    std::string to_string(const std::vector<double> &knots)
    {
      std::ostringstream out;
      for (unsigned int i = 0; i < knots.size(); ++i)
        out << (i == 0 ? "" : " ") << knots[i];
      return out.str();
    }

    void check_knots(const unsigned int p, const std::vector<double> &t)
    {
      const auto fail = [&t](const char *problem, const char *remedy)
      { throw InputError("knot vector", to_string(t), problem, remedy); };
      if (p < 1)
        fail("the degree is zero", "at least 1 is needed");
      if (t.size() < 2 * (p + 1))
        fail("too few knots", "at least 2 (degree + 1) are needed");
      for (unsigned int i = 0; i < t.size(); ++i)
      {
        if (!std::isfinite(t[i]))
          fail("a knot is not a finite number", "");
        if (i > 0 && t[i] < t[i - 1])
          fail("the knots decrease", "sort them");
      }
      if (t[p] != t.front() || t[t.size() - 1 - p] != t.back())
        fail("the ends are not clamped", "repeat the first and the last knot degree + 1 times");
      for (unsigned int i = 1; i + p < t.size() - 1; ++i)
        if (t[i] == t[i + p])
          fail("a knot is repeated too often", "inner knots at most degree times");
    }
  } // namespace

  KnotVector::KnotVector(const unsigned int degree, std::vector<double> knots)
      : p(degree), t(std::move(knots))
  {
    check_knots(p, t);
  }

  KnotVector KnotVector::uniform(const unsigned int degree, const unsigned int n_elements)
  {
    if (n_elements == 0)
      throw InputError("knot vector", "0", "no elements", "at least one is needed");
    std::vector<double> knots(degree, 0.);
    for (unsigned int e = 0; e <= n_elements; ++e)
      knots.push_back(static_cast<double>(e) / n_elements);
    knots.insert(knots.end(), degree, 1.);
    return KnotVector(degree, knots);
  }

  std::vector<double> KnotVector::breakpoints() const
  {
    std::vector<double> result;
    std::unique_copy(t.begin(), t.end(), std::back_inserter(result));
    return result;
  }

  std::vector<double> KnotVector::greville_abscissae() const
  {
    std::vector<double> result(n_functions());
    for (unsigned int i = 0; i < result.size(); ++i)
    {
      const double mean = std::accumulate(t.begin() + i + 1, t.begin() + i + p + 1, 0.) / p;
      // round-off must not carry it out of the average's range, not even at coinciding knots
      result[i] = std::clamp(mean, t[i + 1], t[i + p]);
    }
    return result;
  }

  unsigned int KnotVector::span(const double x) const
  {
    const auto last = t.end() - p - 1;
    const auto above = std::upper_bound(t.begin() + p + 1, last, x);
    return above - t.begin() - 1;
  }

  std::vector<double> KnotVector::evaluate(const double x) const
  {
    const unsigned int s = span(x);
    std::vector<double> N(p + 1), left(p + 1), right(p + 1);
    N[0] = 1.;
    for (unsigned int k = 1; k <= p; ++k) // Cox and de Boor's recursion, degree by degree
    {
      left[k] = x - t[s + 1 - k];
      right[k] = t[s + k] - x;
      double saved = 0.;
      for (unsigned int r = 0; r < k; ++r)
      {
        const double quotient = N[r] / (right[r + 1] + left[k - r]);
        N[r] = saved + right[r + 1] * quotient;
        saved = left[k - r] * quotient;
      }
      N[k] = saved;
    }
    return N;
  }

  std::vector<std::vector<double>> KnotVector::extraction_operators() const
  {
    std::vector<std::vector<double>> operators;
    std::vector<double> C((p + 1) * (p + 1)), unit(p + 1), arguments(p);
    for (unsigned int s = p; s < n_functions(); ++s)
    {
      if (t[s] == t[s + 1])
        continue;
      for (unsigned int b = 0; b <= p; ++b)
      {
        std::fill_n(arguments.begin(), p - b, t[s]);
        std::fill(arguments.begin() + p - b, arguments.end(), t[s + 1]);
        for (unsigned int a = 0; a <= p;
             ++a) // the spline whose coefficients are 0 but for number a
        {
          std::fill(unit.begin(), unit.end(), 0.);
          unit[a] = 1.;
          C[a * (p + 1) + b] = blossom(*this, s, arguments, unit);
        }
      }
      operators.push_back(C);
    }
    return operators;
  }
} // namespace semilunar::spline
