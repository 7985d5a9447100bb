// SPDX-License-Identifier: LGPL-2.1-or-later
// Designs within the allowed ranges give sound leaflets, refined meshes describe the same surface,
// and every impossible design gives one error that names its entry.
#include "../tests.h"

#include <semilunar/core/exceptions.h>
#include <semilunar/spline/evaluation.h>
#include <semilunar/valve/leaflets.h>
#include <semilunar/valve/refine.h>
#include <semilunar/valve/stent.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <functional>

using namespace semilunar;
using dealii::Point;
using dealii::Tensor;
using tests::check;
using valve::Design;

const double pi = dealii::numbers::PI;

struct Quality
{
  double smallest_angle = 180.; ///< between the parameter lines [degrees]
  double normal = 1.;           ///< smallest component along (1, 0, 1)/sqrt(2) on the first leaflet
  double clearance = 1e300;     ///< from the planes between the leaflets, in half post widths
  double off_belly = -1e300;    ///< how far outside of the cylinder, relative
};

Quality quality(const Design &design)
{
  Quality result;
  spline::NurbsPatch patch = valve::leaflet_patch(design);
  const spline::Surface surface = spline::to_surface(patch);
  for (unsigned int e = 0; e < surface.elements.size(); ++e)
    for (unsigned int i = 0; i <= 6; ++i)
      for (unsigned int j = 0; j <= 24; ++j)
      {
        const auto jet = spline::evaluate(surface, {e, Point<2>(i / 6., j / 24.)});
        const Tensor<1, 3> x = jet[spline::value];
        const Tensor<1, 3> normal = dealii::cross_product_3d(jet[spline::d1], jet[spline::d2]);
        const double J = normal.norm();
        const double sine = J / (jet[spline::d1].norm() * jet[spline::d2].norm());
        const double beside = x[0] * std::sin(pi / design.n_leaflets) -
                              std::abs(x[1]) * std::cos(pi / design.n_leaflets);
        result.smallest_angle =
            std::min(result.smallest_angle, std::asin(std::min(sine, 1.)) * 180. / pi);
        result.normal = std::min(result.normal, (normal[0] + normal[2]) / (J * std::sqrt(2.)));
        result.clearance = std::min(result.clearance, beside / (design.post_width / 2.));
        result.off_belly = std::max(result.off_belly, std::hypot(x[0], x[1]) / design.radius - 1.);
      }
  return result;
}

void sweep()
{
  const std::vector<std::pair<std::string, std::function<void(Design &)>>> changes{
      {"defaults", [](Design &) {}},
      {"19 mm", [](Design &d) { d.radius = 0.92; }},
      {"29 mm", [](Design &d) { d.radius = 1.41, d.stent.ring_outer_radius = 1.8; }},
      {"belly 0", [](Design &d) { d.belly = 0.; }},
      {"belly 0.5", [](Design &d) { d.belly = 0.5; }},
      {"deep belly", [](Design &d) { d.belly_height = -0.3; }},
      {"shallow belly", [](Design &d) { d.belly_height = 0.1; }},
      {"narrow belly", [](Design &d) { d.belly_width = 0.5; }},
      {"wide belly", [](Design &d) { d.belly_width = 1.; }},
      {"low free edge", [](Design &d) { d.free_edge_height = 0.6; }},
      {"high free edge", [](Design &d) { d.free_edge_height = 1.0; }},
      {"narrow gap", [](Design &d) { d.free_edge_gap = 0.02; }},
      {"wide gap", [](Design &d) { d.free_edge_gap = 0.3; }},
      {"open leaflets", [](Design &d) { d.free_edge_gap = 0.8; }},
      {"thin posts", [](Design &d) { d.post_width = 0.01; }},
      {"wide posts", [](Design &d) { d.post_width = 0.1, d.free_edge_gap = 0.1; }},
      {"low posts", [](Design &d) { d.commissure_height = 0.75, d.free_edge_height = 0.7; }},
      {"no straight post", [](Design &d) { d.post_foot_height = 0.8; }},
      {"flat scallop", [](Design &d) { d.post_foot_height = 0.12; }},
      {"two leaflets", [](Design &d) { d.n_leaflets = 2, d.belly_height = 0.; }}};
  tests::log() << "design: smallest angle of parameter lines, smallest normal component, clearance"
               << std::endl;
  for (const auto &[name, change] : changes)
  {
    Design design;
    change(design);
    const Quality q = quality(design);
    tests::log() << name << ": " << std::round(q.smallest_angle) << " degrees, "
                 << std::round(100. * q.normal) / 100. << ", "
                 << std::round(1000. * q.clearance) / 1000. << std::endl;
    if (!(q.smallest_angle > 10. && q.normal > 0. && q.clearance > 0.999 && q.off_belly < 1e-12))
      check(name + " is degenerate", 1., 0.);
  }
}

