// SPDX-License-Identifier: LGPL-2.1-or-later
// Homogeneous states of every isotropic law against closed forms and tabulated values.

#include <semilunar/shell/section_parameters.h>

#include "../tests.h"

#include <memory>
#include <vector>

using namespace semilunar::shell;
using semilunar::tests::check;
using semilunar::tests::log;

namespace
{
  constexpr double E = 1.1e7, nu = 0.495, mu = 1e6, c10 = 4.375e5, c01 = 0.625e5, c1 = 2e5,
                   c2 = 100.;

  std::unique_ptr<Section> section(const std::string &material)
  {
    SectionParameters parameters;
    parameters.material = material;
    return parameters.make_section();
  }

  /// Flat state, stresses averaged over the thickness.
  SectionResponse flat(const Section &section, const Symmetric &C)
  {
    SectionResponse response;
    const SectionStrain strain{C, {}, {}, {{1., 0.}}};
    section.evaluate(strain, true, response);
    response.energy /= section.thickness();
    for (double &n : response.n)
      n /= section.thickness();
    for (double &D : response.membrane)
      D /= section.thickness();
    return response;
  }

  /// dpsi/dI1 and dpsi/dI2 at principal stretches l1, l2.
  std::array<double, 2> slopes(const std::string &material, const double I1)
  {
    if (material == "neo-Hookean")
      return {{mu / 2., 0.}};
    if (material == "Mooney-Rivlin")
      return {{c10, c01}};
    return {{mu / 2. + c1 * c2 * (I1 - 3.) * std::exp(c2 * (I1 - 3.) * (I1 - 3.)), 0.}};
  }

  double energy(const std::string &material, const double I1, const double I2)
  {
    if (material == "neo-Hookean")
      return mu / 2. * (I1 - 3.);
    if (material == "Mooney-Rivlin")
      return c10 * (I1 - 3.) + c01 * (I2 - 3.);
    return mu / 2. * (I1 - 3.) + c1 / 2. * (std::exp(c2 * (I1 - 3.) * (I1 - 3.)) - 1.);
  }

  /// Sum of the relative errors (a maximum would pass over a NaN) of principal stresses and energy:
  /// sigma_i = 2 (psi1 + l_j^2 psi2) (l_i^2 - l3^2), S_i = sigma_i / l_i^2 (Rivlin).
  double stress_error(const std::string &material, const double l1, const double l2)
  {
    const double s1 = l1 * l1, s2 = l2 * l2, s3 = 1. / (s1 * s2);
    const double I1 = s1 + s2 + s3, I2 = 1. / s1 + 1. / s2 + 1. / s3;
    const auto [psi1, psi2] = slopes(material, I1);
    const double S1 = 2. * (psi1 + s2 * psi2) * (s1 - s3) / s1;
    const double S2 = 2. * (psi1 + s1 * psi2) * (s2 - s3) / s2;
    const double psi = energy(material, I1, I2);

    const SectionResponse response = flat(*section(material), {{s1, s2, 0.}});
    return std::abs(response.n[0] - S1) / std::abs(S1) +
           std::abs(response.n[1] - S2) / std::abs(S1) + std::abs(response.n[2] / S1) +
           std::abs(response.energy - psi) / psi;
  }

