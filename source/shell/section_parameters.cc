// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/core/parameters.h>
#include <semilunar/shell/materials/fung.h>
#include <semilunar/shell/materials/lee_sacks.h>
#include <semilunar/shell/materials/mooney_rivlin.h>
#include <semilunar/shell/materials/neo_hookean.h>
#include <semilunar/shell/materials/saint_venant_kirchhoff.h>
#include <semilunar/shell/prestressed.h>
#include <semilunar/shell/section_parameters.h>
#include <semilunar/shell/through_thickness.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/parameter_handler.h>

#include <cmath>
#include <limits>
#include <sstream>

namespace semilunar::shell
{
  namespace
  {
    using dealii::ParameterHandler;
    namespace Patterns = dealii::Patterns;

    const double largest = std::numeric_limits<double>::max();

    template <class Number>
    void require(const bool good, const std::string &entry, const Number value,
                 const std::string &allowed)
    {
      if (good)
        return;
      std::ostringstream text;
      text << value;
      throw InputError("Shell/" + entry, text.str(), "out of range", "allowed: " + allowed);
    }

    /// Finite and > 0.
    void require_positive(const std::string &entry, const double value)
    {
      require(value > 0. && value <= largest, entry, value, "a number > 0");
    }

    /// Finite and >= 0.
    void require_not_negative(const std::string &entry, const double value)
    {
      require(value >= 0. && value <= largest, entry, value, "a number >= 0");
    }

    void add_material_parameters(SectionParameters &p, ParameterHandler &prm)
    {
      const Patterns::Double not_negative(0.);
      prm.enter_subsection("Saint Venant-Kirchhoff");
      prm.add_parameter("Young modulus", p.saint_venant_kirchhoff.youngs_modulus, "E [dyn/cm^2]",
                        positive_number());
      prm.add_parameter("Poisson ratio", p.saint_venant_kirchhoff.poisson_ratio,
                        "nu [-], 0 <= nu < 0.5", Patterns::Double(0., 0.5));
      prm.leave_subsection();

      prm.enter_subsection("neo-Hookean");
      prm.add_parameter("Shear modulus", p.neo_hookean.shear_modulus,
                        "mu of psi = mu/2 (I1-3) [dyn/cm^2]", positive_number());
      prm.leave_subsection();

      prm.enter_subsection("Mooney-Rivlin");
      prm.add_parameter("c10", p.mooney_rivlin.c10,
                        "Factor of I1-3 [dyn/cm^2]; the shear modulus is 2 (c10 + c01)",
                        not_negative);
      prm.add_parameter("c01", p.mooney_rivlin.c01, "Factor of I2-3 [dyn/cm^2]", not_negative);
      prm.leave_subsection();

      prm.enter_subsection("Fung");
      prm.add_parameter("c0", p.fung.c0, "Shear modulus of the matrix [dyn/cm^2]",
                        positive_number());
      prm.add_parameter("c1", p.fung.c1, "Factor of the exponential [dyn/cm^2]", not_negative);
      prm.add_parameter("c2", p.fung.c2, "Factor of (I1-3)^2 in the exponent [-]", not_negative);
      prm.leave_subsection();

      prm.enter_subsection("Lee-Sacks");
      prm.add_parameter("c0", p.lee_sacks.c0, "Shear modulus of the matrix [dyn/cm^2]",
                        positive_number());
      prm.add_parameter("c1", p.lee_sacks.c1, "Factor of the exponentials [dyn/cm^2]",
                        not_negative);
      prm.add_parameter("c2", p.lee_sacks.c2, "Factor of (I1-3)^2 in the exponent [-]",
                        not_negative);
      prm.add_parameter("c3", p.lee_sacks.c3, "Factor of (I4-1)^2 in the exponent [-]",
                        not_negative);
      prm.add_parameter("Isotropic share", p.lee_sacks.isotropic_share,
                        "w [-], 0 (fibres only) to 1 (no fibres)", Patterns::Double(0., 1.));
      prm.leave_subsection();
    }

    void add_fibre_parameters(SectionParameters &p, ParameterHandler &prm)
    {
      prm.enter_subsection("Fibre");
      prm.add_parameter("Direction", p.fibre.direction,
                        "Direction of the fibres before it is projected to the tangent plane: "
                        "around the z axis, along it, or the vector below",
                        Patterns::Selection("circumferential|axial|vector"));
      prm.add_parameter("Vector", p.fibre.vector, "Components x, y, z [-], any length > 0");
      prm.add_parameter("Angle", p.fibre.angle,
                        "By which the projected direction is turned about the surface normal "
                        "[degrees]",
                        Patterns::Double(-360., 360.));
      prm.leave_subsection();
    }

    template <class Law>
    std::unique_ptr<Section> through_thickness(const SectionParameters &p, const Law &law)
    {
      return std::make_unique<ThroughThickness<Law>>(law, p.thickness, p.n_thickness_points);
    }

    std::unique_ptr<Section> make_saint_venant_kirchhoff(const SectionParameters &p)
    {
      const auto &[E, nu] = p.saint_venant_kirchhoff;
      require_positive("Saint Venant-Kirchhoff/Young modulus", E);
      require(nu >= 0. && nu < 0.5, "Saint Venant-Kirchhoff/Poisson ratio", nu,
              "0 <= nu < 0.5 (a nearly incompressible material: 0.495)");
      return through_thickness(p, SaintVenantKirchhoff{E, nu});
    }