/// Refined patches against the coarsest one, and their elements' boundaries among each other.
void same_surface()
{
  const spline::NurbsPatch coarse = valve::leaflet_patch(Design());
  for (const unsigned int n : {16, 22})
  {
    std::vector<double> before;
    for (const unsigned int n_elements : {n, 2 * n, 4 * n})
    {
      spline::NurbsPatch fine = coarse;
      valve::refine(fine, 0, n_elements);
      valve::refine(fine, 1, n_elements);
      double largest = 0.;
      for (unsigned int k = 0; k < 300; ++k)
      {
        const Point<2> u(std::fmod(k * 0.6180339887, 1.), std::fmod(k * 0.7548776662, 1.));
        largest = std::max(largest, fine.evaluate(u).distance(coarse.evaluate(u)));
      }
      check("same surface", largest / 1.1175, 1e-13);
      const std::vector<double> now = fine.knots(0).breakpoints();
      const bool nested = std::includes(now.begin(), now.end(), before.begin(), before.end());
      double longest = 0., shortest = 1.;
      for (unsigned int e = 0; e < n_elements; ++e)
      {
        longest = std::max(longest, now[e + 1] - now[e]);
        shortest = std::min(shortest, now[e + 1] - now[e]);
      }
      tests::log() << n_elements << " elements, " << (nested ? "nested" : "NOT NESTED")
                   << ", longest by shortest: " << std::round(100. * longest / shortest) / 100.
                   << std::endl;
      before = now;
    }
  }
}

/// Logs the one message.
void impossible(const std::string &what, const std::function<void(Design &)> &change)
{
  Design design;
  change(design);
  try
  {
    design.check("Valve");
    tests::log() << what << ": ACCEPTED" << std::endl;
  }
  catch (const InputError &error)
  {
    tests::log() << error.what() << std::endl;
  }
}

/// Declaring the entries must not round the defaults.
void defaults_survive_declaration()
{
  Design declared;
  const Design design;
  dealii::ParameterHandler prm;
  declared.add_parameters(prm);
  check("declared defaults",
        std::abs(declared.radius - design.radius) +
            std::abs(declared.post_width - design.post_width) +
            std::abs(declared.belly_height - design.belly_height),
        0.);
  prm.set("Radius", 1.2);
  check("an entry bound", declared.radius - 1.2, 0.);
}

int main()
{
  sweep();
  same_surface();
  defaults_survive_declaration();
  impossible("leaflets", [](Design &d) { d.n_leaflets = 4; });
  impossible("radius not a number", [](Design &d) { d.radius = std::nan(""); });
  impossible("post too wide", [](Design &d) { d.post_width = 2.; });
  impossible("nadir below ring", [](Design &d) { d.nadir_height = -0.1; });
  impossible("foot below nadir", [](Design &d) { d.post_foot_height = 0.05; });
  impossible("commissure below foot", [](Design &d) { d.commissure_height = 0.3; });
  impossible("edge below nadir", [](Design &d) { d.free_edge_height = 0.05; });
  impossible("leaflets touch", [](Design &d) { d.free_edge_gap = 0.018; });
  impossible("edge at wall", [](Design &d) { d.free_edge_gap = 1.1; });
  impossible("belly", [](Design &d) { d.belly = 1.5; });
  impossible("belly above edge", [](Design &d) { d.belly_height = 0.9; });
  impossible("belly width", [](Design &d) { d.belly_width = 0.1; });
  impossible("too coarse", [](Design &d) { d.n_elements_along = 6; });
  impossible("odd", [](Design &d) { d.n_elements_along = 21; });
  impossible("nothing across", [](Design &d) { d.n_elements_across = 0; });
  impossible("ring inside", [](Design &d) { d.stent.ring_outer_radius = 1.; });
  impossible("no ring", [](Design &d) { d.stent.n_ring_elements = 0; });
}