  void check_stretches()
  {
    for (const std::string material : {"neo-Hookean", "Mooney-Rivlin", "Fung"})
    {
      double uniaxial = 0., equibiaxial = 0., strip = 0.;
      for (const double l : {0.9, 0.97, 1.03, 1.1, 1.2})
      {
        uniaxial += stress_error(material, l, 1. / std::sqrt(l));
        equibiaxial += stress_error(material, l, l);
        strip += stress_error(material, l, 1.);
      }
      check(material + ", uniaxial", uniaxial, 1e-11);
      check(material + ", equibiaxial", equibiaxial, 1e-11);
      check(material + ", strip", strip, 1e-11);
    }

    const double l = 1.1, e = 0.5 * (l * l - 1.);
    const auto svk = section("Saint Venant-Kirchhoff");
    const SectionResponse uniaxial = flat(*svk, {{l * l, 1. - 2. * nu * e, 0.}});
    check("Saint Venant-Kirchhoff, uniaxial", uniaxial.n[0] / (E * e) - 1., 1e-12);
    check("Saint Venant-Kirchhoff, lateral stress", uniaxial.n[1] / (E * e), 1e-12);
    check("Saint Venant-Kirchhoff, equibiaxial",
          flat(*svk, {{l * l, l * l, 0.}}).n[0] / (E * e / (1. - nu)) - 1., 1e-12);
    check("Saint Venant-Kirchhoff, shear",
          flat(*svk, {{1., 1., 0.2}}).n[2] / (E / (1. + nu) * 0.1) - 1., 1e-12);
  }

  /// Symbolic differentiation of the condensed energy at C = (1.21, 0.9, 0.1), stresses and
  /// tangents 1111, 1122, 2222, 1112, 2212, 1212, ten digits (reference values C2).
  void check_tabulated()
  {
    const std::vector<std::pair<std::string, std::array<double, 9>>> table = {
        {"Fung",
         {{6.092955303e5, -1.055125971e5, 2.305832669e5, 1.291879606e7, 3.659002352e6,
           1.269495608e7, 1.499396248e6, -1.427189803e6, 3.249892686e6}}},
        {"neo-Hookean",
         {{2.269641767e5, -3.930371804e4, 8.589286926e4, 2.579174202e6, 1.749699042e6,
           4.661936974e6, -2.865749113e5, -3.852840475e5, 8.907703494e5}}}};
    for (const auto &[material, reference] : table)
    {
      const SectionResponse r = flat(*section(material), {{1.21, 0.9, 0.1}});
      const auto &D = r.membrane;
      const std::array<double, 9> computed{
          {r.n[0], r.n[1], r.n[2], D[0], D[1], D[4], D[2], D[5], D[8]}};
      double error = 0.;
      for (unsigned int i = 0; i < 9; ++i)
        error += std::abs(computed[i] / reference[i] - 1.);
      check(material + ", general state, stress and tangent", error, 1e-8);
    }

    // Stretch 2 of a block with mu = 1.5e6: sigma = 5.25e6 and 4.921875e6 (reference values C5).
    SectionParameters parameters;
    parameters.material = "neo-Hookean";
    parameters.neo_hookean.shear_modulus = 1.5e6;
    const double neo_hookean = flat(*parameters.make_section(), {{4., 0.5, 0.}}).n[0] * 4.;
    check("neo-Hookean, block at stretch 2", neo_hookean / 5.25e6 - 1., 1e-12);
    parameters.material = "Mooney-Rivlin";
    parameters.mooney_rivlin = {1.5e6 * 7. / 16., 1.5e6 / 16.};
    const double mooney_rivlin = flat(*parameters.make_section(), {{4., 0.5, 0.}}).n[0] * 4.;
    check("Mooney-Rivlin, block at stretch 2", mooney_rivlin / 4.921875e6 - 1., 1e-12);
  }

  /// At 1e-6 strain the energy is that of linear elasticity with E = 3 mu, nu = 1/2; a formula that
  /// subtracts 3 from the invariants has lost all but four digits there.
  void check_small_strain()
  {
    const double e = 1e-6;
    for (const std::string material : {"neo-Hookean", "Mooney-Rivlin", "Fung"})
    {
      const double psi = flat(*section(material), {{1. + 2. * e, 1. - 2. * e, 0.}}).energy;
      check(material + ", energy at small strain", psi / (2. * mu * e * e) - 1., 1e-7);
    }
  }
} // namespace

int main()
{
  check_stretches();
  check_tabulated();
  check_small_strain();
}
