// SPDX-License-Identifier: LGPL-2.1-or-later
// Every law in a general deformed state of a curved shell: resultants against complex-step
// derivatives of an energy written independently here, tangents against finite differences, and the
// symmetries that any law must have.

#include <semilunar/shell/section_parameters.h>

#include "../tests.h"

#include <algorithm>
#include <complex>
#include <limits>
#include <memory>

using namespace semilunar::shell;
using semilunar::tests::check;
using semilunar::tests::log;

namespace
{
  const std::array<std::string, 5> materials{
      {"Saint Venant-Kirchhoff", "neo-Hookean", "Mooney-Rivlin", "Fung", "Lee-Sacks"}};

  SectionParameters parameters(const std::string &material)
  {
    SectionParameters p;
    p.material = material;
    p.n_thickness_points = 3;
    p.lee_sacks.c3 = 40.; // not c2, so that a mix-up shows
    p.lee_sacks.isotropic_share = 0.4;
    return p;
  }

  /// Membrane strains up to 7 %, bending strains up to 4 %, g0 differs from 1 by up to 4 %.
  const SectionStrain general{
      {{1.12, 0.95, 0.06}}, {{-1.3, 1.1, 0.7}}, {{0.9, -0.4, 0.3}}, {{0.6, 0.8}}};

  using Complex = std::complex<double>;
  using ComplexSymmetric = std::array<Complex, 3>;

  /// With the mixed components E^a_b and the Lame constants of plane stress.
  Complex saint_venant_kirchhoff_density(const SectionParameters &p, const ComplexSymmetric &C,
                                         const double (&G)[2][2])
  {
    const auto &[E, nu] = p.saint_venant_kirchhoff;
    const Complex H[2][2] = {{C[0], C[2]}, {C[2], C[1]}};
    Complex mixed[2][2], square = 0.;
    for (unsigned int i = 0; i < 2; ++i)
      for (unsigned int j = 0; j < 2; ++j)
        mixed[i][j] = 0.5 * (G[i][0] * H[0][j] + G[i][1] * H[1][j] - (i == j ? 1. : 0.));
    for (unsigned int i = 0; i < 2; ++i)
      for (unsigned int j = 0; j < 2; ++j)
        square += mixed[i][j] * mixed[j][i];
    const Complex trace = mixed[0][0] + mixed[1][1];
    return E * nu / (1. - nu * nu) / 2. * trace * trace + E / (2. * (1. + nu)) * square;
  }

  /// The energy density, from the metrics by matrix algebra with the plain invariants.
  Complex density(const SectionParameters &p, const ComplexSymmetric &C, const Symmetric &g0,
                  std::array<double, 2> m)
  {
    const double det0 = g0[0] * g0[1] - g0[2] * g0[2];
    const Complex det = C[0] * C[1] - C[2] * C[2], C33 = det0 / det;
    const double G[2][2] = {{g0[1] / det0, -g0[2] / det0}, {-g0[2] / det0, g0[0] / det0}};
    const Complex I1 = G[0][0] * C[0] + G[1][1] * C[1] + 2. * G[0][1] * C[2] + C33;
    const Complex I2 = (g0[0] * C[1] + g0[1] * C[0] - 2. * g0[2] * C[2]) / det + 1. / C33;
    const double length =
        std::sqrt(m[0] * m[0] * g0[0] + m[1] * m[1] * g0[1] + 2. * m[0] * m[1] * g0[2]);
    const Complex I4 =
        (m[0] * m[0] * C[0] + m[1] * m[1] * C[1] + 2. * m[0] * m[1] * C[2]) / (length * length);

    if (p.material == "Saint Venant-Kirchhoff")
      return saint_venant_kirchhoff_density(p, C, G);
    if (p.material == "neo-Hookean")
      return p.neo_hookean.shear_modulus / 2. * (I1 - 3.);
    if (p.material == "Mooney-Rivlin")
      return p.mooney_rivlin.c10 * (I1 - 3.) + p.mooney_rivlin.c01 * (I2 - 3.);
    const auto &[c0, c1, c2, c3, w] = p.lee_sacks;
    const Complex exponential = std::exp(c2 * (I1 - 3.) * (I1 - 3.));
    if (p.material == "Fung") // has the same c0, c1, c2 here
      return c0 / 2. * (I1 - 3.) + c1 / 2. * (exponential - 1.);
    return c0 / 2. * (I1 - 3.) +
           c1 / 2. * (w * exponential + (1. - w) * std::exp(c3 * (I4 - 1.) * (I4 - 1.)) - 1.);
  }

