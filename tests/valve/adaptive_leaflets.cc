// SPDX-License-Identifier: LGPL-2.1-or-later
// Leaflets refined where elements are marked: deformed surfaces stay what they are, meshes stay
// suitable and symmetric whatever is marked, held edges stay held; sizes of elements in files.
#include "../tests.h"
#include "mirror_images.h"

#include <semilunar/core/exceptions.h>
#include <semilunar/spline/evaluation.h>
#include <semilunar/spline/t_junctions.h>
#include <semilunar/valve/adaptive_leaflets.h>
#include <semilunar/valve/element_sizes.h>
#include <semilunar/valve/leaflet_t_spline.h>
#include <semilunar/valve/leaflets.h>
#include <semilunar/valve/symmetry.h>

#include <functional>

using namespace semilunar;
using namespace semilunar::spline;
using tests::check;
using tests::log;
using valve::AdaptiveLeaflets;
using valve::Design;
using Vectors = std::vector<Tensor<1, 3>>;

namespace
{
  Design coarse(const unsigned int n_leaflets = 3)
  {
    Design design;
    design.layout = valve::LeafletLayout::t_spline;
    design.n_leaflets = n_leaflets;
    design.zones.attachment.levels = 0;
    design.zones.commissures.levels = 1;
    return design;
  }

  /// The point with parameters (u, v) of leaflet k with control points at x.
  Tensor<1, 3> point_at(const TSpline &leaflet, const Surface &surface, const Vectors &x,
                        const unsigned int k, const Point<2> &u)
  {
    const auto boxes = bezier_boxes(leaflet.mesh());
    for (unsigned int b = 0; b < boxes.size(); ++b)
    {
      Point<2> xi;
      for (unsigned int d = 0; d < 2; ++d)
      {
        const double low = leaflet.parameter(d, boxes[b].low[d]);
        xi[d] = (u[d] - low) / (leaflet.parameter(d, boxes[b].high[d]) - low);
      }
      if (xi[0] < 0. || xi[0] > 1. || xi[1] < 0. || xi[1] > 1.)
        continue;
      const unsigned int e = k * boxes.size() + b;
      BasisValues basis;
      evaluate_basis(surface, e, xi, basis);
      return interpolate(surface.elements[e], basis, x)[value];
    }
    return Tensor<1, 3>();
  }

  /// A motion of the control points that keeps those of two rows at the attachment.
  Vectors moved(const Surface &surface)
  {
    Vectors x = positions(surface);
    for (unsigned int a = 0; a < x.size(); ++a)
      for (unsigned int i = 0; i < 3; ++i)
        x[a][i] += 0.1 * std::sin(7. * a + i);
    for (const char *const name : {"attachment", "nextAttachment"})
      for (const unsigned int a : surface.find_set(SetKind::node, name)->members)
        x[a] = surface.control_points[a].position;
    return x;
  }

  double largest_at_attachment(const Surface &surface, const Vectors &x)
  {
    double largest = 0.;
    for (const char *const name : {"attachment", "nextAttachment"})
      for (const unsigned int a : surface.find_set(SetKind::node, name)->members)
        largest = std::max(largest, (x[a] - surface.control_points[a].position).norm());
    return largest;
  }

