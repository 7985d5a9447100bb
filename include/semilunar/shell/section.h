// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_shell_section_h
#define semilunar_shell_section_h

#include <array>

namespace semilunar::shell
{
  /// Components of a symmetric in-plane tensor in the order 11, 22, 12.
  using Symmetric = std::array<double, 3>;

  /// A linear map between symmetric in-plane tensors, row by row. Rows are stress components (11,
  /// 22, 12), columns strain components (11, 22, 2*12), so that dS = D (dE_11, dE_22, 2 dE_12).
  using Tangent = std::array<double, 9>;

  /// What the section law needs to know at a point of the midsurface. All components refer to an
  /// orthonormal frame of the undeformed tangent plane, so the undeformed first fundamental form is
  /// the identity.
  struct SectionStrain
  {
    Symmetric a;                 ///< deformed first fundamental form, dimensionless
    Symmetric b;                 ///< deformed second fundamental form, 1/length
    Symmetric b0;                ///< undeformed second fundamental form, 1/length
    std::array<double, 2> fibre; ///< unit fibre direction in the undeformed tangent plane
  };

  /// Resultants over the thickness, with E(xi) = eps + xi kappa, eps = (a - 1)/2, kappa = -(b -
  /// b0), n = int S dxi, m = int S xi dxi and their derivatives dn = membrane deps + coupling
  /// dkappa, dm = coupling deps + bending dkappa.
  struct SectionResponse
  {
    double energy = 0.; ///< strain energy per undeformed midsurface area
    Symmetric n{};      ///< membrane force
    Symmetric m{};      ///< bending moment
    Tangent membrane{};
    Tangent coupling{};
    Tangent bending{};
  };

  /// Membrane force and bending moment alone.
  struct Resultants
  {
    Symmetric n, m;
  };

  /// Material law integrated through the thickness.
  class Section
  {
  public:
    virtual ~Section() = default;

    /// Energy and resultants, and their derivatives if with_tangent (otherwise left untouched).
    /// States outside of the law's range (C not positive definite, exponent overflow) give
    /// non-finite numbers, never an exception: the solver's line search turns back.
    virtual void evaluate(const SectionStrain &strain, bool with_tangent,
                          SectionResponse &response) const = 0;

    /// Second Piola-Kirchhoff stress (11, 22, 12) at distance xi from the midsurface.
    virtual Symmetric stress(const SectionStrain &strain, double xi) const = 0;

    virtual double thickness() const = 0;
  };

  /// Principal values (largest first) of the in-plane Green-Lagrange strain at distance xi from the
  /// midsurface, with respect to the undeformed metric there, g0 = 1 - 2 xi b0.
  std::array<double, 2> principal_strains(const SectionStrain &strain, double xi);
} // namespace semilunar::shell

#endif
