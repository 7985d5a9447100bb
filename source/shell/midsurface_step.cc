// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/shell/midsurface_step.h>

#include <cmath>

namespace semilunar::shell
{
  using namespace spline;

  namespace
  {
    constexpr double multiplicity[] = {1., 1., 2.}; // of the components 11, 22, 12
    /// Changes of strain below this are rounding: there is no energy to account for.
    constexpr double negligible_strain = 1e-13;

    /// What a step needs of one of its ends.
    struct End
    {
      explicit End(const SurfaceJet &jet)
          : normal(cross_product_3d(jet[d1], jet[d2])),
            nu(normal.norm()), a{{jet[d1] * jet[d1], jet[d2] * jet[d2], jet[d1] * jet[d2]}}
      {
        for (unsigned int I = 0; I < 3; ++I)
        {
          c[I] = jet[d11 + I] * normal;
          b[I] = c[I] / nu;
        }
      }
      Tensor<1, 3> normal; // r_,1 x r_,2
      double nu;           // its length
      Symmetric a, b, c;   // c = nu b
    };

    Symmetric mean(const Symmetric &x, const Symmetric &y)
    {
      return {{0.5 * (x[0] + y[0]), 0.5 * (x[1] + y[1]), 0.5 * (x[2] + y[2])}};
    }

    double contract(const Symmetric &x, const Symmetric &y)
    {
      return x[0] * y[0] + x[1] * y[1] + 2. * x[2] * y[2];
    }

    /// Add to the resultants the multiple of the strain's change that makes their work the change
    /// of energy (D17). @param missed part of the curvature's change that the force does not see
    void balance_energy(const Section &section, const End &from, const End &to,
                        const Symmetric &missed, const double energy_change, SectionResponse &s)
    {
      Symmetric strain, curvature, seen;
      for (unsigned int I = 0; I < 3; ++I)
      {
        strain[I] = 0.5 * (to.a[I] - from.a[I]);
        curvature[I] = -(to.b[I] - from.b[I]);
        seen[I] = curvature[I] + missed[I];
      }
      const double inertia = section.thickness() * section.thickness() / 12.;
      const double square = contract(strain, strain) + inertia * contract(curvature, seen);
      if (!(square > negligible_strain * negligible_strain))
        return;
      const double factor = (energy_change - contract(s.n, strain) - contract(s.m, seen)) / square;
      for (unsigned int I = 0; I < 3; ++I)
      {
        s.n[I] += factor * strain[I];
        s.m[I] += factor * inertia * curvature[I];
      }
    }
  } // namespace

  void conserving_gradient(const Section &section, const SurfaceJet &jet_from,
                           const SurfaceJet &jet_to, const Symmetric &b0,
                           const std::array<double, 2> &fibre, double (&gradient)[n_derivatives][3])
  {
    const End from(jet_from), to(jet_to);
    SurfaceJet r, change;
    for (unsigned int d = 0; d < n_derivatives; ++d)
    {
      r[d] = 0.5 * (jet_from[d] + jet_to[d]);
      change[d] = jet_to[d] - jet_from[d];
    }
    const Symmetric a = mean(from.a, to.a), b = mean(from.b, to.b), c = mean(from.c, to.c);
    const double nu = 0.5 * (from.nu + to.nu), inverse_nu = nu / (from.nu * to.nu);

    SectionResponse start, end, s;
    section.evaluate({from.a, from.b, b0, fibre}, false, start);
    section.evaluate({to.a, to.b, b0, fibre}, false, end);
    section.evaluate({a, b, b0, fibre}, false, s);
    // (D16): the trilinear c changes by more than its derivative in the middle says
    Symmetric missed;
    const Tensor<1, 3> turn = cross_product_3d(change[d1], change[d2]);
    for (unsigned int I = 0; I < 3; ++I)
      missed[I] = 0.25 * inverse_nu * (change[d11 + I] * turn);
    balance_energy(section, from, to, missed, end.energy - start.energy, s);

    const Tensor<1, 3> normal = cross_product_3d(r[d1], r[d2]);
    double of_metric = 0.; // derivative with respect to nu^2
    Tensor<1, 3> force[2], second;
    for (unsigned int I = 0; I < 3; ++I)
    {
      const double m = -multiplicity[I] * s.m[I];
      of_metric -= m * c[I] / (from.nu * to.nu * 2. * nu);
      second += m * inverse_nu * r[d11 + I];
      for (unsigned int i = 0; i < 3; ++i)
        gradient[d11 + I][i] = m * inverse_nu * normal[i];
    }
    const double n11 = s.n[0] + 2. * of_metric * a[1], n22 = s.n[1] + 2. * of_metric * a[0],
                 n12 = s.n[2] - 2. * of_metric * a[2];
    force[0] = n11 * r[d1] + n12 * r[d2] + cross_product_3d(r[d2], second);
    force[1] = n12 * r[d1] + n22 * r[d2] + cross_product_3d(second, r[d1]);
    for (unsigned int i = 0; i < 3; ++i)
    {
      gradient[value][i] = 0.;
      gradient[d1][i] = force[0][i];
      gradient[d2][i] = force[1][i];
    }
  }
} // namespace semilunar::shell
