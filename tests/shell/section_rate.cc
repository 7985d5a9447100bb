// SPDX-License-Identifier: LGPL-2.1-or-later
// How many midsurface points per second each law evaluates with three thickness points. The rates
// go to the terminal; the test only fails if one is far below what the shell assembly can live
// with.

#include <semilunar/shell/section_parameters.h>

#include "../tests.h"

#include <algorithm>
#include <chrono>
#include <vector>

using namespace semilunar::shell;

namespace
{
  std::vector<SectionStrain> states()
  {
    std::vector<SectionStrain> strains(1000);
    for (std::size_t i = 0; i < strains.size(); ++i)
    {
      const double t = double(i) / strains.size();
      strains[i] = {{{1.1 + 0.05 * t, 1.05 - 0.02 * t, 0.03 * t}},
                    {{0.5 * t, 0.2, -0.1}},
                    {{0.1, 0.05 * t, 0.02}},
                    {{0.6, 0.8}}};
    }
    return strains;
  }

  /// Best of several runs, in points per second.
  double rate(const Section &section, const std::vector<SectionStrain> &strains)
  {
    SectionResponse response;
    double best = 0., sum = 0.;
    for (unsigned int run = 0; run < 20; ++run)
    {
      const auto start = std::chrono::steady_clock::now();
      for (const SectionStrain &strain : strains)
      {
        section.evaluate(strain, true, response);
        sum += response.n[0] + response.bending[4];
      }
      const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
      best = std::max(best, strains.size() / elapsed.count());
    }
    return std::isfinite(sum) ? best : 0.;
  }
} // namespace

int main()
{
  const std::vector<SectionStrain> strains = states();
  for (const char *material :
       {"Saint Venant-Kirchhoff", "neo-Hookean", "Mooney-Rivlin", "Fung", "Lee-Sacks"})
  {
    SectionParameters p;
    p.material = material;
    p.n_thickness_points = 3;
    const double points_per_second = rate(*p.make_section(), strains);
    std::fprintf(stderr, "%-24s %6.2f million points/s\n", material, 1e-6 * points_per_second);
    semilunar::tests::check(std::string(material) + ", seconds per point", 1. / points_per_second,
                            1e-5);
  }
}
