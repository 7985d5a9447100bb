// SPDX-License-Identifier: LGPL-2.1-or-later
// Surfaces as linear cells, the collection of files over time, and folders that cannot be written.
#include "../tests.h"
#include "vtu_reader.h"

#include <semilunar/core/exceptions.h>
#include <semilunar/output/pvd.h>
#include <semilunar/output/surface_vtu.h>
#include <semilunar/spline/evaluation.h>
#include <semilunar/spline/primitives.h>

#include <deal.II/base/numbers.h>

using namespace semilunar;
using semilunar::tests::check;
using spline::Tensor;

spline::Surface quarter_cylinder()
{
  spline::NurbsPatch patch = spline::cylinder(2., 0., dealii::numbers::PI / 2, 0., 1.);
  patch.refine_to(0, 2);
  patch.refine_to(1, 2);
  return spline::to_surface(patch);
}

Tensor<1, 3> point_of(const std::vector<double> &points, const unsigned int i)
{
  return Tensor<1, 3>({points[3 * i], points[3 * i + 1], points[3 * i + 2]});
}

/// Every point lies where the spline is at its place in the element's grid, and the cells cover the
/// surface once, all facing outward.
void test_cells()
{
  const spline::Surface surface = quarter_cylinder();
  const output::SurfaceField field{"angle", 1,
                                   [&surface](const spline::SurfacePoint &point, double *values)
                                   {
                                     const auto x = spline::evaluate(surface, point)[spline::value];
                                     values[0] = std::atan2(x[1], x[0]);
                                   }};
  output::SurfaceVtuParameters parameters;
  parameters.cells = output::CellKind::linear;
  parameters.subdivisions = 10;
  output::write_surface_vtu("linear.vtu", surface, spline::positions(surface), {field}, parameters,
                            0.);

  const tests::VtuReader file("linear.vtu");
  const auto points = file.array("Points"), angles = file.array("angle");
  double error = 0., field_error = 0.;
  for (unsigned int k = 0; k < angles.size(); ++k)
  {
    const unsigned int n = k % 121;
    const auto exact = spline::evaluate(surface, {k / 121, {(n % 11) / 10., (n / 11) / 10.}})[0];
    error = std::max(error, (point_of(points, k) - exact).norm());
    field_error = std::max(field_error, std::abs(angles[k] - std::atan2(exact[1], exact[0])));
  }
  const auto connectivity = file.array("connectivity");
  double area = 0.;
  for (unsigned int c = 0; c < connectivity.size(); c += 4)
  {
    std::array<Tensor<1, 3>, 4> x;
    for (unsigned int v = 0; v < 4; ++v)
      x[v] = point_of(points, connectivity[c + v]);
    const Tensor<1, 3> normal = dealii::cross_product_3d(x[2] - x[0], x[3] - x[1]) / 2.;
    area += normal * Tensor<1, 3>({x[0][0], x[0][1], 0.}) > 0. ? normal.norm() : -normal.norm();
  }
  tests::log() << "points " << angles.size() << ", cells " << file.array("types").size()
               << ", of the last element " << file.array("element").back() << ", type "
               << file.array("types")[0] << ", end of the last cell "
               << file.array("offsets").back() << std::endl;
  check("position against the spline", error, 1e-12);
  check("field (single precision)", field_error, 1e-6);
  check("area, relative", area / dealii::numbers::PI - 1., 1e-3);
}

std::string attribute(const std::string &tag, const std::string &name)
{
  const std::size_t begin = tag.find(' ' + name + "=\"") + name.size() + 3;
  return tag.substr(begin, tag.find('"', begin) - begin);
}

void test_collection()
{
  output::PvdCollection collection("run.pvd");
  collection.add(0., "surface-0000.vtu");
  collection.add(0.1, "surface-0001.vtu");
  std::ifstream file("run.pvd");
  for (std::string line; std::getline(file, line);)
    if (line.find("<DataSet") != std::string::npos)
      tests::log() << attribute(line, "timestep") << ' ' << attribute(line, "file") << std::endl;
  tests::log() << "partial file left behind: " << std::ifstream("run.pvd.part").good() << std::endl;
}

template <class Action>
void expect_input_error(const Action &action)
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

int main()
{
  test_cells();
  test_collection();
  expect_input_error(
      []
      {
        const spline::Surface surface = quarter_cylinder();
        output::write_surface_vtu("nowhere/x.vtu", surface, spline::positions(surface), {}, {}, 0.);
      });
  expect_input_error([] { output::PvdCollection("nowhere/x.pvd").add(0., "x.vtu"); });
}
