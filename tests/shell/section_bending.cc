// SPDX-License-Identifier: LGPL-2.1-or-later
// Pure bending of a strip of fixed width against tabulated moments, the number of thickness points
// that an exponential law needs, and principal strains.

#include <semilunar/shell/materials/fung.h>
#include <semilunar/shell/section_parameters.h>
#include <semilunar/shell/through_thickness.h>

#include "../tests.h"

#include <memory>
#include <vector>

using namespace semilunar::shell;
using semilunar::tests::check;
using semilunar::tests::log;

namespace
{
  struct Bending
  {
    double stretch, moment;
  };

  /// Bend a strip to the rotation t per undeformed length: a11 = l^2, b11 = l t, with the stretch l
  /// at which dW/dl = n11 l - m11 t = 0. The moment is dW/dt = -l m11.
  Bending pure_bending(const Section &section, const double t)
  {
    double l = 1.;
    SectionResponse r;
    for (unsigned int iteration = 0; iteration < 50; ++iteration)
    {
      section.evaluate({{{l * l, 1., 0.}}, {{l * t, 0., 0.}}, {}, {{1., 0.}}}, true, r);
      const double residual = r.n[0] * l - r.m[0] * t;
      const double slope =
          r.n[0] + l * l * r.membrane[0] - 2. * l * t * r.coupling[0] + t * t * r.bending[0];
      l -= residual / slope;
    }
    return {l, -l * r.m[0]};
  }

  struct Row
  {
    double surface_strain, moment, stretch; ///< rotation per length times h/2
  };

  /// Values C6 of the reference collection: the same kinematics with 60 Gauss points, nine digits.
  void check_moments(const std::string &material, const unsigned int n_points,
                     const std::vector<Row> &table)
  {
    SectionParameters p;
    p.material = material;
    p.n_thickness_points = n_points;
    const auto section = p.make_section();
    double moment_error = 0., stretch_error = 0.;
    for (const Row &row : table)
    {
      const Bending result = pure_bending(*section, row.surface_strain / (p.thickness / 2.));
      moment_error += std::abs(result.moment / row.moment - 1.);
      stretch_error += std::abs(result.stretch - row.stretch);
    }
    check(material + ", bending moment", moment_error, 1e-8);
    check(material + ", stretch of the midsurface", stretch_error, 1e-9);
  }

  /// Moments with few points as tabulated, and the error that they leave.
  void study_thickness_points()
  {
    const double h = 0.0386;
    struct
    {
      unsigned int n_points;
      double at_0_1, at_0_2;
    } const table[] = {{2, 1.53854317e2, 7.86745352e2}, {3, 2.03835607e2, 2.33789701e3},
                       {4, 2.08722450e2, 3.78399590e3}, {5, 2.09489775e2, 4.68615553e3},
                       {7, 2.09598133e2, 5.36550981e3}, {9, 2.09599405e2, 5.50368119e3}};
    for (const auto &row : table)
    {
      const ThroughThickness<Fung> section(Fung{{1e6, 2e5, 100.}}, h, row.n_points);
      const double at_0_1 = pure_bending(section, 0.1 / (h / 2.)).moment,
                   at_0_2 = pure_bending(section, 0.2 / (h / 2.)).moment;
      check("Fung, tabulated moment", at_0_1 / row.at_0_1 - 1., 1e-8);
      check("Fung, tabulated moment", at_0_2 / row.at_0_2 - 1., 1e-8);
      log() << row.n_points << " points: moment too small by " << 1. - at_0_1 / 2.09599416e2
            << " at surface strain 0.1, " << 1. - at_0_2 / 5.53098093e3 << " at 0.2" << std::endl;
    }
  }

  void check_principal_strains()
  {
    // a plane state: eigenvalues of E by their defining equation
    const SectionStrain plane{{{1.3, 0.9, 0.2}}, {}, {}, {{1., 0.}}};
    const auto [first, second] = principal_strains(plane, 0.01);
    const auto characteristic = [](const double x) { return (0.15 - x) * (-0.05 - x) - 0.1 * 0.1; };
    check("principal strains of a plane state",
          std::abs(characteristic(first)) + std::abs(characteristic(second)), 1e-15);
    check("largest first", first > 0.15 && second < -0.05 ? 0. : 1., 0.);

    // a tube of radius R unrolled and stretched by l around: E = (l^2 / g0 - 1) / 2 in its own
    // frame and in a turned one
    const double R = 0.5, l = 1.2, xi = 0.015, angle = 0.6;
    const double expected = 0.5 * (l * l / (1. + 2. * xi / R) - 1.);
    const double c = std::cos(angle), s = std::sin(angle);
    const auto dyad = [c, s](const double around, const double along)
    {
      return Symmetric{{around * c * c + along * s * s, around * s * s + along * c * c,
                        (around - along) * c * s}};
    };
    const SectionStrain tube{dyad(l * l, 1.), {}, dyad(-1. / R, 0.), {{1., 0.}}};
    const auto [around, along] = principal_strains(tube, xi);
    check("tube, strain around", around - expected, 1e-15);
    check("tube, strain along", along, 1e-15);
    const auto equal = principal_strains({{{1.2, 1.2, 0.}}, {}, {}, {{1., 0.}}}, 0.);
    check("equal strains", std::abs(equal[0] - 0.1) + std::abs(equal[1] - 0.1), 1e-15);
  }
} // namespace

int main()
{
  check_moments("Fung", 16,
                {{0.02, 2.06471313e1, 1.0002700125}, {0.1, 2.09599416e2, 1.0077128305}});
  check_moments("neo-Hookean", 16,
                {{0.02, 1.98830935e1, 1.0002668018},
                 {0.1, 1.01473866e2, 1.0067516217},
                 {0.2, 2.16375953e2, 1.0280482741}});
  check_moments("Saint Venant-Kirchhoff", 2,
                {{0.02, 7.23431877e1, 0.9998666578},
                 {0.1, 3.59400339e2, 0.9966610925},
                 {0.2, 7.04328182e2, 0.9865765725}});
  study_thickness_points();
  check_principal_strains();
}
