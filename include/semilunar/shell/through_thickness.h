// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_shell_through_thickness_h
#define semilunar_shell_through_thickness_h

#include <semilunar/shell/materials/material_response.h>

#include <cmath>
#include <limits>
#include <vector>

namespace semilunar::shell
{
  /// Distances from the midsurface and weights (lengths, their sum is the thickness).
  struct ThicknessRule
  {
    std::vector<double> positions, weights;
  };

  /// The Gauss rule on [-thickness/2, thickness/2].
  ThicknessRule gauss_rule(double thickness, unsigned int n_points);

  /// A material law (see MaterialResponse) integrated by a Gauss rule (M14)-(M16).
  template <class Law>
  class ThroughThickness final : public Section
  {
  public:
    ThroughThickness(const Law &law, const double thickness, const unsigned int n_points)
        : law(law), h(thickness), rule(gauss_rule(thickness, n_points))
    {
    }

    void evaluate(const SectionStrain &strain, const bool with_tangent,
                  SectionResponse &response) const override
    {
      if (with_tangent)
        integrate<true>(strain, response);
      else
        integrate<false>(strain, response);
    }

    Symmetric stress(const SectionStrain &strain, const double xi) const override
    {
      const ThicknessPoint point = thickness_point(strain, xi);
      if (is_admissible(point))
        return law.evaluate(point).stress;
      const double nan = std::numeric_limits<double>::quiet_NaN();
      return {{nan, nan, nan}};
    }

    double thickness() const override { return h; }

  private:
    Law law;
    double h;
    ThicknessRule rule;

    static bool is_admissible(const ThicknessPoint &point)
    {
      return point.undeformed_admissible &&
             (point.deformed_admissible ||
              (Law::admits_any_deformation && std::isfinite(point.determinant)));
    }

    template <bool with_tangent>
    void integrate(const SectionStrain &strain, SectionResponse &response) const;
    static void set_not_a_number(bool with_tangent, SectionResponse &response);
    static Tangent full(const SymmetricMap &D)
    {
      return {{D[0], D[1], D[2], D[1], D[3], D[4], D[2], D[4], D[5]}};
    }
  };

  template <class Law>
  template <bool with_tangent>
  void ThroughThickness<Law>::integrate(const SectionStrain &strain,
                                        SectionResponse &response) const
  {
    double energy = 0.;
    Symmetric n{}, m{};
    SymmetricMap membrane{}, coupling{}, bending{};
    for (std::size_t q = 0; q < rule.positions.size(); ++q)
    {
      const double xi = rule.positions[q], weight = rule.weights[q];
      const ThicknessPoint point = thickness_point(strain, xi);
      if (!is_admissible(point))
        return set_not_a_number(with_tangent, response);

      const MaterialResponse local = law.evaluate(point);
      energy += weight * local.energy;
      for (unsigned int i = 0; i < 3; ++i)
      {
        n[i] += weight * local.stress[i];
        m[i] += weight * xi * local.stress[i];
      }
      if constexpr (with_tangent)
        for (unsigned int i = 0; i < 6; ++i)
        {
          const double D = weight * local.tangent[i];
          membrane[i] += D;
          coupling[i] += xi * D;
          bending[i] += xi * xi * D;
        }
    }
    response.energy = energy;
    response.n = n;
    response.m = m;
    if constexpr (with_tangent)
    {
      response.membrane = full(membrane);
      response.coupling = full(coupling);
      response.bending = full(bending);
    }
  }

  template <class Law>
  void ThroughThickness<Law>::set_not_a_number(const bool with_tangent, SectionResponse &response)
  {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    response.energy = nan;
    response.n.fill(nan);
    response.m.fill(nan);
    if (with_tangent)
      for (Tangent *tangent : {&response.membrane, &response.coupling, &response.bending})
        tangent->fill(nan);
  }
} // namespace semilunar::shell

#endif
