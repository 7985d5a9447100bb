// SPDX-License-Identifier: LGPL-2.1-or-later
// Surfaces as rational Bezier cells: the files are read back and evaluated as VTK does.
#include "../tests.h"
#include "vtu_reader.h"

#include <semilunar/output/bezier_cell.h>
#include <semilunar/output/surface_vtu.h>
#include <semilunar/spline/evaluation.h>
#include <semilunar/spline/primitives.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/polynomials_bernstein.h>

using namespace semilunar;
using semilunar::tests::check;
using spline::Tensor;

/// Where VTK looks for the node (i,j) of a cell of the given degrees.
unsigned int vtk_node(const unsigned int i, const unsigned int j, const unsigned int p,
                      const unsigned int q)
{
  const bool i_end = i == 0 || i == p, j_end = j == 0 || j == q;
  if (i_end && j_end)
    return j == 0 ? (i == 0 ? 0 : 1) : (i == 0 ? 3 : 2);
  if (j_end)
    return 4 + (i - 1) + (j == 0 ? 0 : p + q - 2);
  if (i_end)
    return 4 + (j - 1) + (i == p ? p - 1 : 2 * p + q - 3);
  return 4 + 2 * (p + q - 2) + (j - 1) * (p - 1) + (i - 1);
}

/// The Bezier cells of a file.
struct Cells
{
  explicit Cells(const tests::VtuReader &file)
      : points(file.array("Points")), connectivity(file.array("connectivity")),
        offsets(file.array("offsets")), weights(file.array("RationalWeights")),
        degrees(file.array("HigherOrderDegrees"))
  {
  }

  /// Interpolate an array of the points in a cell.
  std::vector<double> evaluate(const std::vector<double> &array, const unsigned int cell,
                               const dealii::Point<2> &xi) const
  {
    const unsigned int n = array.size() / weights.size();
    const unsigned int p = degrees[3 * cell], q = degrees[3 * cell + 1];
    std::vector<double> sum(n, 0.);
    double denominator = 0.;
    for (unsigned int j = 0; j <= q; ++j)
      for (unsigned int i = 0; i <= p; ++i)
      {
        const unsigned int begin = cell == 0 ? 0 : offsets[cell - 1];
        const unsigned int k = connectivity[begin + vtk_node(i, j, p, q)];
        const double basis = weights[k] * dealii::PolynomialsBernstein<double>(i, p).value(xi[0]) *
                             dealii::PolynomialsBernstein<double>(j, q).value(xi[1]);
        denominator += basis;
        for (unsigned int c = 0; c < n; ++c)
          sum[c] += basis * array[k * n + c];
      }
    for (double &s : sum)
      s /= denominator;
    return sum;
  }

  std::vector<double> points, connectivity, offsets, weights, degrees;
};

/// A quarter of a cylinder of radius 2 in elements of degrees (3,2), and apart from it a bilinear
/// square.
spline::Surface two_pieces()
{
  spline::NurbsPatch shell = spline::cylinder(2., 0., dealii::numbers::PI / 2, 0., 1.);
  shell.elevate_degree(0, 1);
  shell.elevate_degree(1, 1);
  shell.refine_to(0, 3);
  shell.refine_to(1, 2);
  spline::Surface surface = spline::to_surface(shell);
  spline::append(
      surface,
      spline::to_surface(spline::quadrilateral({{{5, 0, 0}, {6, 0, 0}, {5, 1, 0}, {6, 1, 1}}})),
      -1.);
  return surface;
}

const std::vector<dealii::Point<2>> samples{{0., 0.}, {1., 0.}, {0.3, 0.8}, {0.5, 1.}, {0.9, 0.2}};

double smooth(const Tensor<1, 3> &x)
{
  return std::exp(0.5 * x[0]) * std::cos(x[1]) + x[2];
}

double norm(const Tensor<1, 3> &x, const std::vector<double> &y)
{
  return (x - Tensor<1, 3>({y[0], y[1], y[2]})).norm();
}

void test_node_order()
{
  tests::log() << "order of nodes, degrees 3 and 2:";
  for (const unsigned int b : output::vtk_node_order({{3, 2}}))
    tests::log() << ' ' << b;
  double mismatches = 0;
  for (const unsigned int p : {1, 2, 4})
    for (const unsigned int q : {1, 3, 5})
    {
      const auto order = output::vtk_node_order({{p, q}});
      for (unsigned int b = 0; b < (p + 1) * (q + 1); ++b)
        mismatches += order[vtk_node(b % (p + 1), b / (p + 1), p, q)] != b;
    }
  tests::log() << "\nmismatches for other degrees: " << mismatches << std::endl;
}

