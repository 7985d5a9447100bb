// SPDX-License-Identifier: LGPL-2.1-or-later
// STEP and IGES files: patches come back as they were written, joined where they share edges.
#include "../tests.h"

#include <semilunar/core/exceptions.h>
#include <semilunar/spline/cad_file.h>
#include <semilunar/spline/evaluation.h>
#include <semilunar/spline/patches.h>
#include <semilunar/spline/primitives.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <gp_Circ.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Pln.hxx>
#include <STEPControl_Writer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>

#include <algorithm>
#include <functional>
#include <sstream>

using namespace semilunar;
using namespace semilunar::spline;
using tests::check;
using tests::log;

namespace
{
  double largest_distance(const NurbsPatch &a, const NurbsPatch &b)
  {
    double largest = 0.;
    for (unsigned int k = 0; k < 100; ++k)
    {
      std::array<Point<2>, 2> u;
      const Point<2> share(std::fmod(k * 0.6180339887, 1.), std::fmod(k * 0.7548776662, 1.));
      for (unsigned int i = 0; i < 2; ++i)
        for (unsigned int d = 0; d < 2; ++d)
        {
          const std::vector<double> &t = (i == 0 ? a : b).knots(d).knots();
          u[i][d] = t.front() + share[d] * (t.back() - t.front());
        }
      largest = std::max(largest, a.evaluate(u[0]).distance(b.evaluate(u[1])));
    }
    return largest;
  }

  unsigned int n_parts(const Surface &surface)
  {
    const std::vector<unsigned int> parts = connected_parts(surface);
    return 1 + *std::max_element(parts.begin(), parts.end());
  }

  void round_trip(const std::string &filename, const std::vector<NurbsPatch> &patches)
  {
    write_cad(patches, filename);
    const std::vector<NurbsPatch> back = read_cad(filename);
    double error = 0.;
    for (unsigned int k = 0; k < std::min(patches.size(), back.size()); ++k)
      error = std::max(error, largest_distance(patches[k], back[k]));
    const Surface surface = join(back, 3, 1e-6);
    log() << filename << ": " << back.size() << " patches, joined to " << n_parts(surface)
          << " part, " << surface.elements.size() << " elements, " << surface.control_points.size()
          << " control points" << std::endl;
    check("same surfaces", error, 1e-10);
  }

  /// Neighbours that miss each other by a little are joined only within the tolerance.
  void gaps(const NurbsPatch &first, NurbsPatch second)
  {
    std::vector<ControlPoint> net = second.control_net();
    for (ControlPoint &point : net)
      point.position[2] += 1e-4;
    second = NurbsPatch({{second.knots(0), second.knots(1)}}, net);
    log() << "a gap of 1e-4: " << n_parts(join({first, second}, 3, 1e-5)) << " parts within 1e-5, "
          << n_parts(join({first, second}, 3, 1e-3)) << " within 1e-3" << std::endl;
  }

  /// Files of another program, in millimetres.
  void write_face(const TopoDS_Face &face, const std::string &filename)
  {
    STEPControl_Writer writer;
    writer.Transfer(face, STEPControl_AsIs);
    writer.Write(filename.c_str());
  }

  /// A quarter of a cylinder that is no spline, normal outward or inward.
  void cylinder_of_others(const bool reversed)
  {
    const TopoDS_Face face =
        BRepBuilderAPI_MakeFace(gp_Cylinder(gp::XOY(), 11.), 0., M_PI / 2., 0., 7.).Face();
    write_face(reversed ? TopoDS::Face(face.Reversed()) : face, "cylinder.step");
    const Surface surface = to_surface(read_cad("cylinder.step").at(0));
    double off = 0.;
    for (unsigned int k = 0; k <= 20; ++k)
    {
      const Tensor<1, 3> x = evaluate(surface, {0, {k / 20., k / 20.}})[value];
      off = std::max(off, std::abs(std::hypot(x[0], x[1]) - 1.1));
    }
    check("radius of a cylinder [cm]", off, 1e-14);
    const SurfaceJet jet = evaluate(surface, {0, {0.3, 0.4}});
    const bool outward = cross_product_3d(jet[d1], jet[d2]) * jet[value] > 0.;
    log() << "its normal points " << (outward ? "outward" : "inward") << std::endl;
  }

  void refused(const std::function<void()> &action)
  {
    try
    {
      action();
      log() << "NO COMPLAINT" << std::endl;
    }
    catch (const InputError &error)
    {
      log() << error.what() << std::endl;
    }
  }

  void refused(const std::string &filename)
  {
    refused([&]() { read_cad(filename); });
  }

  /// The first half of a file.
  void truncate(const std::string &filename, const std::string &half)
  {
    std::ostringstream text;
    text << std::ifstream(filename).rdbuf();
    std::ofstream(half) << text.str().substr(0, text.str().size() / 2);
  }
} // namespace

int main()
{
  std::vector<NurbsPatch> patches{cylinder(1.1, 0., 1., 0., 0.7), cylinder(1.1, 1., 1.9, 0., 0.7),
                                  annulus(1.1, 1.4, 0., 1.)};
  patches[0].elevate_degree(0, 1);
  patches[0].insert_knots(1, {0.3});
  patches[1].elevate_degree(0, 1);
  patches[1].insert_knots(1, {0.3});
  round_trip("pieces.step", patches);
  round_trip("pieces.iges", patches);
  round_trip("elements.stp", bezier_patches(join({patches[0], patches[1]}, 3, 1e-9)));
  gaps(patches[0], patches[1]);
  cylinder_of_others(false);
  cylinder_of_others(true);

  refused("missing.step");
  std::ofstream("nonsense.stp") << "nothing of the kind";
  refused("nonsense.stp");
  truncate("pieces.step", "half.step");
  refused("half.step");
  const TopoDS_Wire circle =
      BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Circ(gp::XOY(), 5.)).Edge()).Wire();
  write_face(BRepBuilderAPI_MakeFace(gp_Pln(gp::XOY()), circle).Face(), "disc.step");
  refused("disc.step");
  write_cad({}, "empty.igs");
  refused("empty.igs");
  refused([&]() { write_cad(patches, "no-such-folder/pieces.step"); });
}
