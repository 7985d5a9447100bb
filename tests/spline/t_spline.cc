// SPDX-License-Identifier: LGPL-2.1-or-later
// T-splines: the surface does not change under refinement, old functions are the sums of new ones
// that the refinement matrix says, functions sum to one and are linearly independent, Bezier
// extraction is exact, and the cost is linear.
#include "../tests.h"

#include <semilunar/core/exceptions.h>
#include <semilunar/spline/evaluation.h>
#include <semilunar/spline/primitives.h>
#include <semilunar/spline/surface_check.h>
#include <semilunar/spline/t_junctions.h>
#include <semilunar/spline/t_spline.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <ctime>
#include <random>

using namespace semilunar;
using namespace semilunar::spline;
using tests::check;
using tests::log;

namespace
{
  std::mt19937 random_number(5);

  /// A B-spline by the recursion (S6), independent of the program's blossoms.
  double b_spline(const double *t, const unsigned int p, const double x)
  {
    if (p == 0)
      return t[0] <= x && x < t[1] ? 1. : 0.;
    const double low = t[p] > t[0] ? (x - t[0]) / (t[p] - t[0]) * b_spline(t, p - 1, x) : 0.;
    const double high =
        t[p + 1] > t[1] ? (t[p + 1] - x) / (t[p + 1] - t[1]) * b_spline(t + 1, p - 1, x) : 0.;
    return low + high;
  }

  std::vector<double> function_values(const TSpline &spline, const Point<2> &u)
  {
    std::vector<double> values;
    for (const BlendingFunction &function : spline.functions())
    {
      const std::vector<double> x = spline.knots(function, 0), y = spline.knots(function, 1);
      const unsigned int p = x.size() - 2;
      values.push_back(b_spline(x.data(), p, u[0]) * b_spline(y.data(), p, u[1]));
    }
    return values;
  }

  Point<3> point(const TSpline &spline, const Point<2> &u)
  {
    const std::vector<double> values = function_values(spline, u);
    Tensor<1, 3> sum;
    double weight = 0.;
    for (unsigned int a = 0; a < values.size(); ++a)
    {
      const ControlPoint &control = spline.control_points()[a];
      weight += values[a] * control.weight;
      sum += values[a] * control.weight * control.position;
    }
    return Point<3>(sum / weight);
  }

  Point<2> random_point()
  {
    std::uniform_real_distribution<double> uniform(0., 1.);
    return {uniform(random_number), uniform(random_number)};
  }

  /// A rational patch with uneven knots: part of a sphere, distorted.
  NurbsPatch rational_patch(const unsigned int degree)
  {
    NurbsPatch patch = sphere(2., 0., 1.5, -0.5, 1.);
    for (unsigned int d = 0; d < 2; ++d)
    {
      patch.elevate_degree(d, degree - patch.knots(d).degree());
      patch.insert_knots(d, {0.15, 0.4, 0.5, 0.9});
    }
    std::uniform_real_distribution<double> uniform(-0.1, 0.1);
    std::vector<ControlPoint> net = patch.control_net();
    for (ControlPoint &control : net)
    {
      control.position[2] += uniform(random_number);
      control.weight *= 1. + uniform(random_number);
    }
    return NurbsPatch({{patch.knots(0), patch.knots(1)}}, net);
  }

  std::vector<unsigned int> some_elements(const TMesh &mesh)
  {
    const std::vector<unsigned int> active = mesh.active_elements();
    return {active[random_number() % active.size()], active.back()};
  }

  /// Largest error of N_old = sum of matrix entries times N_new.
  double refinement_error(const TSpline &old, const TSpline &refined,
                          const RefinementMatrix &matrix)
  {
    double error = 0.;
    for (unsigned int k = 0; k < 30; ++k)
    {
      const Point<2> u = random_point();
      std::vector<double> coarse = function_values(old, u);
      const std::vector<double> fine = function_values(refined, u);
      for (unsigned int a = 0; a < matrix.size(); ++a)
        for (unsigned int c = 0; c < matrix[a].columns.size(); ++c)
          coarse[matrix[a].columns[c]] -= matrix[a].values[c] * fine[a];
      for (const double difference : coarse)
        error = std::max(error, std::abs(difference));
    }
    return error;
  }

  /// @param bound of round-off: blossoms extrapolate further at higher degree
  void refinement(const unsigned int degree, const double bound)
  {
    const NurbsPatch patch = rational_patch(degree);
    TSpline spline(patch);
    double matrix_error = 0., surface_error = 0., partition_error = 0.;
    for (unsigned int step = 0; step < 8; ++step)
    {
      const TSpline old = spline;
      const RefinementMatrix matrix = spline.refine(some_elements(spline.mesh()));
      matrix_error = std::max(matrix_error, refinement_error(old, spline, matrix));
    }
    for (unsigned int k = 0; k < 100; ++k)
    {
      const Point<2> u = random_point();
      surface_error = std::max(surface_error, point(spline, u).distance(patch.evaluate(u)));
      double sum = -1.;
      for (const double value : function_values(spline, u))
        sum += value;
      partition_error = std::max(partition_error, std::abs(sum));
    }
    log() << "degree " << degree << ": " << spline.mesh().n_active() << " elements, "
          << spline.functions().size() << " functions, " << t_junctions(spline.mesh()).size()
          << " T-junctions" << std::endl;
    check("functions before are sums of functions after", matrix_error, bound);
    check("surface unchanged", surface_error, bound);
    check("functions sum to one", partition_error, 1e-13);
  }

