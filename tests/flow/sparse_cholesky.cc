// SPDX-License-Identifier: LGPL-2.1-or-later
// Factors that walls are preconditioned with: exact to the precision they are kept in, for one
// matrix after the other, and usable where a matrix is not positive definite.
#include "../tests.h"

#include <semilunar/core/exceptions.h>
#include <semilunar/flow/sparse_cholesky.h>

#include <cmath>
#include <limits>

using namespace semilunar;
using namespace semilunar::flow;
using namespace semilunar::tests;

namespace
{
  constexpr int n_1d = 30, n = n_1d * n_1d;

  /// Nine-point differences on a square grid plus a multiple of the identity.
  template <class Columns>
  void make_grid(const double mass, Columns &matrix)
  {
    matrix = {};
    matrix.start.push_back(0);
    for (int j = 0; j < n; ++j)
    {
      const int x = j % n_1d, y = j / n_1d;
      matrix.row.push_back(j);
      matrix.value.push_back(8. + mass);
      for (const auto &[dx, dy] : {std::pair{1, 0}, {-1, 1}, {0, 1}, {1, 1}})
        if (x + dx >= 0 && x + dx < n_1d && y + dy < n_1d)
        {
          matrix.row.push_back(j + dx + dy * n_1d);
          matrix.value.push_back(-1.);
        }
      matrix.start.push_back(matrix.row.size());
    }
  }

  template <class Columns>
  std::vector<double> product(const Columns &matrix, const std::vector<double> &x)
  {
    std::vector<double> result(n, 0.);
    for (int j = 0; j < n; ++j)
      for (int k = matrix.start[j]; k < matrix.start[j + 1]; ++k)
      {
        result[matrix.row[k]] += matrix.value[k] * x[j];
        if (matrix.row[k] != j)
          result[j] += matrix.value[k] * x[matrix.row[k]];
      }
    return result;
  }

  std::vector<double> wave()
  {
    std::vector<double> result;
    for (int i = 0; i < n; ++i)
      result.push_back(std::sin(0.7 * i) + 0.01 * i);
    return result;
  }

  template <class Number>
  void solve(const std::string &precision, const double tolerance)
  {
    SparseCholesky<Number> factors;
    typename SparseCholesky<Number>::Columns matrix;
    for (const double mass : {0., 3.})
    {
      make_grid(mass, matrix);
      const std::vector<double> exact = wave(), b = product(matrix, exact);
      std::vector<double> x = b;
      factors.factorise(matrix);
      factors.solve(x.data(), x.data());
      double error = 0.;
      for (int i = 0; i < n; ++i)
        error = std::max(error, std::abs(x[i] - exact[i]) / 10.);
      check("error in " + precision + " precision", error, tolerance);
    }
    // The smallest eigenvalues are negative: what comes is the inverse of a matrix above them.
    make_grid(-0.5, matrix);
    factors.factorise(matrix);
    const std::vector<double> b = wave();
    std::vector<double> x(n);
    factors.solve(b.data(), x.data());
    double work = 0.;
    for (int i = 0; i < n; ++i)
      work += b[i] * x[i];
    check("  work of an indefinite matrix, negative part", std::max(0., -work), 0.);
    check("  or no number", std::isfinite(work) ? 0. : 1., 0.);
    matrix.value[5] = std::numeric_limits<double>::quiet_NaN();
    bool refused = false;
    try
    {
      factors.factorise(matrix);
    }
    catch (const NumericsError &)
    {
      refused = true;
    }
    log() << "a matrix with a NaN is " << (refused ? "refused" : "accepted") << std::endl;
  }
} // namespace

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  solve<double>("double", 1e-12);
  solve<float>("single", 1e-4);
}
