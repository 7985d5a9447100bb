// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/valve/symmetry.h>

#include <deal.II/base/numbers.h>

#include <cmath>

namespace semilunar::valve
{
  using Vector = spline::Tensor<1, 3>;

  double rotational_asymmetry(const spline::Surface &leaflets,
                              const std::vector<Vector> &control_vectors)
  {
    std::vector<const spline::NamedSet *> sets;
    while (const auto *set = leaflets.find_set(spline::SetKind::node,
                                               "leaflet" + std::to_string(sets.size() + 1)))
      sets.push_back(set);

    const auto displacement = [&](const unsigned int c)
    { return control_vectors[c] - leaflets.control_points[c].position; };
    double largest = 0., difference = 0.;
    for (unsigned int k = 0; k < sets.size(); ++k)
    {
      const double angle = -2. * dealii::numbers::PI * k / sets.size();
      const double c = std::cos(angle), s = std::sin(angle);
      for (unsigned int i = 0; i < sets[k]->members.size(); ++i)
      {
        const Vector u = displacement(sets[k]->members[i]);
        const Vector turned({c * u[0] - s * u[1], s * u[0] + c * u[1], u[2]});
        difference = std::max(difference, (turned - displacement(sets[0]->members[i])).norm());
        largest = std::max(largest, u.norm());
      }
    }
    return largest > 0. ? difference / largest : 0.;
  }
} // namespace semilunar::valve
