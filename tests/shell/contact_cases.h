// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_tests_contact_cases_h
#define semilunar_tests_contact_cases_h

#include <semilunar/shell/contact.h>
#include <semilunar/spline/primitives.h>

#include <functional>

namespace semilunar::tests
{
  using shell::Contact;
  using shell::ContactParameters;
  using shell::QuadraturePoints;
  using spline::Point;
  using spline::Surface;
  using spline::Tensor;
  using Vectors = std::vector<Tensor<1, 3>>;

  inline Surface refined(spline::NurbsPatch patch, const unsigned int n_1, const unsigned int n_2)
  {
    for (unsigned int direction = 0; direction < 2; ++direction)
    {
      patch.elevate_degree(direction, 3 - patch.knots(direction).degree());
      patch.refine_to(direction, direction == 0 ? n_1 : n_2);
    }
    return to_surface(patch);
  }

  /// The rectangle from a corner, normal +z.
  inline Surface plate(const Point<3> &corner, const double length, const double width,
                       const unsigned int n_1, const unsigned int n_2)
  {
    const Tensor<1, 3> l({length, 0., 0.}), w({0., width, 0.});
    return refined(spline::quadrilateral({{corner, corner + l, corner + w, corner + l + w}}), n_1,
                   n_2);
  }

  /// Both surfaces as parts of one, the first one's control points first.
  inline Surface together(Surface a, const Surface &b)
  {
    append(a, b, -1.);
    return a;
  }

  /// Two surfaces in contact: everything that a Contact refers to.
  struct Pair
  {
    Pair(const Surface &a, const Surface &b, const ContactParameters &parameters)
        : surface(together(a, b)), points(surface), contact(surface, points, parameters),
          x(positions(surface)), n_first(a.control_points.size())
    {
    }
    void move_second(const Tensor<1, 3> &shift)
    {
      for (unsigned int i = n_first; i < x.size(); ++i)
        x[i] += shift;
      contact.update(x);
    }
    Vectors gradient() const
    {
      Vectors result(x.size());
      contact.add_gradient(result);
      return result;
    }
    /// Force of the first on the second part.
    Tensor<1, 3> force() const
    {
      const Vectors g = gradient();
      Tensor<1, 3> sum;
      for (unsigned int i = n_first; i < g.size(); ++i)
        sum -= g[i];
      return sum;
    }

    Surface surface;
    QuadraturePoints points;
    Contact contact;
    Vectors x;
    unsigned int n_first;
  };
} // namespace semilunar::tests

#endif
