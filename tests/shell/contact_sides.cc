// SPDX-License-Identifier: LGPL-2.1-or-later
// The side of a neighbor on which a point belongs: plates pushed through each other come back, on
// both faces; beyond an edge the side is forgotten; parts that touch from the start are at rest.
#include "../tests.h"
#include "contact_cases.h"

using namespace semilunar;
using namespace semilunar::tests;

namespace
{
  ContactParameters parameters()
  {
    ContactParameters p;
    p.distance = 0.02;
    p.stiffness = 1e7;
    p.smoothing = 0.;
    return p;
  }

  const Tensor<1, 3> up({0., 0., 1.}), along({1., 0., 0.});

  void log_force(const std::string &what, const Pair &pair)
  {
    const double f = pair.force()[2];
    log() << what << ": "
          << (f > 0.   ? "pushed up"
              : f < 0. ? "pushed down"
                       : "no force")
          << std::endl;
  }

  void push_through(const double side)
  {
    log() << (side > 0. ? "plate above" : "plate below") << std::endl;
    Pair pair(plate({0, 0, 0}, 1., 1., 3, 3), plate({0.1, 0.1, side * 0.05}, 0.6, 0.6, 2, 2),
              parameters());
    const double safe = pair.contact.safe_displacement();
    log() << "reach " << pair.contact.reach() << ", safe displacement " << safe << std::endl;
    pair.move_second(-0.04 * side * up);
    log_force("  close to the surface", pair);
    pair.move_second(-0.03 * side * up);
    log_force("  pushed through within a step", pair);
    check("    penetration beyond the midsurface",
          pair.contact.largest_penetration() - (0.02 + 0.02), 1e-12);
    pair.contact.accept();
    pair.move_second(-0.005 * side * up);
    log_force("  accepted there and pushed on", pair);
    pair.move_second(0.045 * side * up);
    log_force("  back by a contact distance", pair);
    check("    penetration", pair.contact.largest_penetration(), 1e-12);
    pair.contact.accept();
    pair.move_second(-2. * safe * side * up);
    log_force("  through by twice the safe displacement", pair);
  }

  void around_the_edge()
  {
    log() << "around the free edge" << std::endl;
    Pair pair(plate({0, 0, 0}, 1., 1., 3, 3), plate({0.8, 0.3, 0.03}, 0.15, 0.4, 2, 2),
              parameters());
    const unsigned int n_steps = 8;
    const std::pair<std::string, Tensor<1, 3>> path[] = {
        {"out", 0.3 * along}, {"down", -0.06 * up}, {"in", -0.3 * along}, {"up", 0.02 * up}};
    for (const auto &[name, leg] : path)
    {
      double largest = 0.;
      for (unsigned int step = 0; step < n_steps; ++step)
      {
        pair.move_second(leg / n_steps);
        largest = std::max(largest, pair.contact.largest_penetration());
        pair.contact.accept();
      }
      log() << "  " << name << ": "
            << (largest > 0. ? largest < 0.02 ? "touching" : "CAUGHT" : "free") << std::endl;
    }
    log_force("  now on the other side", pair);
  }

  /// A plate that moves beside an edge touches it by its distance alone, continuously from one side
  /// to the other.
  void roll_over_the_edge()
  {
    Pair pair(plate({0, 0, 0}, 1., 1., 3, 3), plate({1.01, 0.3, 0.03}, 0.15, 0.4, 2, 2),
              parameters());
    const unsigned int n_steps = 600;
    double previous = 0., largest_jump = 0., largest = 0.;
    for (unsigned int step = 0; step <= n_steps; ++step)
    {
      pair.move_second(step == 0 ? 0. * up : -0.06 / n_steps * up);
      const double energy = pair.contact.energy();
      if (step > 0)
        largest_jump = std::max(largest_jump, std::abs(energy - previous));
      previous = energy;
      largest = std::max(largest, energy);
    }
    log() << "past the edge, from above to below in one step: energy "
          << (largest > 0. && largest_jump < 0.05 * largest ? "smooth" : "JUMPS") << std::endl;
  }

  void close_from_the_start()
  {
    // a wedge: touching along x = 0
    const Surface roof = refined(spline::quadrilateral({{Point<3>(0, 0, 0), Point<3>(1, 0, 0.1),
                                                         Point<3>(0, 1, 0), Point<3>(1, 1, 0.1)}}),
                                 8, 2);
    Pair pair(plate({0, 0, 0}, 1., 1., 8, 2), roof, parameters());
    pair.contact.update(pair.x);
    check("wedge undeformed: energy", pair.contact.energy(), 0.);
    log() << "wedge undeformed: gap where apart "
          << (pair.contact.gaps().back() > 0.05 ? "open" : "CLOSED") << std::endl;
    pair.move_second(-0.001 * up);
    // the roof's points see the plate at their height; slanted feet on the roof are off by cosines
    check("wedge closed by 0.001: penetration", pair.contact.largest_penetration() / 0.001 - 1.,
          1e-2);
    log_force("wedge closed by 0.001", pair);
  }
} // namespace

int main()
{
  push_through(1.);
  push_through(-1.);
  around_the_edge();
  roll_over_the_edge();
  close_from_the_start();
}
