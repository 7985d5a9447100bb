// SPDX-License-Identifier: LGPL-2.1-or-later
//
// One sector of a body with cyclic symmetry touches the images of itself: its share of energy and
// forces against those of the whole body, and its tangent against differences.
#include <algorithm>

#include "../tests.h"
#include "contact_cases.h"

using namespace semilunar;
using namespace semilunar::tests;

namespace
{
  constexpr unsigned int n_sectors = 3;

  const ContactParameters parameters = []()
  {
    ContactParameters p;
    p.distance = 0.1;
    p.stiffness = 1e3;
    p.smoothing = 0.02;
    return p;
  }();

  /// A curved strip that leans over the axis, so that it touches both of its images.
  Surface sector()
  {
    return refined(spline::cylinder(0.8, -0.5, 0.5, -0.6, 0.6), 4, 3);
  }

  /// Moved so that the sector is close to its images at different distances and angles; bumps keep
  /// the forces from vanishing by another symmetry.
  Vectors deformed(const Surface &surface)
  {
    Vectors x = positions(surface);
    for (auto &p : x)
    {
      const double y = p[1], z = p[2];
      p[0] += -0.72 + 0.9 * std::abs(y) * 0.57735 + 0.03 * std::sin(3. * y + 2. * z) + 0.01 * z;
    }
    return x;
  }

  Vectors gradient(const Contact &contact, const unsigned int n)
  {
    Vectors g(n);
    contact.add_gradient(g);
    return g;
  }

  double largest(const Vectors &v)
  {
    double result = 0.;
    for (const auto &u : v)
      result = std::max(result, u.norm());
    return result;
  }

  Vectors hessian_times(const Contact &contact, const Vectors &v)
  {
    Vectors result(v.size());
    contact.add_hessian(
        [&](const std::vector<unsigned int> &control_points, const std::vector<double> &matrix)
        {
          const unsigned int n = 3 * control_points.size();
          for (unsigned int i = 0; i < n; ++i)
            for (unsigned int j = 0; j < n; ++j)
              result[control_points[i / 3]][i % 3] +=
                  matrix[i * n + j] * v[control_points[j / 3]][j % 3];
        });
    return result;
  }
} // namespace

int main()
{
  const spline::CyclicSymmetry symmetry(n_sectors);
  const Surface surface = sector();
  const QuadraturePoints points(surface);
  Contact contact(surface, points, parameters, symmetry);
  const Vectors x = deformed(surface);
  contact.update(x);

  const Surface whole_surface = symmetry.whole(surface);
  const QuadraturePoints whole_points(whole_surface);
  Contact whole(whole_surface, whole_points, parameters);
  whole.update(symmetry.whole(x));

  const unsigned int n_touching =
      std::count_if(contact.contact_points().begin(), contact.contact_points().end(),
                    [](const auto &point) { return point.pressure > 0.; });
  const unsigned int n_on_second_image =
      std::count_if(contact.contact_points().begin(), contact.contact_points().end(),
                    [](const auto &point) { return point.pressure > 0. && point.image == 2; });
  log() << "touching points " << n_touching << ", on the second image " << n_on_second_image
        << std::endl;
  check("energy", n_sectors * contact.energy() / whole.energy() - 1., 1e-12);
  check("contact area", contact.contact_areas()[0] / whole.contact_areas()[1] - 1., 1e-12);
  check("penetration", contact.largest_penetration() / whole.largest_penetration() - 1., 1e-12);

  const Vectors g = gradient(contact, x.size()), whole_g = gradient(whole, n_sectors * x.size());
  Vectors difference = symmetry.whole(g);
  for (unsigned int i = 0; i < difference.size(); ++i)
    difference[i] -= whole_g[i];
  check("forces", largest(difference) / largest(g), 1e-11);

  // any deformation of the sector
  Vectors v(x.size());
  for (unsigned int i = 0; i < v.size(); ++i)
    v[i] = Tensor<1, 3>({std::sin(1. + 2. * i), std::cos(3. * i), std::sin(5. + 7. * i * i)});
  const Vectors hv = hessian_times(contact, v);
  const double step = 1e-6;
  Vectors forward = x, backward = x;
  for (unsigned int i = 0; i < x.size(); ++i)
  {
    forward[i] += step * v[i];
    backward[i] -= step * v[i];
  }
  double work = 0.;
  for (unsigned int i = 0; i < x.size(); ++i)
    work += g[i] * v[i];
  contact.update(forward);
  const double energy_forward = contact.energy();
  difference = gradient(contact, x.size());
  contact.update(backward);
  check("work against difference of energy",
        (energy_forward - contact.energy()) / (2. * step) / work - 1., 1e-6);
  const Vectors g_backward = gradient(contact, x.size());
  for (unsigned int i = 0; i < x.size(); ++i)
    difference[i] = (difference[i] - g_backward[i]) / (2. * step) - hv[i];
  check("tangent against difference of forces", largest(difference) / largest(hv), 1e-6);
}
