// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/coupling/point_density.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/lac/full_matrix.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace semilunar::coupling
{
  namespace
  {
    using dealii::FullMatrix;

    constexpr unsigned int fewest = 2;
    /// New points are so much closer than they have to be, for elements that go on stretching; an
    /// element gives points away if it has so many times more than that.
    constexpr double margin = 1.25, too_many = 2.;

    /// sqrt(2k+1) P_k(2x-1): orthonormal on the unit interval.
    double legendre(const unsigned int k, const double x)
    {
      return std::sqrt(2. * k + 1.) * std::legendre(k, 2. * x - 1.);
    }

    /// From values at m Gauss points to those of their projection at n.
    FullMatrix<double> projection(const unsigned int m, const unsigned int n)
    {
      const dealii::QGauss<1> from(m), to(n);
      FullMatrix<double> result(n, m);
      for (unsigned int k = 0; k < std::min(m, n); ++k)
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int j = 0; j < m; ++j)
            result(i, j) +=
                legendre(k, to.point(i)[0]) * legendre(k, from.point(j)[0]) * from.weight(j);
      return result;
    }

    /// The number of points that an element should have, given what it has and needs.
    unsigned int adapted(const unsigned int now, const double needed)
    {
      const unsigned int enough =
          std::max(fewest, static_cast<unsigned int>(std::ceil(margin * needed)));
      return now < needed || now > too_many * enough ? enough : now;
    }
  } // namespace

  PointNumbers point_numbers(const shell::QuadraturePoints &points, const unsigned int n_elements)
  {
    PointNumbers result(n_elements);
    for (unsigned int e = 0; e < n_elements; ++e)
    {
      const unsigned int begin = points.first_point(e), end = points.first_point(e + 1);
      unsigned int n = 1;
      while (begin + n < end && points.xi(begin + n)[1] == points.xi(begin)[1])
        ++n;
      result[e] = {{n, (end - begin) / n}};
    }
    return result;
  }

  std::array<double, 2> element_lengths(const shell::QuadraturePoints &points,
                                        const unsigned int element,
                                        const std::array<unsigned int, 2> &numbers,
                                        const std::vector<dealii::Tensor<1, 3>> &positions)
  {
    std::array<double, 2> longest{{0., 0.}};
    const unsigned int begin = points.first_point(element), end = points.first_point(element + 1);
    const std::array<unsigned int, 2> next{{1, numbers[0]}};
    for (unsigned int q = begin; q < end; ++q)
      for (unsigned int d = 0; d < 2; ++d)
      {
        const unsigned int place = d == 0 ? (q - begin) % numbers[0] : (q - begin) / numbers[0];
        if (place + 1 == numbers[d])
          continue;
        const unsigned int neighbor = q + next[d];
        longest[d] = std::max(longest[d], (positions[neighbor] - positions[q]).norm() /
                                              (points.xi(neighbor)[d] - points.xi(q)[d]));
      }
    return longest;
  }

  PointNumbers adapted_numbers(const shell::QuadraturePoints &points,
                               const std::vector<dealii::Tensor<1, 3>> &positions,
                               const std::vector<double> &widths, const double per_cell)
  {
    PointNumbers numbers = point_numbers(points, widths.size());
    for (unsigned int e = 0; e < widths.size(); ++e)
    {
      const std::array<double, 2> lengths = element_lengths(points, e, numbers[e], positions);
      for (unsigned int d = 0; d < 2; ++d)
        numbers[e][d] = adapted(numbers[e][d], per_cell * lengths[d] / widths[e]);
    }
    return numbers;
  }

  std::vector<double> transfer(const std::vector<double> &values,
                               const shell::QuadraturePoints &from,
                               const shell::QuadraturePoints &to, const unsigned int n_elements)
  {
    const PointNumbers old_numbers = point_numbers(from, n_elements),
                       new_numbers = point_numbers(to, n_elements);
    std::map<std::pair<unsigned int, unsigned int>, FullMatrix<double>> projections;
    const auto project = [&](const unsigned int m, const unsigned int n) -> FullMatrix<double> &
    {
      const auto [place, is_new] = projections.try_emplace({m, n});
      if (is_new)
        place->second = projection(m, n);
      return place->second;
    };
    std::vector<double> result(to.n_points());
    for (unsigned int e = 0; e < n_elements; ++e)
    {
      const auto &[m1, m2] = old_numbers[e];
      const auto &[n1, n2] = new_numbers[e];
      const double *given = values.data() + from.first_point(e);
      double *carried = result.data() + to.first_point(e);
      if (m1 == n1 && m2 == n2)
      {
        std::copy(given, given + m1 * m2, carried);
        continue;
      }
      const FullMatrix<double> &first = project(m1, n1), &second = project(m2, n2);
      FullMatrix<double> old_values(m2, m1, given), half(m2, n1), new_values(n2, n1);
      old_values.mTmult(half, first);
      second.mmult(new_values, half);
      for (unsigned int j = 0; j < n2; ++j)
        for (unsigned int i = 0; i < n1; ++i)
          carried[j * n1 + i] = new_values(j, i);
    }
    return result;
  }
} // namespace semilunar::coupling