    std::unique_ptr<Section> make_mooney_rivlin(const SectionParameters &p)
    {
      const auto &[c10, c01] = p.mooney_rivlin;
      require_not_negative("Mooney-Rivlin/c10", c10);
      require_not_negative("Mooney-Rivlin/c01", c01);
      require(c10 + c01 > 0., "Mooney-Rivlin/c10", c10, "c10 + c01 > 0");
      return through_thickness(p, MooneyRivlin{{c10, c01}});
    }

    std::unique_ptr<Section> make_fung(const SectionParameters &p)
    {
      const auto &[c0, c1, c2] = p.fung;
      require_positive("Fung/c0", c0);
      require_not_negative("Fung/c1", c1);
      require_not_negative("Fung/c2", c2);
      return through_thickness(p, Fung{{c0, c1, c2}});
    }

    std::unique_ptr<Section> make_lee_sacks(const SectionParameters &p)
    {
      const auto &[c0, c1, c2, c3, w] = p.lee_sacks;
      require_positive("Lee-Sacks/c0", c0);
      require_not_negative("Lee-Sacks/c1", c1);
      require_not_negative("Lee-Sacks/c2", c2);
      require_not_negative("Lee-Sacks/c3", c3);
      require(w >= 0. && w <= 1., "Lee-Sacks/Isotropic share", w, "0 to 1");
      return through_thickness(p, LeeSacks{{c0, c1, c2, c3, w}});
    }

    std::unique_ptr<Section> make_material_section(const SectionParameters &p)
    {
      if (p.material == "Saint Venant-Kirchhoff")
        return make_saint_venant_kirchhoff(p);
      if (p.material == "neo-Hookean")
      {
        require_positive("neo-Hookean/Shear modulus", p.neo_hookean.shear_modulus);
        return through_thickness(p, NeoHookean{{p.neo_hookean.shear_modulus}});
      }
      if (p.material == "Mooney-Rivlin")
        return make_mooney_rivlin(p);
      if (p.material == "Fung")
        return make_fung(p);
      if (p.material == "Lee-Sacks")
        return make_lee_sacks(p);
      throw InputError(
          "Shell/Material", p.material, "unknown material law",
          "allowed: Saint Venant-Kirchhoff, neo-Hookean, Mooney-Rivlin, Fung, Lee-Sacks");
    }
  } // namespace

  void SectionParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Shell");
    prm.add_parameter(
        "Material", material, "Material law; its constants are in the section of the same name",
        Patterns::Selection("Saint Venant-Kirchhoff|neo-Hookean|Mooney-Rivlin|Fung|Lee-Sacks"));
    prm.add_parameter("Thickness", thickness, "[cm]", positive_number());
    prm.add_parameter("Thickness points", n_thickness_points,
                      "Gauss points through the thickness, 2 to 16; exponential materials under "
                      "bending strains above 0.1 need more than 4",
                      Patterns::Integer(2, 16));
    prm.add_parameter("Density", density, "[g/cm^3]", Patterns::Double(0.));
    prm.add_parameter("Prestress", prestress,
                      "Membrane force of the undeformed shell, the same in all directions, < 0: "
                      "pressure [dyn/cm]");
    add_material_parameters(*this, prm);
    add_fibre_parameters(*this, prm);
    prm.leave_subsection();
  }

  std::unique_ptr<Section> SectionParameters::make_section() const
  {
    require_positive("Thickness", thickness);
    require_not_negative("Density", density);
    require(n_thickness_points >= 2 && n_thickness_points <= 16, "Thickness points",
            n_thickness_points, "2 to 16 (a single point has no bending stiffness)");

    std::unique_ptr<Section> section = make_material_section(*this);
    if (prestress == 0.)
      return section;
    return std::make_unique<Prestressed>(std::move(section), prestress);
  }

  std::array<double, 2> fibre_direction(const SectionParameters &parameters,
                                        const dealii::Tensor<1, 3> &position,
                                        const std::array<dealii::Tensor<1, 3>, 2> &frame)
  {
    if (parameters.material != "Lee-Sacks")
      return {{1., 0.}};
    const auto &fibre = parameters.fibre;
    dealii::Tensor<1, 3> direction;
    if (fibre.direction == "circumferential")
      direction = dealii::Tensor<1, 3>({-position[1], position[0], 0.});
    else if (fibre.direction == "axial")
      direction = dealii::Tensor<1, 3>({0., 0., 1.});
    else if (fibre.direction == "vector")
      direction = fibre.vector;
    else
      throw InputError("Shell/Fibre/Direction", fibre.direction, "unknown direction",
                       "allowed: circumferential, axial, vector");

    const double m1 = direction * frame[0], m2 = direction * frame[1];
    const double length = std::hypot(m1, m2);
    if (!(length > 1e-10 * direction.norm()))
    {
      std::ostringstream where;
      where << "has no component in the surface at (" << position << ")";
      throw InputError("Shell/Fibre/Direction", fibre.direction, where.str(),
                       "choose a direction that is nowhere normal to the surface");
    }
    const double angle = fibre.angle * dealii::numbers::PI / 180.;
    const double c = std::cos(angle) / length, s = std::sin(angle) / length;
    return {{c * m1 - s * m2, s * m1 + c * m2}};
  }
} // namespace semilunar::shell
