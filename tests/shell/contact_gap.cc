// SPDX-License-Identifier: LGPL-2.1-or-later
// Gap and pressure of patches whose distance is known, the force between parallel plates,
// conservation of momentum, and the equal treatment of the parts.
#include <semilunar/core/exceptions.h>

#include <deal.II/base/parameter_handler.h>

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
    p.smoothing = 0.004;
    return p;
  }

  void parallel_plates()
  {
    Pair pair(plate({0, 0, 0}, 1., 0.5, 5, 3), plate({0, 0, 0.05}, 1., 0.5, 4, 4), parameters());
    pair.move_second(Tensor<1, 3>());
    check("parallel plates apart: force", pair.force().norm(), 0.);
    check("parallel plates apart: gap", pair.contact.gaps()[0] - 0.03, 1e-15);
    double travelled = 0.;
    for (const double penetration : {0.002, 0.004, 0.008})
    {
      pair.move_second(Tensor<1, 3>({0., 0., -0.03 - penetration - travelled}));
      travelled = -0.03 - penetration;
      const double pressure = penetration < 0.004 ? 1e7 * penetration * penetration / 0.008
                                                  : 1e7 * (penetration - 0.002);
      log() << "penetration " << penetration << ", force " << pair.force()[2] << std::endl;
      check("  force over pressure times area", pair.force()[2] / (0.5 * pressure) - 1., 1e-11);
      check("  pressure", pair.contact.pressures()[7] / pressure - 1., 1e-11);
      check("  penetration", pair.contact.largest_penetration() / penetration - 1., 1e-11);
      check("  contact area", pair.contact.contact_areas()[1] / 0.5 - 1., 1e-12);
    }
    const double linear = 0.008, onset = 0.004;
    const double energy = 1e7 * (linear * linear / 2. - onset * linear / 2. + onset * onset / 6.);
    check("energy", pair.contact.energy() / (0.5 * energy) - 1., 1e-11);
  }

  /// Largest error of the gaps of the points of one part.
  double gap_error(const Pair &pair, const unsigned int part, const double contact_distance,
                   const std::function<double(const Tensor<1, 3> &)> &distance)
  {
    double largest = 0.;
    unsigned int n = 0;
    for (const Contact::ContactPoint &point : pair.contact.contact_points())
    {
      const bool is_second = point.q >= pair.points.n_points() / 2;
      if (is_second != (part == 1))
        continue;
      const Tensor<1, 3> x =
          evaluate(pair.surface, {pair.points.element(point.q), pair.points.xi(point.q)})[0];
      largest = std::max(largest, std::abs(point.gap + contact_distance - distance(x)));
      ++n;
    }
    log() << n << " points of part " << part << " near: ";
    return largest;
  }

  void known_distances()
  {
    const ContactParameters p = parameters();
    // upper plate rises from 0.03 to 0.05 over the length 1 and lies inside of the lower one
    const Surface tilted =
        refined(spline::quadrilateral({{Point<3>(0.2, 0.2, 0.03), Point<3>(1.2, 0.2, 0.05),
                                        Point<3>(0.2, 0.8, 0.03), Point<3>(1.2, 0.8, 0.05)}}),
                4, 4);
    Pair tilt(plate({0, 0, 0}, 1.5, 1., 4, 4), tilted, p);
    tilt.contact.update(tilt.x);
    check("tilted plate above a larger one",
          gap_error(tilt, 1, p.distance, [](const Tensor<1, 3> &x) { return x[2]; }), 1e-14);

    Pair tubes(refined(spline::cylinder(1., 0., 2., 0., 1.), 8, 4),
               refined(spline::cylinder(1.04, 0., 2., 0., 1.), 8, 4), p);
    tubes.contact.update(tubes.x);
    const auto radius = [](const Tensor<1, 3> &x) { return std::hypot(x[0], x[1]); };
    check("outer one of coaxial cylinders",
          gap_error(tubes, 1, p.distance, [&](const Tensor<1, 3> &x) { return radius(x) - 1.; }),
          1e-13);
    check("inner one of coaxial cylinders",
          gap_error(tubes, 0, p.distance, [&](const Tensor<1, 3> &x) { return 1.04 - radius(x); }),
          1e-13);

    // the upright plate's lower edge is the line y = 0.5, z = 0.03 above the lower plate
    const Surface upright =
        refined(spline::quadrilateral({{Point<3>(-0.1, 0.5, 0.03), Point<3>(1.1, 0.5, 0.03),
                                        Point<3>(-0.1, 0.5, 0.5), Point<3>(1.1, 0.5, 0.5)}}),
                4, 4);
    Pair edge(plate({0, 0, 0}, 1., 1., 4, 4), upright, p);
    edge.contact.update(edge.x);
    check("plate below an edge",
          gap_error(edge, 0, p.distance,
                    [](const Tensor<1, 3> &x) { return std::hypot(x[1] - 0.5, 0.03); }),
          1e-14);
    edge.move_second(Tensor<1, 3>({0., 0., -0.025}));
    log() << "force of the plate on the edge: " << (edge.force()[2] > 0. ? "upward" : "DOWNWARD")
          << std::endl;
  }

  Surface wavy_plate(const double z, const double phase)
  {
    Surface surface = plate({0.1 * phase, 0.05, z}, 1., 0.8, 5, 4);
    for (spline::ControlPoint &point : surface.control_points)
    {
      auto &x = point.position;
      x[2] += 0.05 * std::sin(4. * x[0] + phase) * std::cos(3. * x[1] - phase);
      point.weight = 1. + 0.1 * std::sin(7. * x[0] + phase);
    }
    return surface;
  }

  void momentum_and_symmetry()
  {
    const Surface a = wavy_plate(0., 0.), b = wavy_plate(0.13, 0.3);
    Pair ab(a, b, parameters()), ba(b, a, parameters());
    ab.move_second(Tensor<1, 3>({0.03, 0.02, -0.11}));
    for (unsigned int i = 0; i < ba.n_first; ++i)
      ba.x[i] += Tensor<1, 3>({0.03, 0.02, -0.11});
    ba.contact.update(ba.x);

    const Vectors g = ab.gradient(), swapped = ba.gradient();
    Tensor<1, 3> force, moment;
    double size = 0., difference = 0.;
    for (unsigned int i = 0; i < g.size(); ++i)
    {
      force += g[i];
      moment += cross_product_3d(ab.x[i], g[i]);
      size += g[i].norm();
      difference += (g[i] - swapped[(i + ba.n_first) % g.size()]).norm();
    }
    check("wavy plates: sum of forces", force.norm() / size, 1e-14);
    check("wavy plates: sum of moments", moment.norm() / size, 1e-12);
    check("wavy plates swapped: forces", difference / size, 1e-12);
    check("wavy plates swapped: energy", ba.contact.energy() / ab.contact.energy() - 1., 1e-12);
    log() << "points in contact: " << (ab.contact.contact_areas()[0] > 0.01 ? "many" : "FEW")
          << std::endl;
  }

  /// A plate between two others touches both.
  void sandwich()
  {
    Surface surface = plate({0, 0, 0}, 1., 1., 3, 3);
    append(surface, plate({0, 0, 0.04}, 1., 1., 2, 3), -1.);
    const unsigned int end = surface.control_points.size();
    Pair pair(surface, plate({0, 0, 0.08}, 1., 1., 3, 2), parameters());
    const unsigned int begin = plate({0, 0, 0}, 1., 1., 3, 3).control_points.size();
    for (unsigned int i = begin; i < end; ++i)
      pair.x[i][2] -= 0.03;
    pair.move_second(Tensor<1, 3>({0., 0., -0.06})); // gaps of 0.01 on both sides
    const Vectors g = pair.gradient();
    Tensor<1, 3> middle;
    for (unsigned int i = begin; i < end; ++i)
      middle += g[i];
    check("plate between two others: force on it", middle[2] / pair.force()[2], 1e-12);
    check("  force on the upper one", pair.force()[2] / (1e7 * (0.01 - 0.002)) - 1., 1e-11);
  }

  void user_input()
  {
    dealii::ParameterHandler prm;
    ContactParameters read;
    read.add_parameters(prm);
    prm.parse_input_from_string("subsection Contact\n set Enabled = true\n set Distance = 0.03\n"
                                " set Stiffness = 2e7\n set Smoothing = 0.002\n"
                                " set Self distance = 0.2\nend\n");
    log() << "parameters: " << read.enabled << " " << read.distance << " " << read.stiffness << " "
          << read.smoothing << " " << read.self_distance << std::endl;

    ContactParameters p = parameters();
    p.self_distance = 0.01;
    const Surface surface = plate({0, 0, 0}, 1., 1., 1, 1);
    const QuadraturePoints points(surface);
    try
    {
      Contact contact(surface, points, p);
      log() << "accepted a self distance below the contact distance" << std::endl;
    }
    catch (const InputError &error)
    {
      log() << error.what() << std::endl;
    }
  }
} // namespace

int main()
{
  parallel_plates();
  known_distances();
  momentum_and_symmetry();
  sandwich();
  user_input();
}
