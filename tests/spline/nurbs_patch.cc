// SPDX-License-Identifier: LGPL-2.1-or-later
// Knot vectors and patches: a published extraction operator, exactness of every change of basis.
#include "../tests.h"
#include <semilunar/core/exceptions.h>
#include <semilunar/spline/bernstein.h>
#include <semilunar/spline/evaluation.h>
#include <semilunar/spline/nurbs_patch.h>

#include <algorithm>
#include <random>

using namespace semilunar;
using spline::KnotVector;
using spline::NurbsPatch;

namespace
{
  std::mt19937 generator(17);

  double random_number(const double low, const double high)
  {
    return low + (high - low) * std::uniform_real_distribution<double>()(generator);
  }

  /// Non-uniform, one inner knot doubled.
  const std::array<KnotVector, 2> knots{
      {KnotVector(2, {0, 0, 0, 0.2, 0.7, 0.7, 1, 1, 1}),
       KnotVector(3, {-1, -1, -1, -1, -0.4, 0.1, 0.1, 1.3, 2, 2, 2, 2})}};

  NurbsPatch random_patch()
  {
    std::vector<spline::ControlPoint> net;
    for (unsigned int j = 0; j < knots[1].n_functions(); ++j)
      for (unsigned int i = 0; i < knots[0].n_functions(); ++i)
        net.push_back({spline::Point<3>(i + random_number(-0.3, 0.3), j + random_number(-0.3, 0.3),
                                        random_number(-1., 1.)),
                       random_number(0.5, 2.)});
    return NurbsPatch(knots, net);
  }

  /// The largest distance between points of equal parameters, relative to the size of the patch.
  double difference(const NurbsPatch &a, const NurbsPatch &b)
  {
    double result = 0.;
    for (unsigned int i = 0; i <= 20; ++i)
      for (unsigned int j = 0; j <= 20; ++j)
      {
        const spline::Point<2> u(i / 20., -1. + 3. * j / 20.);
        result = std::max(result, a.evaluate(u).distance(b.evaluate(u)));
      }
    return result / 10.;
  }

  void check_basis(const KnotVector &knots)
  {
    const auto greville = knots.greville_abscissae();
    const auto operators = knots.extraction_operators();
    const auto points = knots.breakpoints();
    const unsigned int p = knots.degree();
    double unity = 0., linear = 0., extraction = 0.;
    for (unsigned int e = 0; e + 1 < points.size(); ++e)
      for (const double xi : {0., 0.31, 0.77})
      {
        const double x = points[e] + xi * (points[e + 1] - points[e]);
        const auto N = knots.evaluate(x);
        double bernstein[spline::max_degree + 1], sum = 0., mean = 0.;
        spline::bernstein_values(p, xi, bernstein);
        for (unsigned int a = 0; a <= p; ++a)
        {
          sum += N[a];
          mean += N[a] * greville[knots.span(x) - p + a];
          double extracted = 0.;
          for (unsigned int b = 0; b <= p; ++b)
            extracted += operators[e][a * (p + 1) + b] * bernstein[b];
          extraction = std::max(extraction, std::abs(extracted - N[a]));
        }
        unity = std::max(unity, std::abs(sum - 1.));
        linear = std::max(linear, std::abs(mean - x));
      }
    tests::check("partition of unity", unity, 1e-14);
    tests::check("Greville abscissae reproduce x", linear, 1e-14);
    tests::check("extraction reproduces Cox and de Boor", extraction, 1e-14);
    tests::check("elements", operators.size() - (points.size() - 1.), 0.);
  }

  /// Borden, Scott, Evans, Hughes 2011, section 4: the cubic with knots 0 0 0 0 1 2 3 4 4 4 4.
  void log_published_operators()
  {
    const auto operators = KnotVector(3, {0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4}).extraction_operators();
    for (unsigned int e = 0; e < 2; ++e)
      for (unsigned int a = 0; a < 4; ++a)
      {
        tests::log() << "12 C^" << e + 1 << ":";
        for (unsigned int b = 0; b < 4; ++b)
          tests::log() << ' ' << std::lround(12e6 * operators[e][4 * a + b]) / 1e6;
        tests::log() << std::endl;
      }
  }

  void log_knots(const std::string &what, const std::vector<double> &values)
  {
    tests::log() << what << ":";
    for (const double x : values)
      tests::log() << ' ' << x;
    tests::log() << std::endl;
  }

