// SPDX-License-Identifier: LGPL-2.1-or-later
// Reading a section from a parameter file, refusing impossible ones, and fibre directions.

#include <semilunar/core/exceptions.h>
#include <semilunar/shell/section_parameters.h>

#include <deal.II/base/parameter_handler.h>

#include "../tests.h"

#include <functional>
#include <limits>

using namespace semilunar;
using namespace semilunar::shell;
using semilunar::tests::check;
using semilunar::tests::log;

namespace
{
  void read_parameters()
  {
    SectionParameters p;
    dealii::ParameterHandler prm;
    p.add_parameters(prm);
    prm.parse_input_from_string("subsection Shell\n"
                                "set Material = Lee-Sacks\n"
                                "set Thickness = 0.05\n"
                                "set Thickness points = 5\n"
                                "subsection Lee-Sacks\n"
                                "  set c0 = 2e6\n"
                                "  set c1 = 0\n"
                                "end\n"
                                "subsection Fibre\n"
                                "  set Direction = vector\n"
                                "  set Vector = 0, 3, 0\n"
                                "end\n"
                                "end\n");
    const auto section = p.make_section();
    SectionResponse response;
    section->evaluate({{{1., 1., 0.}}, {}, {}, {{1., 0.}}}, true, response);
    check("thickness", section->thickness() - 0.05, 0.);
    check("membrane stiffness 4 c0 h", response.membrane[0] / (4. * 2e6 * 0.05) - 1., 1e-14);
    check("bending stiffness 4 c0 h^3/12",
          response.bending[0] / (4. * 2e6 * std::pow(0.05, 3) / 12.) - 1., 1e-13);
    check("fibre vector", (p.fibre.vector - dealii::Tensor<1, 3>({0., 3., 0.})).norm(), 0.);
  }

  void refuse(const std::function<void(SectionParameters &)> &spoil)
  {
    SectionParameters p;
    spoil(p);
    try
    {
      p.make_section();
      check("nothing was refused", 1., 0.);
    }
    catch (const InputError &error)
    {
      log() << error.what() << std::endl;
    }
  }

  void refuse_impossible()
  {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    refuse([](auto &p) { p.thickness = -0.04; });
    refuse([](auto &p) { p.thickness = 0.; });
    refuse([nan](auto &p) { p.thickness = nan; });
    refuse([](auto &p) { p.n_thickness_points = 1; });
    refuse([](auto &p) { p.density = -1.; });
    refuse([](auto &p) { p.material = "Hooke"; });
    refuse(
        [](auto &p)
        {
          p.material = "Saint Venant-Kirchhoff";
          p.saint_venant_kirchhoff.poisson_ratio = 0.5;
        });
    refuse(
        [](auto &p)
        {
          p.material = "neo-Hookean";
          p.neo_hookean.shear_modulus = 0.;
        });
    refuse(
        [](auto &p)
        {
          p.material = "Mooney-Rivlin";
          p.mooney_rivlin = {0., 0.};
        });
    refuse([nan](auto &p) { p.fung.c2 = nan; });
    refuse(
        [](auto &p)
        {
          p.material = "Lee-Sacks";
          p.lee_sacks.isotropic_share = 1.2;
        });
  }

  void check_direction(const std::string &name, const SectionParameters &p,
                       const dealii::Tensor<1, 3> &position,
                       const std::array<dealii::Tensor<1, 3>, 2> &frame,
                       const dealii::Tensor<1, 3> &expected)
  {
    const auto m = fibre_direction(p, position, frame);
    check(name, (m[0] * frame[0] + m[1] * frame[1] - expected).norm(), 1e-15);
  }

  void check_fibre_directions()
  {
    using Vector = dealii::Tensor<1, 3>;
    // a point of the cylinder r = 2 about z at 30 degrees, the frame turned by 50 degrees
    const double c = std::cos(M_PI / 6.), s = std::sin(M_PI / 6.);
    const double cf = std::cos(50. * M_PI / 180.), sf = std::sin(50. * M_PI / 180.);
    const Vector position({2. * c, 2. * s, 0.7}), around({-s, c, 0.}), along({0., 0., 1.});
    const std::array<Vector, 2> frame{{cf * around + sf * along, cf * along - sf * around}};

    SectionParameters p;
    p.material = "Lee-Sacks";
    check_direction("circumferential", p, position, frame, around);
    p.fibre.angle = 90.;
    check_direction("circumferential, turned by 90 degrees", p, position, frame, along);
    p.fibre.angle = 0.;
    p.fibre.direction = "axial";
    check_direction("axial", p, position, frame, along);
    p.fibre.direction = "vector";
    p.fibre.vector = 5. * (3. * position + along);
    const Vector tangential =
        p.fibre.vector - (p.fibre.vector * Vector({c, s, 0.})) * Vector({c, s, 0.});
    check_direction("vector with a normal part", p, position, frame,
                    tangential / tangential.norm());

    p.fibre.vector = Vector({c, s, 0.});
    try
    {
      fibre_direction(p, position, frame);
      check("nothing was refused", 1., 0.);
    }
    catch (const InputError &error)
    {
      log() << "normal vector refused" << std::endl;
    }
    p.material = "Fung";
    check("isotropic materials need no direction", fibre_direction(p, position, frame)[0] - 1., 0.);
  }
} // namespace

int main()
{
  read_parameters();
  refuse_impossible();
  check_fibre_directions();
}
