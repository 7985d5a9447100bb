// SPDX-License-Identifier: LGPL-2.1-or-later
// Gradient and Hessian of the contact energy against finite differences, for feet inside of
// strongly curved surfaces, at edges and at corners, and at the onset of contact.
#include "../tests.h"
#include "contact_cases.h"

using namespace semilunar;
using namespace semilunar::tests;

namespace
{
  /// Random directions that are the same on any machine.
  struct Directions
  {
    double number()
    {
      state = state * 6364136223846793005ull + 1442695040888963407ull;
      return double(state >> 11) / double(1ull << 52) - 1.;
    }
    Vectors operator()(const unsigned int n)
    {
      Vectors v(n);
      for (auto &u : v)
        for (unsigned int d = 0; d < 3; ++d)
          u[d] = number();
      return v;
    }
    unsigned long long state = 1;
  };

  Vectors sum(const Vectors &x, const double factor, const Vectors &v)
  {
    Vectors result = x;
    for (unsigned int i = 0; i < x.size(); ++i)
      result[i] += factor * v[i];
    return result;
  }

  double dot(const Vectors &a, const Vectors &b)
  {
    double result = 0.;
    for (unsigned int i = 0; i < a.size(); ++i)
      result += a[i] * b[i];
    return result;
  }

  Vectors gradient(Contact &contact, const Vectors &x)
  {
    contact.update(x);
    Vectors g(x.size());
    contact.add_gradient(g);
    return g;
  }

  double energy(Contact &contact, const Vectors &x)
  {
    contact.update(x);
    return contact.energy();
  }

  /// The Hessian times v; @p asymmetry the largest asymmetry of a block over its largest entry.
  Vectors hessian_times(const Contact &contact, const Vectors &v, double &asymmetry)
  {
    Vectors result(v.size());
    contact.add_hessian(
        [&](const std::vector<unsigned int> &control_points, const std::vector<double> &matrix)
        {
          const unsigned int n = 3 * control_points.size();
          double largest = 0., difference = 0.;
          for (unsigned int i = 0; i < n; ++i)
            for (unsigned int j = 0; j < n; ++j)
            {
              result[control_points[i / 3]][i % 3] +=
                  matrix[i * n + j] * v[control_points[j / 3]][j % 3];
              largest = std::max(largest, std::abs(matrix[i * n + j]));
              difference = std::max(difference, std::abs(matrix[i * n + j] - matrix[j * n + i]));
            }
          asymmetry = std::max(asymmetry, difference / largest);
        });
    return result;
  }

  void report_feet(const Contact &contact)
  {
    unsigned int n_edge = 0, n_face = 0;
    for (const Contact::ContactPoint &point : contact.contact_points())
      if (point.pressure > 0.)
      {
        const auto &xi = point.partner.xi;
        const bool at_side = xi[0] == 0. || xi[0] == 1. || xi[1] == 0. || xi[1] == 1.;
        ++(at_side ? n_edge : n_face);
      }
    log() << "feet inside: " << (n_face ? "some" : "none")
          << ", at edges: " << (n_edge ? "some" : "none") << std::endl;
  }

  void check_derivatives(Contact &contact, const Vectors &x, const double step)
  {
    Directions directions;
    const Vectors g = gradient(contact, x);
    report_feet(contact);
    double gradient_error = 0., hessian_error = 0., asymmetry = 0.;
    for (unsigned int trial = 0; trial < 3; ++trial)
    {
      const Vectors v = directions(x.size());
      contact.update(x);
      const Vectors Hv = hessian_times(contact, v, asymmetry);
      const auto slope = [&](const double h)
      { return (energy(contact, sum(x, h, v)) - energy(contact, sum(x, -h, v))) / (2. * h); };
      const double dg = (4. * slope(step) - slope(2. * step)) / 3.;
      gradient_error =
          std::max(gradient_error, std::abs(dg - dot(g, v)) / std::sqrt(dot(g, g) * dot(v, v)));
      const auto change = [&](const double h)
      {
        Vectors result = gradient(contact, sum(x, h, v));
        result = sum(result, -1., gradient(contact, sum(x, -h, v)));
        return sum(Vectors(x.size()), 0.5 / h, result);
      };
      Vectors d = sum(sum(Vectors(x.size()), 4. / 3., change(step)), -1. / 3., change(2. * step));
      d = sum(d, -1., Hv);
      hessian_error = std::max(hessian_error, std::sqrt(dot(d, d) / dot(Hv, Hv)));
    }
    check("  gradient against differences of the energy", gradient_error, 1e-7);
    check("  Hessian against differences of the gradient", hessian_error, 1e-7);
    check("  asymmetry of the blocks", asymmetry, 1e-14);
  }

  ContactParameters parameters(const double distance)
  {
    ContactParameters p;
    p.distance = distance;
    p.stiffness = 1e4;
    p.smoothing = 0.;
    return p;
  }

  /// Bend and stretch all parts, without a symmetry.
  void deform(Vectors &x)
  {
    for (auto &p : x)
    {
      const auto u = p;
      p[0] += 0.05 * std::sin(3. * u[1] + u[2]);
      p[1] += 0.04 * std::cos(4. * u[0]) + 0.02 * u[2];
      p[2] += 0.06 * std::sin(2. * u[0] + 3. * u[1]);
    }
  }

  void faces()
  {
    // a spherical cap inside of a larger one, radii 1 and 1.2, comes near enough everywhere
    log() << "sphere in sphere" << std::endl;
    Pair pair(refined(spline::sphere(1., 0.3, 1., 0.1, 0.8), 3, 3),
              refined(spline::sphere(1.4, 0., 1.3, -0.2, 1.1), 4, 4), parameters(0.35));
    for (unsigned int i = 0; i < pair.n_first; ++i)
      pair.x[i] *= 1.15;
    deform(pair.x);
    check_derivatives(pair.contact, pair.x, 1e-6);
  }

  void edges()
  {
    log() << "upright plate on a plate: lower edge and corners" << std::endl;
    const Surface upright =
        refined(spline::quadrilateral({{Point<3>(0.2, 0.5, 0.3), Point<3>(0.8, 0.6, 0.3),
                                        Point<3>(0.2, 0.5, 0.9), Point<3>(0.8, 0.6, 0.9)}}),
                2, 2);
    Pair pair(plate({0, 0, 0}, 1., 1., 5, 5), upright, parameters(0.15));
    deform(pair.x);
    pair.move_second(Tensor<1, 3>({0., 0., -0.2}));
    check_derivatives(pair.contact, pair.x, 1e-6);
  }

  void onset()
  {
    log() << "smoothed onset" << std::endl;
    ContactParameters p = parameters(0.15);
    p.smoothing = 0.05;
    Pair pair(plate({0, 0, 0}, 1., 1., 3, 3), plate({0.1, 0.1, 0.2}, 0.8, 0.8, 2, 2), p);
    pair.x.back()[2] -= 0.1;
    pair.move_second(Tensor<1, 3>({0., 0., -0.06}));
    check_derivatives(pair.contact, pair.x, 1e-6);
  }
} // namespace

int main()
{
  faces();
  edges();
  onset();
}