  /// Three-point Gauss rule over the thickness.
  Complex energy(const SectionParameters &p, const ComplexSymmetric &a, const ComplexSymmetric &b,
                 const Symmetric &b0, const std::array<double, 2> &fibre)
  {
    Complex sum = 0.;
    for (const int q : {-1, 0, 1})
    {
      const double xi = q * std::sqrt(0.6) * p.thickness / 2.;
      const double weight = (q == 0 ? 8. : 5.) / 18. * p.thickness;
      ComplexSymmetric C;
      Symmetric g0;
      for (unsigned int i = 0; i < 3; ++i)
      {
        C[i] = a[i] - 2. * xi * b[i];
        g0[i] = (i < 2 ? 1. : 0.) - 2. * xi * b0[i];
      }
      sum += weight * density(p, C, g0, fibre);
    }
    return sum;
  }

  SectionResponse evaluate(const Section &section, const SectionStrain &strain,
                           const bool with_tangent = true)
  {
    SectionResponse response;
    section.evaluate(strain, with_tangent, response);
    return response;
  }

  template <std::size_t N>
  double norm(const std::array<double, N> &x)
  {
    double sum = 0.; // not a maximum, which would pass over a NaN
    for (const double component : x)
      sum += component * component;
    return std::sqrt(sum);
  }

  template <std::size_t N>
  double relative_error(const std::array<double, N> &x, const std::array<double, N> &reference)
  {
    std::array<double, N> difference;
    for (std::size_t i = 0; i < N; ++i)
      difference[i] = x[i] - reference[i];
    return norm(difference) / norm(reference);
  }

  void check_resultants(const std::string &material)
  {
    const SectionParameters p = parameters(material);
    const SectionResponse response = evaluate(*p.make_section(), general, false);
    ComplexSymmetric a, b;
    std::copy(general.a.begin(), general.a.end(), a.begin());
    std::copy(general.b.begin(), general.b.end(), b.begin());

    const double step = 1e-40;
    Symmetric n, m;
    for (unsigned int i = 0; i < 3; ++i)
    {
      const double factor = (i < 2 ? 2. : 1.) / step; // a_ii = 1 + 2 eps_ii, a_12 = 2 eps_12
      a[i] += Complex(0., step);
      n[i] = factor * energy(p, a, b, general.b0, general.fibre).imag();
      a[i] = general.a[i];
      b[i] += Complex(0., step);
      m[i] = -0.5 * factor * energy(p, a, b, general.b0, general.fibre).imag();
      b[i] = general.b[i];
    }
    const double psi = energy(p, a, b, general.b0, general.fibre).real();
    check(material + ", energy", response.energy / psi - 1., 1e-11);
    check(material + ", n = dW/deps", relative_error(response.n, n), 1e-11);
    check(material + ", m = dW/dkappa", relative_error(response.m, m), 1e-11);
  }

  /// Fourth-order central differences of n and m with respect to (eps_11, eps_22, 2 eps_12) or
  /// kappa.
  void difference_quotient(const Section &section, const bool bending, const double step,
                           Tangent &dn, Tangent &dm)
  {
    dn.fill(0.);
    dm.fill(0.);
    for (unsigned int j = 0; j < 3; ++j)
      for (const int k : {-2, -1, 1, 2})
      {
        SectionStrain strain = general;
        const double change = k * step * (j < 2 ? 2. : 1.);
        if (bending)
          strain.b[j] -= 0.5 * change;
        else
          strain.a[j] += change;
        const SectionResponse r = evaluate(section, strain, false);
        const double weight = (std::abs(k) == 1 ? 8. : -1.) * (k > 0 ? 1. : -1.) / (12. * step);
        for (unsigned int i = 0; i < 3; ++i)
        {
          dn[3 * i + j] += weight * r.n[i];
          dm[3 * i + j] += weight * r.m[i];
        }
      }
  }