  /// Bezier elements against the functions themselves, all control points and derivatives.
  void extraction()
  {
    TSpline spline(rational_patch(3));
    for (unsigned int step = 0; step < 8; ++step)
      spline.refine(some_elements(spline.mesh()));
    const Surface surface = to_surface(spline);
    spline::check(surface, "T-spline");
    const std::vector<BezierBox> boxes = bezier_boxes(spline.mesh());
    double error = 0.;
    for (unsigned int b = 0; b < boxes.size(); ++b)
    {
      const Point<2> xi = random_point();
      Point<2> u;
      for (unsigned int d = 0; d < 2; ++d)
      {
        const double low = spline.parameter(d, boxes[b].low[d]);
        u[d] = low + xi[d] * (spline.parameter(d, boxes[b].high[d]) - low);
      }
      const Tensor<1, 3> x = evaluate(surface, {b, xi})[value];
      error = std::max(error, (x - point(spline, u)).norm());
    }
    log() << "Bezier elements: " << boxes.size() << " of " << spline.mesh().n_active()
          << " elements" << std::endl;
    check("Bezier elements are the surface", error, 1e-13);
  }

  /// The rank of the matrix of all functions at points of all Bezier elements.
  void linear_independence()
  {
    TSpline spline(rational_patch(3));
    for (unsigned int step = 0; step < 10; ++step)
      spline.refine(some_elements(spline.mesh()));
    const Surface surface = to_surface(spline);
    const unsigned int n = surface.control_points.size(), per_element = 16;
    dealii::LAPACKFullMatrix<double> matrix(surface.elements.size() * per_element, n);
    BasisValues basis;
    for (unsigned int e = 0, row = 0; e < surface.elements.size(); ++e)
      for (unsigned int k = 0; k < per_element; ++k, ++row)
      {
        evaluate_basis(surface, e, Point<2>((k % 4 + 0.5) / 4., (k / 4 + 0.5) / 4.), basis);
        for (unsigned int a = 0; a < surface.elements[e].n_functions(); ++a)
          matrix(row, surface.elements[e].control_points[a]) = basis.values[value][a];
      }
    matrix.compute_svd();
    unsigned int rank = 0;
    while (rank < n && matrix.singular_value(rank) > 1e-8 * matrix.singular_value(0))
      ++rank;
    log() << "functions " << n << ", rank " << rank << std::endl;
  }

  /// A grid that is not refined is the patch, element by element.
  void unrefined()
  {
    const NurbsPatch patch = rational_patch(3);
    const Surface expected = to_surface(patch), actual = to_surface(TSpline(patch));
    double error = 0.;
    bool same = expected.elements.size() == actual.elements.size();
    for (unsigned int e = 0; e < actual.elements.size() && same; ++e)
    {
      same = expected.elements[e].control_points == actual.elements[e].control_points;
      for (unsigned int k = 0; k < actual.elements[e].extraction.size() && same; ++k)
        error = std::max(
            error, std::abs(expected.elements[e].extraction[k] - actual.elements[e].extraction[k]));
    }
    for (unsigned int s = 0; s < expected.sets.size(); ++s)
      same = same && expected.sets[s].members == actual.sets[s].members;
    log() << "unrefined: " << (same ? "same functions and sets" : "DIFFERENT") << std::endl;
    check("same extraction", error, 1e-14);
  }

  /// Processor seconds for refinement towards the diagonal and extraction.
  double seconds(const unsigned int halvings, unsigned int &n_elements)
  {
    const std::clock_t start = std::clock();
    NurbsPatch patch = quadrilateral({{Point<3>(0., 0., 0.), Point<3>(1., 0., 0.),
                                       Point<3>(0., 1., 0.), Point<3>(1., 1., 0.3)}});
    for (unsigned int d = 0; d < 2; ++d)
    {
      patch.elevate_degree(d, 2);
      patch.refine_to(d, 8);
    }
    TSpline spline(patch);
    spline.refine_where([=](const Point<2> &low, const Point<2> &high, const unsigned int level)
                        { return level < halvings && low[0] <= high[1] && low[1] <= high[0]; });
    n_elements = to_surface(spline).elements.size();
    return double(std::clock() - start) / CLOCKS_PER_SEC;
  }

  void cost()
  {
    unsigned int n_few, n_many;
    const double few = seconds(12, n_few), many = seconds(16, n_many);
    std::fprintf(stderr, "%u elements %g s, %u elements %g s\n", n_few, few, n_many, many);
    check("time per element grows with their number (factor)", (many / n_many) / (few / n_few), 2.);
    check("seconds for 50000 elements", many / n_many * 50000., 20.);
  }

  void refused(const NurbsPatch &patch)
  {
    try
    {
      TSpline{patch};
      log() << "NO COMPLAINT" << std::endl;
    }
    catch (const InputError &error)
    {
      log() << error.what() << std::endl;
    }
  }
} // namespace

int main()
{
  unrefined();
  refinement(3, 1e-13);
  refinement(5, 2e-12);
  extraction();
  linear_independence();
  cost();
  NurbsPatch patch = sphere(1., 0., 1., 0., 1.);
  refused(patch);
  patch = rational_patch(3);
  patch.insert_knots(0, {0.4});
  refused(patch);
}