void test_file(const bool compress)
{
  const spline::Surface surface = two_pieces();
  const std::vector<Tensor<1, 3>> x = spline::positions(surface);
  std::vector<Tensor<1, 3>> displacements;
  for (const Tensor<1, 3> &y : x)
    displacements.push_back(Tensor<1, 3>({0.1 * y[1] * y[2], std::sin(y[0]), y[2] - y[0]}));
  const output::SurfaceField field{
      "smooth", 1, [&surface](const spline::SurfacePoint &point, double *values) {
        values[0] = smooth(spline::evaluate(surface, point)[spline::value]);
      }};
  output::SurfaceVtuParameters parameters;
  parameters.compress = compress;
  output::write_surface_vtu(
      "bezier.vtu", surface, x,
      {output::control_point_field("displacement", surface, displacements), field}, parameters,
      0.25);

  const tests::VtuReader file("bezier.vtu");
  const Cells cells(file);
  const auto u = file.array("displacement"), s = file.array("smooth");
  double position_error = 0., radius_error = 0., u_error = 0., s_error = 0.;
  for (unsigned int e = 0; e < surface.elements.size(); ++e)
    for (const auto &xi : samples)
    {
      spline::BasisValues basis;
      spline::evaluate_basis(surface, e, xi, basis);
      const auto &element = surface.elements[e];
      const auto position = cells.evaluate(cells.points, e, xi);
      const Tensor<1, 3> exact = spline::interpolate(element, basis, x)[spline::value];
      position_error = std::max(position_error, norm(exact, position));
      if (e < 6)
        radius_error = std::max(radius_error, std::abs(std::hypot(position[0], position[1]) - 2.));
      u_error = std::max(u_error, norm(spline::interpolate(element, basis, displacements)[0],
                                       cells.evaluate(u, e, xi)));
      if (e < 6)
        s_error = std::max(s_error, std::abs(cells.evaluate(s, e, xi)[0] - smooth(exact)));
    }
  tests::log() << (compress ? "compressed" : "plain") << ", time " << file.array("TimeValue")[0]
               << ", cells " << cells.offsets.size() << std::endl;
  check("position against the spline", position_error, 1e-12);
  check("distance from the cylinder", radius_error, 1e-12);
  check("displacement (single precision)", u_error, 1e-6);
  check("field outside of the space", s_error, 3e-3);
  tests::log() << "element, part, type, degrees:";
  for (unsigned int e = 0; e < cells.offsets.size(); ++e)
    tests::log() << "  " << file.array("element")[e] << ' ' << file.array("part")[e] << ' '
                 << file.array("types")[e] << ' ' << cells.degrees[3 * e] << ' '
                 << cells.degrees[3 * e + 1];
  tests::log() << "\nattributes: " << file.has("<PointData RationalWeights=\"RationalWeights\">")
               << ' ' << file.has("<CellData HigherOrderDegrees=\"HigherOrderDegrees\">")
               << std::endl;
}

/// The error of interpolated cubic cells falls with the fourth power of the size of the elements.
void test_interpolation_order()
{
  double previous = 0.;
  for (const unsigned int n : {4, 8})
  {
    spline::NurbsPatch patch = spline::cylinder(1., 0., dealii::numbers::PI / 2, 0., 1.);
    patch.elevate_degree(0, 1);
    patch.elevate_degree(1, 2);
    patch.refine_to(0, n);
    patch.refine_to(1, n);
    const spline::Surface surface = spline::to_surface(patch);
    const output::SurfaceField field{
        "smooth", 1, [&surface](const spline::SurfacePoint &point, double *values) {
          values[0] = smooth(spline::evaluate(surface, point)[spline::value]);
        }};
    output::write_surface_vtu("order.vtu", surface, spline::positions(surface), {field}, {}, 0.);
    const tests::VtuReader file("order.vtu");
    const Cells cells(file);
    const auto values = file.array("smooth");
    double error = 0.;
    for (unsigned int e = 0; e < n * n; ++e)
      for (const auto &xi : samples)
        error =
            std::max(error, std::abs(cells.evaluate(values, e, xi)[0] -
                                     smooth(spline::evaluate(surface, {e, xi})[spline::value])));
    if (previous > 0.)
      check("order of interpolation, minus 4", std::log2(previous / error) - 4., 0.5);
    previous = error;
  }
}

int main()
{
  test_node_order();
  test_file(false);
  test_file(true);
  test_interpolation_order();
}