  std::vector<double> refined(const std::vector<double> &breakpoints, const unsigned int n)
  {
    std::vector<double> t = breakpoints;
    t.insert(t.begin(), t.front());
    t.push_back(t.back());
    const KnotVector first(1, t);
    std::vector<spline::ControlPoint> net(2 * first.n_functions());
    NurbsPatch patch({{first, KnotVector::uniform(1, 1)}}, net);
    patch.refine_to(0, n);
    return patch.knots(0).breakpoints();
  }

  void check_symmetric_refinement()
  {
    double asymmetry = 0.;
    for (unsigned int n = 5; n <= 40; ++n) // an odd number of elements: any n
    {
      const auto points = refined({0, 1, 2.5, 3.7, 5.2, 6.2}, n);
      asymmetry += std::abs(points.size() - (n + 1.)); // none may be missing
      for (unsigned int k = 0; k < points.size(); ++k)
        asymmetry = std::max(asymmetry, std::abs(points[k] + points[n - k] - 6.2));
    }
    for (unsigned int n = 4; n <= 40; n += 2) // an even number of elements: even n
    {
      const auto points = refined({0, 1, 3, 5, 6}, n);
      for (unsigned int k = 0; k < points.size(); ++k)
        asymmetry = std::max(asymmetry, std::abs(points[k] + points[n - k] - 6.));
    }
    tests::check("asymmetry of refined symmetric knot vectors", asymmetry, 1e-14);
  }

  template <typename Action>
  void log_error(const Action &action)
  {
    try
    {
      action();
      tests::log() << "NO ERROR" << std::endl;
    }
    catch (const InputError &error)
    {
      tests::log() << error.what() << std::endl;
    }
  }
} // namespace

int main()
{
  log_published_operators();
  for (const KnotVector &k : knots)
    check_basis(k);
  check_basis(KnotVector::uniform(6, 5));

  const NurbsPatch patch = random_patch();
  NurbsPatch finer = patch;
  finer.insert_knots(0, {0.45, 0.7 - 1e-3, 0.2, 0.9});
  finer.insert_knots(1, {0.1, -0.99, 1.3, 1.3, 0.7});
  tests::check("knot insertion", difference(patch, finer), 1e-14);

  NurbsPatch higher = patch;
  higher.elevate_degree(0);
  higher.elevate_degree(1, 2);
  tests::check("degree elevation", difference(patch, higher), 1e-14);
  log_knots("elevated knots", higher.knots(0).knots());

  higher.refine_to(0, 9);
  higher.refine_to(1, 13);
  tests::check("elevation, then refinement", difference(patch, higher), 1e-14);

  const spline::Surface surface = to_surface(finer);
  check(surface, "extracted patch");
  double extraction = 0.;
  const auto u = finer.knots(0).breakpoints(), v = finer.knots(1).breakpoints();
  for (unsigned int e = 0; e < surface.elements.size(); ++e)
  {
    const unsigned int i = e % (u.size() - 1), j = e / (u.size() - 1);
    const spline::Point<2> xi(0.3, 0.8),
        there(u[i] + 0.3 * (u[i + 1] - u[i]), v[j] + 0.8 * (v[j + 1] - v[j]));
    extraction = std::max(
        extraction,
        (spline::evaluate(surface, {e, xi})[spline::value] - patch.evaluate(there)).norm());
  }
  tests::check("Bezier extraction", extraction / 10., 1e-14);
  for (const char *name : {"left", "nextTop"})
  {
    const auto *set = surface.find_set(spline::SetKind::node, name);
    tests::log() << name << ": " << set->members.size() << " from " << set->members.front()
                 << " to " << set->members.back() << std::endl;
  }

  log_knots("refined", refined({0, 1, 2, 3}, 5));
  log_knots("refined", refined({0, 1, 2, 3}, 7));
  log_knots("refined", refined({0, 1, 4}, 4));
  log_knots("refined", refined({0, 1, 2, 3, 4}, 5));
  log_knots("refined", refined({0, 1, 2, 3, 4, 5.5}, 7));
  check_symmetric_refinement();

  log_error([] { KnotVector(2, {0, 0, 0, 0.5, 0.4, 1, 1, 1}); });
  log_error([] { KnotVector(2, {0, 0, 0.5, 1, 1, 1}); });
  log_error([] { KnotVector(2, {0, 0, 0, 0.5, 0.5, 0.5, 1, 1, 1}); });
  log_error([] { KnotVector(1, {0, 0, std::nan(""), 1, 1}); });
  log_error([] { random_patch().insert_knots(0, {1.}); });
  log_error([] { random_patch().refine_to(0, 2); });
}
