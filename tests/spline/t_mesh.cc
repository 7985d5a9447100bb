// SPDX-License-Identifier: LGPL-2.1-or-later
// T-meshes: refinement keeps them analysis-suitable at a cost that grows linearly, local knot
// vectors and extensions of a mesh that can be followed by hand, and meshes that are not suitable.
#include "../tests.h"

#include <semilunar/core/exceptions.h>
#include <semilunar/spline/t_junctions.h>
#include <semilunar/spline/t_spline.h>

#include <random>

using namespace semilunar;
using namespace semilunar::spline;
using tests::log;

namespace
{
  std::string place(const double x)
  {
    std::ostringstream text;
    text << x / TMesh::unit;
    return text.str();
  }

  void log_knots(const BlendingFunction &function)
  {
    log() << "function at (" << place(function.vertex[0]) << ", " << place(function.vertex[1])
          << "), shifts " << function.shift[0] << ", " << function.shift[1] << ":";
    for (const auto &knots : function.knots)
    {
      for (const TMesh::Coordinate x : knots)
        log() << ' ' << place(x);
      log() << (&knots == &function.knots[0] ? " x" : "");
    }
    log() << std::endl;
  }

  /// Halving the middle of 5 x 5 elements once: two T-junctions, at (2.5, 2) and (2.5, 3).
  void small_mesh()
  {
    TMesh mesh({{5, 5}}, 3);
    mesh.halve(12);
    for (const TJunction &junction : t_junctions(mesh))
      log() << "T-junction at (" << place(junction.vertex[0]) << ", " << place(junction.vertex[1])
            << "), sign " << junction.sign << ": extension from " << place(junction.behind)
            << " to " << place(junction.ahead) << std::endl;
    for (const BlendingFunction &function : blending_functions(mesh))
    {
      const bool at_junction = function.vertex[0] == 5 * TMesh::unit / 2;
      const bool in_corner = function.vertex == mesh.element(0).low;
      const bool beside = function.vertex == mesh.element(12).low;
      if (at_junction || in_corner || beside)
        log_knots(function);
    }
    log() << mesh.n_active() << " elements, " << blending_functions(mesh).size() << " functions, "
          << bezier_boxes(mesh).size() << " Bezier elements" << std::endl;
  }

  /// Elements chosen at random, again and again; and a corner, an edge and a point.
  void stays_suitable(const unsigned int degree)
  {
    std::mt19937 random(1);
    unsigned int n_meshes = 0, n_bad = 0, n_marked = 0, n_halved = 0;
    for (unsigned int trial = 0; trial < 20; ++trial)
    {
      TMesh mesh({{3 + trial % 4, 4 + trial % 3}}, degree);
      for (unsigned int step = 0; step < 12; ++step, ++n_meshes)
      {
        const std::vector<unsigned int> active = mesh.active_elements();
        std::vector<unsigned int> marked{active[random() % active.size()]};
        if (trial % 2 == 0)
          marked.push_back(active.back()); // the finest ones, as adaptive refinement marks them
        n_marked += marked.size();
        n_halved += mesh.refine(marked);
        n_bad += !crossings(mesh).empty();
      }
    }
    log() << "degree " << degree << ": " << n_meshes << " meshes, " << n_bad
          << " not suitable; halved per marked element " << std::setprecision(3)
          << double(n_halved) / n_marked << std::setprecision(8) << std::endl;
  }

  /// Halving elements around a corner carelessly makes extensions meet.
  void not_suitable()
  {
    TMesh mesh({{6, 6}}, 3);
    const unsigned int e = 2 * 6 + 2; // low corner at (2, 2)
    mesh.halve(e);
    const unsigned int left = mesh.find(mesh.element(e).low, 1, 1);
    mesh.halve(left);
    log() << crossings(mesh, 100).size() << " crossings" << std::endl;
    try
    {
      check_suitable(mesh, "careless");
      log() << "NO COMPLAINT" << std::endl;
    }
    catch (const InputError &error)
    {
      log() << error.what() << std::endl;
    }
  }

  /// The number of halvings for one marked element at a point does not grow with the depth.
  void linear_cost()
  {
    TMesh mesh({{4, 4}}, 3);
    unsigned int n_halved = 0;
    log() << "elements halved by every 4th refinement towards a point:";
    for (unsigned int k = 0; k < 24; ++k)
    {
      const unsigned int e =
          mesh.find({{TMesh::unit + TMesh::unit / 3, 2 * TMesh::unit - 5461}}, 1, 1);
      n_halved = mesh.refine({e});
      if (k % 4 == 3)
        log() << ' ' << n_halved;
    }
    log() << std::endl << "suitable: " << crossings(mesh).empty() << std::endl;
  }
} // namespace

int main()
{
  small_mesh();
  stays_suitable(3);
  stays_suitable(5);
  not_suitable();
  linear_cost();
}
