// SPDX-License-Identifier: LGPL-2.1-or-later
// Prescribed and tied displacements: counts, values, conflicts, the transposed map of forces; the
// reduced tangent matrix against the product with the dense map.

#include <semilunar/core/exceptions.h>
#include <semilunar/shell/sparse_system.h>

#include <functional>
#include <limits>
#include <set>

#include "../tests.h"
#include "shell_cases.h"

using namespace semilunar;
using namespace semilunar::shell;
using namespace semilunar::tests;

namespace
{
  using Vector = dealii::Vector<double>;

  void check_true(const std::string &what, const bool holds)
  {
    check(what, holds ? 0. : 1., 0.);
  }

  Vectors expand(const Equations &equations, const Vector &u, const double load)
  {
    Vectors displacements;
    equations.expand(u, load, displacements);
    return displacements;
  }

  Vector random_vector(const unsigned int n, const unsigned int seed)
  {
    const Vectors v = random_vectors(n, 1., seed);
    Vector result(n);
    for (unsigned int i = 0; i < n; ++i)
      result[i] = v[i][0];
    return result;
  }

  /// On 20 control points (a 5 x 4 net): a tied triple, a tied pair that is prescribed through
  /// either of its members, tied loops, single prescriptions.
  Equations make_equations()
  {
    Equations equations(20);
    equations.tie(4, 7, 0);
    equations.tie(9, 4, 0); // 4, 7, 9
    equations.tie(9, 7, 0); // again
    equations.tie(1, 2, 1);
    equations.prescribe(2, 1, 0.5);
    equations.prescribe(11, 1, -2.);
    equations.tie(11, 12, 1);
    equations.tie(14, 13, 1);
    equations.tie(13, 12, 1); // 14 through 13 and 12 to 11
    equations.prescribe(0, 0, 0.);
    equations.prescribe(19, 2, 3.);
    equations.close();
    return equations;
  }

  void check_numbers()
  {
    const Equations equations = make_equations();
    // 60 less 2 by the triple, 2 by the pair, 4 by the chain, 2 singles
    check_true("number of equations", equations.n_equations() == 50);
    check_true("number of control points", equations.n_control_points() == 20);
    std::set<unsigned int> numbers;
    for (unsigned int c = 0; c < 20; ++c)
      for (unsigned int i = 0; i < 3; ++i)
        if (!equations.is_prescribed(c, i))
          numbers.insert(equations(c, i));
    check_true("numbers without gaps", numbers.size() == 50 && *numbers.rbegin() == 49);
    check_true("tied components share their equation",
               equations(4, 0) == equations(7, 0) && equations(4, 0) == equations(9, 0) &&
                   equations(4, 0) != equations(8, 0) && equations(4, 1) != equations(7, 1));
    check_true("tied components share their representative",
               equations.representative(14, 1) == equations.representative(11, 1) &&
                   equations.representative(14, 0) != equations.representative(11, 0));
    check_true("prescribed components have no equation",
               equations(1, 1) == Equations::none && equations(14, 1) == Equations::none &&
                   equations(19, 2) == Equations::none && equations(19, 1) != Equations::none);
  }

  /// Two values for one component are refused, through ties as well; equal ones are not.
  void check_conflicts()
  {
    const auto refused = [](const std::function<void(Equations &)> &prescribe)
    {
      Equations equations(4);
      equations.tie(0, 1, 2);
      equations.prescribe(0, 2, 1.);
      try
      {
        prescribe(equations);
      }
      catch (const InputError &error)
      {
        return error.where() == "Supports/Supports";
      }
      return false;
    };
    check_true("the same value again", !refused([](Equations &e) { e.prescribe(0, 2, 1.); }) &&
                                           !refused([](Equations &e) { e.prescribe(1, 2, 1.); }));
    check_true("another value", refused([](Equations &e) { e.prescribe(0, 2, 0.); }));
    check_true("another value for a tied component",
               refused([](Equations &e) { e.prescribe(1, 2, 0.); }));
    check_true("a tie of two values", refused(
                                          [](Equations &e)
                                          {
                                            e.prescribe(3, 2, 2.);
                                            e.tie(3, 1, 2);
                                          }));
    check_true("a tie of two equal values", !refused(
                                                [](Equations &e)
                                                {
                                                  e.prescribe(3, 2, 1.);
                                                  e.tie(3, 1, 2);
                                                }));
  }

