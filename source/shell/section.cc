// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/shell/section.h>
#include <semilunar/shell/through_thickness.h>

#include <deal.II/base/quadrature_lib.h>

#include <cmath>

namespace semilunar::shell
{
  ThicknessRule gauss_rule(const double thickness, const unsigned int n_points)
  {
    const dealii::QGauss<1> gauss(n_points);
    ThicknessRule rule;
    for (unsigned int q = 0; q < n_points; ++q)
    {
      rule.positions.push_back(thickness * (gauss.point(q)[0] - 0.5));
      rule.weights.push_back(thickness * gauss.weight(q));
    }
    return rule;
  }

  std::array<double, 2> principal_strains(const SectionStrain &strain, const double xi)
  {
    const Symmetric &a = strain.a, &b = strain.b, &b0 = strain.b0;
    const double E11 = 0.5 * (a[0] - 1.) - xi * (b[0] - b0[0]);
    const double E22 = 0.5 * (a[1] - 1.) - xi * (b[1] - b0[1]);
    const double E12 = 0.5 * a[2] - xi * (b[2] - b0[2]);

    // A = L^-1 E L^-T with g0 = L L^T is symmetric with the eigenvalues wanted; unlike trace and
    // determinant it keeps their full precision when they are equal.
    const double L11 = std::sqrt(1. - 2. * xi * b0[0]);
    const double L21 = -2. * xi * b0[2] / L11;
    const double L22 = std::sqrt(1. - 2. * xi * b0[1] - L21 * L21);
    const double A11 = E11 / (L11 * L11);
    const double A12 = (E12 - L21 * E11 / L11) / (L11 * L22);
    const double A22 = (E22 - L21 * (2. * E12 - L21 * E11 / L11) / L11) / (L22 * L22);

    const double centre = 0.5 * (A11 + A22), radius = std::hypot(0.5 * (A11 - A22), A12);
    return {{centre + radius, centre - radius}};
  }
} // namespace semilunar::shell
