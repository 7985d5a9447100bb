// SPDX-License-Identifier: LGPL-2.1-or-later
// STEP and IGES files: patches come back as they were written, joined where they share edges.
#include "../tests.h"

#include <semilunar/core/exceptions.h>
#include <semilunar/spline/cad_file.h>
#include <semilunar/spline/primitives.h>

#include <algorithm>

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

  void round_trip(const std::string &filename, const std::vector<NurbsPatch> &patches)
  {
    write_cad(patches, filename);
    const std::vector<NurbsPatch> back = read_cad(filename);
    double error = 0.;
    for (unsigned int k = 0; k < std::min(patches.size(), back.size()); ++k)
      error = std::max(error, largest_distance(patches[k], back[k]));
    const Surface surface = join(back, 3, 1e-6);
    const std::vector<unsigned int> parts = connected_parts(surface);
    log() << filename << ": " << back.size() << " patches, joined to "
          << 1 + *std::max_element(parts.begin(), parts.end()) << " part, "
          << surface.elements.size() << " elements, " << surface.control_points.size()
          << " control points" << std::endl;
    check("same surfaces", error, 1e-10);
  }

  void refused(const std::string &filename)
  {
    try
    {
      read_cad(filename);
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
  std::vector<NurbsPatch> patches{cylinder(1.1, 0., 1., 0., 0.7), cylinder(1.1, 1., 1.9, 0., 0.7),
                                  annulus(1.1, 1.4, 0., 1.)};
  patches[0].elevate_degree(0, 1);
  patches[0].insert_knots(1, {0.3});
  patches[1].elevate_degree(0, 1);
  patches[1].insert_knots(1, {0.3});
  round_trip("pieces.step", patches);
  round_trip("pieces.iges", patches);
  round_trip("elements.stp", bezier_patches(join({patches[0], patches[1]}, 3, 1e-9)));
  refused("missing.step");
  std::ofstream("nonsense.stp") << "nothing of the kind";
  refused("nonsense.stp");
}