  void check_expansion()
  {
    const Equations equations = make_equations();
    const unsigned int n = equations.n_equations();
    const Vectors moved = expand(equations, Vector(n), 0.5);
    const double expected[][3] = {{1, 1, 0.25}, {2, 1, 0.25}, {11, 1, -1.}, {12, 1, -1.},
                                  {13, 1, -1.}, {14, 1, -1.}, {19, 2, 1.5}};
    double error = std::abs(dot(moved, moved) - (2. * 0.0625 + 4. + 2.25)); // nothing else moves
    for (const auto &[c, i, value] : expected)
      error += std::abs(moved[unsigned(c)][unsigned(i)] - value);
    check("prescribed displacements at half the load", error, 0.);

    const Vector u = random_vector(n, 5);
    const Vectors f = random_vectors(20, 1., 6);
    Vector r;
    equations.restrict(f, r);
    check("restrict is the transpose of expand", dot(f, expand(equations, u, 0.)) - r * u, 1e-14);
    const Vectors at_2 = expand(equations, u, 2.), at_0 = expand(equations, u, 0.);
    Vector gathered;
    equations.gather(at_2, gathered);
    gathered -= u;
    check("gather is the inverse of expand", gathered.linfty_norm(), 0.);
    check("expansion is linear in solution and load", norm(sum(sum(at_2, -1., at_0), -4., moved)),
          1e-14);
  }

  /// 2 x 1 elements with 5 x 4 control points, the second coupled to the first.
  struct Blocks
  {
    Surface surface = plate(2., 1., {{3, 3}}, {{2, 1}});
    Equations equations = make_equations();
    SparseSystem system{surface, equations};

    /// A random block for these control points, to the system and to the dense matrix.
    void add(const std::vector<unsigned int> &points, const unsigned int seed)
    {
      const unsigned int n = 3 * points.size();
      const Vector block = random_vector(n * n, seed);
      system.add(points, block.begin());
      for (unsigned int k = 0; k < n; ++k)
        for (unsigned int l = 0; l < n; ++l)
          dense[3 * points[k / 3] + k % 3][3 * points[l / 3] + l % 3] += block[k * n + l];
    }
    /// P^T K P x by the dense matrix and the map P.
    Vector reduced(const Vector &x) const
    {
      const Vectors u = expand(equations, x, 0.);
      Vectors f(20);
      for (unsigned int k = 0; k < 60; ++k)
        for (unsigned int l = 0; l < 60; ++l)
          f[k / 3][k % 3] += dense[k][l] * u[l / 3][l % 3];
      Vector result;
      equations.restrict(f, result);
      return result;
    }
    double dense[60][60] = {};
  };

  double difference(Vector a, const Vector &b)
  {
    a -= b;
    return a.l2_norm() / b.l2_norm();
  }

  std::string message_of(const std::function<void()> &action)
  {
    try
    {
      action();
    }
    catch (const NumericsError &error)
    {
      return error.what();
    }
    return "";
  }

  void check_matrix()
  {
    Blocks blocks;
    const unsigned int n = blocks.equations.n_equations();
    for (unsigned int e = 0; e < 2; ++e)
      blocks.add(blocks.surface.elements[e].control_points, 10 + e);
    const Vector x = random_vector(n, 20);
    Vector y(n);
    blocks.system.multiply(y, x);
    check("reduced matrix", difference(y, blocks.reduced(x)), 1e-13);

    blocks.system.couple({{1, 0}});
    blocks.system.set_zero();
    std::fill(&blocks.dense[0][0], &blocks.dense[0][0] + 3600, 0.);
    blocks.add({0, 4, 5, 9, 4, 19}, 30); // of both elements, one twice
    for (unsigned int e = 0; e < 2; ++e)
      blocks.add(blocks.surface.elements[e].control_points, 40 + e);
    blocks.system.couple({{0, 1}}); // there already: nothing is lost
    blocks.system.multiply(y, x);
    check("reduced matrix with coupled elements", difference(y, blocks.reduced(x)), 1e-13);

    const Vector diagonal = random_vector(n, 50);
    blocks.system.add_diagonal(diagonal, 3.);
    Vector shifted = blocks.reduced(x);
    for (unsigned int i = 0; i < n; ++i)
      shifted[i] += 3. * diagonal[i] * x[i];
    blocks.system.factorize();
    blocks.system.solve(shifted);
    check("solution of the shifted system", difference(shifted, x), 1e-10);

    blocks.system.set_zero();
    check_true("a singular matrix is refused",
               message_of([&] { blocks.system.factorize(); }).find("singular") !=
                   std::string::npos);
    Vector bad(n);
    bad = std::numeric_limits<double>::quiet_NaN();
    blocks.system.add_diagonal(bad, 1.);
    check_true("not a number is refused",
               message_of([&] { blocks.system.factorize(); }).find("not finite") !=
                   std::string::npos);
  }
} // namespace

int main()
{
  check_numbers();
  check_conflicts();
  check_expansion();
  check_matrix();
}
