// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_shell_prestressed_h
#define semilunar_shell_prestressed_h

#include <semilunar/shell/section.h>

#include <memory>

namespace semilunar::shell
{
  /// A section with a membrane force of its own in the undeformed state, the same in all
  /// directions: n and the energy of (M18) are added to those of another section.
  class Prestressed : public Section
  {
  public:
    /// @param force per length [dyn/cm]
    Prestressed(std::unique_ptr<const Section> section, const double force)
        : section(std::move(section)), force(force)
    {
    }

    void evaluate(const SectionStrain &strain, const bool with_tangent,
                  SectionResponse &response) const override
    {
      section->evaluate(strain, with_tangent, response);
      response.energy += 0.5 * force * (strain.a[0] + strain.a[1] - 2.);
      response.n[0] += force;
      response.n[1] += force;
    }

    Symmetric stress(const SectionStrain &strain, const double xi) const override
    {
      Symmetric total = section->stress(strain, xi);
      total[0] += force / thickness();
      total[1] += force / thickness();
      return total;
    }

    double thickness() const override { return section->thickness(); }

  private:
    const std::unique_ptr<const Section> section;
    const double force;
  };
} // namespace semilunar::shell

#endif