  void check_tangents(const std::string &material)
  {
    const auto section = parameters(material).make_section();
    const SectionResponse response = evaluate(*section, general);
    Tangent membrane, coupling, coupling_of_m, bending;
    difference_quotient(*section, false, 1e-4, membrane, coupling_of_m);
    difference_quotient(*section, true, 1e-4 / section->thickness(), coupling, bending);
    check(material + ", membrane tangent", relative_error(response.membrane, membrane), 1e-8);
    check(material + ", coupling tangent",
          relative_error(response.coupling, coupling) +
              relative_error(response.coupling, coupling_of_m),
          1e-8);
    check(material + ", bending tangent", relative_error(response.bending, bending), 1e-8);
  }

  Tangent transposed(const Tangent &D)
  {
    return {{D[0], D[3], D[6], D[1], D[4], D[7], D[2], D[5], D[8]}};
  }

  /// Components of the same tensor in the frame turned by an angle.
  Symmetric turned(const Symmetric &A, const double angle)
  {
    const double c = std::cos(angle), s = std::sin(angle);
    return {{c * c * A[0] + s * s * A[1] + 2. * c * s * A[2],
             s * s * A[0] + c * c * A[1] - 2. * c * s * A[2],
             c * s * (A[1] - A[0]) + (c * c - s * s) * A[2]}};
  }

  SectionStrain turned(const SectionStrain &x, const double angle)
  {
    const double c = std::cos(angle), s = std::sin(angle);
    return {turned(x.a, angle),
            turned(x.b, angle),
            turned(x.b0, angle),
            {{c * x.fibre[0] + s * x.fibre[1], c * x.fibre[1] - s * x.fibre[0]}}};
  }

  Symmetric apply(const Tangent &D, const Symmetric &strain)
  {
    Symmetric stress;
    for (unsigned int i = 0; i < 3; ++i)
      stress[i] = D[3 * i] * strain[0] + D[3 * i + 1] * strain[1] + D[3 * i + 2] * 2. * strain[2];
    return stress;
  }

  /// Sum of the errors of n, m and their derivatives in a direction in a turned frame.
  double frame_error(const Section &section, const double angle)
  {
    const SectionResponse r = evaluate(section, general),
                          r_turned = evaluate(section, turned(general, angle));
    const Symmetric direction{{0.3, -0.7, 0.45}}, direction_turned = turned(direction, angle);
    double error = std::abs(r_turned.energy / r.energy - 1.) +
                   relative_error(r_turned.n, turned(r.n, angle)) +
                   relative_error(r_turned.m, turned(r.m, angle));
    for (const auto tangent :
         {&SectionResponse::membrane, &SectionResponse::coupling, &SectionResponse::bending})
      error += relative_error(apply(r_turned.*tangent, direction_turned),
                              turned(apply(r.*tangent, direction), angle));
    return error;
  }

  void check_symmetries(const std::string &material)
  {
    const auto section = parameters(material).make_section();
    const SectionResponse r = evaluate(*section, general);
    check(material + ", asymmetry of the tangents",
          relative_error(r.membrane, transposed(r.membrane)) +
              relative_error(r.coupling, transposed(r.coupling)) +
              relative_error(r.bending, transposed(r.bending)),
          1e-14);
    check(material + ", turned frame", frame_error(*section, 0.7), 1e-11);

    SectionStrain undeformed = general;
    undeformed.a = {{1., 1., 0.}};
    undeformed.b = undeformed.b0;
    const SectionResponse rest = evaluate(*section, undeformed);
    const double stiffness = norm(rest.membrane), h = section->thickness();
    check(material + ", stress of the undeformed state",
          (rest.energy + norm(rest.n) + norm(rest.m) / h) / stiffness, 1e-15);

    // The stress at the Gauss points adds up to the resultants.
    Symmetric n{};
    for (const int q : {-1, 0, 1})
    {
      const Symmetric S = section->stress(general, q * std::sqrt(0.6) * h / 2.);
      for (unsigned int i = 0; i < 3; ++i)
        n[i] += (q == 0 ? 8. : 5.) / 18. * h * S[i];
    }
    check(material + ", stress against n", relative_error(n, r.n), 1e-11);
  }

