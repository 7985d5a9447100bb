// SPDX-License-Identifier: LGPL-2.1-or-later
// How many midsurface points per second one thread sums up to forces and tangent blocks, bicubic
// elements with three thickness points, and how many to forces alone or into the sparse matrix too.
// The rates go to the terminal; the test only fails if one is far below what was measured when it
// was written.

#include <semilunar/shell/assembly.h>
#include <semilunar/shell/section_parameters.h>
#include <semilunar/shell/sparse_system.h>

#include <deal.II/base/multithread_info.h>

#include <chrono>

#include "../tests.h"
#include "shell_cases.h"

using namespace semilunar;
using namespace semilunar::shell;
using namespace semilunar::tests;

namespace
{
  struct Shell
  {
    explicit Shell(const std::string &material)
    {
      SectionParameters p;
      p.material = material;
      p.n_thickness_points = 3;
      section = p.make_section();
    }
    const Surface surface = refined(spline::cylinder(1.2, 0., 2., 0., 2.), {{3, 3}}, {{12, 12}});
    const QuadraturePoints points{surface};
    std::unique_ptr<Section> section;
  };

  template <typename Action>
  double best_rate(const Shell &shell, const Action &action)
  {
    double best = 0.;
    for (unsigned int run = 0; run < 12; ++run)
    {
      const auto start = std::chrono::steady_clock::now();
      action();
      const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
      best = std::max(best, shell.points.n_points() / elapsed.count());
    }
    return best;
  }

  void measure(const std::string &material)
  {
    const Shell shell(material);
    const Assembly assembly(shell.surface, shell.points, *shell.section,
                            [](const Tensor<1, 3> &, const std::array<Tensor<1, 3>, 2> &) {
                              return std::array<double, 2>{{1., 0.}};
                            });
    const Vectors X = positions(shell.surface), x = sum(X, 1., random_vectors(X.size(), 0.002, 1));
    Equations equations(X.size());
    equations.close();
    SparseSystem matrix(shell.surface, equations);
    Vectors forces(X.size());
    double trace = 0.;
    const double for_forces = best_rate(shell, [&] { assembly.add(x, 1e5, forces, {}); }),
                 with_tangent =
                     best_rate(shell,
                               [&]
                               {
                                 assembly.add(x, 1e5, forces,
                                              [&](const std::vector<unsigned int> &,
                                                  const double *block) { trace += block[0]; });
                               }),
                 with_matrix =
                     best_rate(shell,
                               [&]
                               {
                                 assembly.add(x, 1e5, forces,
                                              [&](const std::vector<unsigned int> &control_points,
                                                  const double *block)
                                              { matrix.add(control_points, block); });
                               });
    std::fprintf(stderr,
                 "%-12s %8.0f points/s with tangent, %8.0f into the matrix, %8.0f forces alone\n",
                 material.c_str(), with_tangent, with_matrix, for_forces);
    check(material + ", seconds per point", std::isfinite(trace) ? 1. / with_tangent : 1., 5e-5);
  }
} // namespace

int main()
{
  dealii::MultithreadInfo::set_thread_limit(1);
  measure("neo-Hookean");
  measure("Fung");
}
