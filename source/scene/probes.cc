// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/scene/probes.h>
#include <semilunar/shell/location.h>
#include <semilunar/spline/closest_point.h>

#include <deal.II/base/utilities.h>

namespace semilunar::scene
{
  Probes::Probes(const std::string &list, const spline::Surface &surface, const std::string &entry)
      : surface(surface)
  {
    const auto x = spline::positions(surface);
    for (const std::string &item : dealii::Utilities::split_string_list(list, ';'))
      if (!item.empty())
      {
        const auto parts = dealii::Utilities::split_string_list(item, ':');
        if (parts.size() != 2)
          throw InputError(entry, item, "this is not a probe", "write NAME: (x, y, z)");
        const auto foot = closest_point(surface, x, shell::parse_vector(parts[1], entry));
        probes.push_back({parts[0], foot.point});
      }
  }

  std::vector<output::TimeSeries::Column> Probes::columns() const
  {
    std::vector<output::TimeSeries::Column> all;
    for (const Probe &probe : probes)
      for (const char component : {'x', 'y', 'z'})
        all.push_back({probe.name + "_u" + component, "length"});
    return all;
  }

  std::vector<std::string> Probes::names() const
  {
    std::vector<std::string> all;
    for (const auto &column : columns())
      all.push_back(column.name);
    return all;
  }

  std::vector<double> Probes::displacements(const shell::ControlVectors &x) const
  {
    std::vector<double> all;
    spline::BasisValues basis;
    for (const Probe &probe : probes)
    {
      const auto &element = surface.elements[probe.point.element];
      evaluate_basis(surface, probe.point.element, probe.point.xi, basis);
      spline::Tensor<1, 3> u;
      for (unsigned int a = 0; a < element.n_functions(); ++a)
      {
        const unsigned int c = element.control_points[a];
        u += basis.values[spline::value][a] * (x[c] - surface.control_points[c].position);
      }
      all.insert(all.end(), {u[0], u[1], u[2]});
    }
    return all;
  }

  void Probes::add_quantities(const shell::ControlVectors &x, RunResults &results) const
  {
    const std::vector<double> values = displacements(x);
    const auto names = columns();
    for (unsigned int i = 0; i < values.size(); ++i)
      results.quantities.push_back({names[i].name, values[i], names[i].unit});
  }
} // namespace semilunar::scene