  void check_fibres()
  {
    SectionParameters p = parameters("Lee-Sacks");
    const auto section = p.make_section();
    SectionStrain swapped{{{general.a[1], general.a[0], general.a[2]}},
                          {{general.b[1], general.b[0], general.b[2]}},
                          {{general.b0[1], general.b0[0], general.b0[2]}},
                          {{general.fibre[1], general.fibre[0]}}};
    const SectionResponse r = evaluate(*section, general), s = evaluate(*section, swapped);
    check("Lee-Sacks, swapped axes",
          relative_error(s.n, {{r.n[1], r.n[0], r.n[2]}}) +
              relative_error(s.bending,
                             {{r.bending[4], r.bending[3], r.bending[5], r.bending[1], r.bending[0],
                               r.bending[2], r.bending[7], r.bending[6], r.bending[8]}}),
          1e-12);
    SectionStrain stretched{{{1.2, 1., 0.}}, {}, {}, {{1., 0.}}};
    const double along = evaluate(*section, stretched).n[0];
    stretched.fibre = {{0., 1.}};
    const double across = evaluate(*section, stretched).n[0];
    check("Lee-Sacks, softer across the fibres than along them", across / along, 0.5);

    p.lee_sacks.isotropic_share = 1.;
    p.lee_sacks.c3 = 1e6; // without effect, not even by overflow
    const SectionResponse isotropic = evaluate(*p.make_section(), general),
                          fung = evaluate(*parameters("Fung").make_section(), general);
    check("Lee-Sacks with w = 1 against Fung",
          relative_error(isotropic.n, fung.n) + relative_error(isotropic.bending, fung.bending),
          1e-14);
  }

  /// States that no line search may accept. St. Venant-Kirchhoff accepts any deformation.
  void check_inadmissible(const std::string &material)
  {
    const auto section = parameters(material).make_section();
    SectionStrain singular = general, negative = general, folded = general, thick = general,
                  unknown = general;
    singular.a = {{1., 1., 1.5}};
    negative.a = {{-1., -1., 0.}};
    folded.b = {{100., 0., 0.}};
    thick.a = {{1., 1., 0.}}; // undeformed, but thicker than its radius of curvature
    thick.b = thick.b0 = {{0., 100., 0.}};
    unknown.a[1] = std::numeric_limits<double>::quiet_NaN();
    bool finite = false;
    std::vector<SectionStrain> inadmissible = {thick, unknown};
    if (material != "Saint Venant-Kirchhoff")
      inadmissible.insert(inadmissible.end(), {singular, negative, folded});
    else
      for (const SectionStrain &strain : {singular, negative, folded})
        check(material + ", energy of a folded state",
              std::isfinite(evaluate(*section, strain).energy) ? 0. : 1., 0.);
    for (const SectionStrain &strain : inadmissible)
    {
      const SectionResponse r = evaluate(*section, strain);
      finite = finite || std::isfinite(r.energy) || std::isfinite(r.n[0]) ||
               std::isfinite(r.m[2]) || std::isfinite(r.bending[8]) ||
               std::isfinite(section->stress(strain, 0.45 * section->thickness())[0]);
    }
    if (material == "Fung" || material == "Lee-Sacks")
    {
      const SectionStrain overflow{{{3., 3., 0.}}, {}, {}, {{1., 0.}}};
      const SectionResponse r = evaluate(*section, overflow);
      finite = finite || std::isfinite(r.energy) || std::isfinite(r.n[0]);
    }
    check(material + ", finite numbers in inadmissible states", finite ? 1. : 0., 0.);
  }
} // namespace

int main()
{
  for (const std::string &material : materials)
  {
    check_resultants(material);
    check_tangents(material);
    check_symmetries(material);
    check_inadmissible(material);
  }
  check_fibres();
}