  /// Rounds of refinement, of which all elements are on the last leaflet and on one side.
  void refinement(const std::string &name, const Design &design, const unsigned int n_leaflets)
  {
    AdaptiveLeaflets leaflets(design, n_leaflets);
    Surface surface = leaflets.surface();
    Vectors x = moved(surface);
    double moved_by = 0., held = 0.;
    for (unsigned int round = 0; round < 4; ++round)
    {
      const TSpline before = leaflets.leaflet();
      const unsigned int n = surface.elements.size() / n_leaflets;
      const RefinementMatrix matrix =
          leaflets.refine({(n_leaflets - 1) * n + n / 7, (n_leaflets - 1) * n + n - 1 - round});
      const Surface finer = leaflets.surface();
      const Vectors y = refined(matrix, surface.control_points, x);
      for (unsigned int k = 0; k < n_leaflets; ++k)
        for (const Point<2> u : {Point<2>(0.013, 0.98), Point<2>(0.31, 0.17), Point<2>(0.52, 0.6),
                                 Point<2>(0.94, 0.07), Point<2>(0.99, 0.97)})
          moved_by = std::max(moved_by, (point_at(before, surface, x, k, u) -
                                         point_at(leaflets.leaflet(), finer, y, k, u))
                                            .norm());
      held = std::max(held, largest_at_attachment(finer, y));
      surface = finer;
      x = y;
    }
    spline::check(surface, name);
    check(name + ": deformed surface moved", moved_by, 2e-14);
    check(name + ": held edge moved", held, 1e-14);
    if (n_leaflets > 1)
      check(name + ": leaflets alike", valve::rotational_asymmetry(surface, positions(surface)),
            1e-12);
    check(name + ": mirrored", tests::asymmetry(surface), 1e-12);
    log() << "  " << surface.elements.size() << " elements, " << surface.control_points.size()
          << " control points, " << crossings(leaflets.leaflet().mesh()).size() << " crossings"
          << std::endl;
  }

  void expect_error(const std::function<void()> &action)
  {
    try
    {
      action();
      log() << "ACCEPTED" << std::endl;
    }
    catch (const InputError &error)
    {
      log() << error.what() << std::endl;
    }
  }

  void write_text(const std::string &text)
  {
    std::ofstream("elements.csv") << text;
  }

  /// A mesh made anew from the sizes of another one is the same; a finer grid stays finer.
  void sizes()
  {
    AdaptiveLeaflets leaflets(coarse(), 1);
    for (unsigned int round = 0; round < 5; ++round)
      leaflets.refine({3u + round, 20u});
    valve::ElementSizes(leaflets.leaflet()).write("elements.csv");
    Design design = coarse();
    design.zones.sizes_file = "elements.csv";
    const auto vertices_of = [](const TSpline &leaflet) { return vertices(leaflet.mesh()); };
    log() << "the same mesh: "
          << (vertices_of(valve::leaflet_t_spline(design)) == vertices_of(leaflets.leaflet()))
          << std::endl;
    design.zones.n_elements_along = 18;
    const TSpline other = valve::leaflet_t_spline(design);
    const valve::ElementSizes wanted(std::filesystem::path("elements.csv"));
    unsigned int n_too_large = 0;
    for (const BezierBox &box : bezier_boxes(other.mesh()))
      n_too_large += wanted.is_too_large(
          Point<2>(other.parameter(0, box.low[0]), other.parameter(1, box.low[1])),
          Point<2>(other.parameter(0, box.high[0]), other.parameter(1, box.high[1])));
    log() << "another grid: " << n_too_large << " elements too large" << std::endl;

    design.zones.sizes_file = "none.csv";
    expect_error([&]() { valve::leaflet_t_spline(design); });
    design.zones.sizes_file = "elements.csv";
    write_text("time,x\n");
    expect_error([&]() { valve::leaflet_t_spline(design); });
    for (const char *const line : {"0,0,1,1.5", "0.5,0,0.4,1", "0,0,1", "0,0,1e-7,1", "a,b,c,d"})
    {
      write_text(std::string("u_low,v_low,u_high,v_high\n0,0,1,1\n") + line + "\n");
      expect_error([&]() { valve::leaflet_t_spline(design); });
    }
    design.layout = valve::LeafletLayout::uniform;
    expect_error([&]() { AdaptiveLeaflets(design, 1); });
  }
} // namespace

int main()
{
  refinement("three leaflets", coarse(), 3);
  refinement("two leaflets", coarse(2), 2);
  refinement("one leaflet", coarse(), 1);
  Design oval = coarse();
  oval.ellipticity = 0.8;
  AdaptiveLeaflets leaflets(oval, 3);
  leaflets.refine({0});
  log() << "oval: " << leaflets.surface().elements.size() << " elements" << std::endl;
  sizes();
}
