// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_shell_section_parameters_h
#define semilunar_shell_section_parameters_h

#include <semilunar/shell/section.h>

#include <deal.II/base/tensor.h>

#include <memory>
#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace semilunar::shell
{
  /// Choice of the thickness and of the material of a shell. The defaults are the pericardial
  /// leaflet of Hsu et al. 2015.
  struct SectionParameters
  {
    std::string material = "Fung";
    double thickness = 0.0386; ///< [cm]
    unsigned int n_thickness_points = 4;
    double density = 1.0;  ///< [g/cm^3]
    double prestress = 0.; ///< membrane force of the undeformed shell [dyn/cm]

    struct
    {
      double youngs_modulus = 1.1e7; ///< [dyn/cm^2]
      double poisson_ratio = 0.495;
    } saint_venant_kirchhoff;

    struct
    {
      double shear_modulus = 1.0e6; ///< [dyn/cm^2]
    } neo_hookean;

    struct
    {
      double c10 = 4.375e5; ///< [dyn/cm^2]
      double c01 = 0.625e5; ///< [dyn/cm^2]
    } mooney_rivlin;

    struct
    {
      double c0 = 1.0e6; ///< [dyn/cm^2]
      double c1 = 2.0e5; ///< [dyn/cm^2]
      double c2 = 100.;
    } fung;

    struct
    {
      double c0 = 1.0e6; ///< [dyn/cm^2]
      double c1 = 2.0e5; ///< [dyn/cm^2]
      double c2 = 100.;
      double c3 = 100.;
      double isotropic_share = 0.5;
    } lee_sacks;

    struct
    {
      std::string direction = "circumferential"; ///< or "axial", "vector"
      dealii::Tensor<1, 3> vector = dealii::Tensor<1, 3>({1., 0., 0.});
      double angle = 0.; ///< [degrees]
    } fibre;

    double mass_per_area() const { return density * thickness; }

    /// Declare and bind the entries of the section Shell.
    void add_parameters(dealii::ParameterHandler &prm);

    /// The section of the chosen material. Throws InputError, naming the entry, for a value that no
    /// shell can have.
    std::unique_ptr<Section> make_section() const;
  };

  /// Unit fibre direction in an orthonormal frame of the undeformed tangent plane (M17): the
  /// chosen direction projected to the plane and turned by the angle. (1, 0) for isotropic
  /// materials, which ignore it.
  /// @param position undeformed position [cm]
  /// @param frame    unit vectors e_1, e_2; the angle counts positive from e_1 to e_2
  /// Throws InputError where the direction is normal to the surface or, on the axis, undefined.
  std::array<double, 2> fibre_direction(const SectionParameters &parameters,
                                        const dealii::Tensor<1, 3> &position,
                                        const std::array<dealii::Tensor<1, 3>, 2> &frame);
} // namespace semilunar::shell

#endif
