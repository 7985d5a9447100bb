// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/first_rank.h>
#include <semilunar/scene/shell_output.h>

#include <cstdio>

namespace semilunar::scene
{
  using output::SurfaceField;

  ShellOutput::ShellOutput(const std::filesystem::path &folder, const ShellModel &model,
                           const output::SurfaceVtuParameters &parameters)
      : folder(folder), model(model), parameters(parameters),
        collection((folder / "shell.pvd").string())
  {
  }

  SurfaceField ShellOutput::quadrature_field(const std::string &name,
                                             const std::vector<double> &values) const
  {
    // the value of the nearest quadrature point of the element
    return {name, 1,
            [this, values](const spline::SurfacePoint &point, double *value)
            {
              const auto &points = model.points;
              double smallest = 2.;
              for (unsigned int q = points.first_point(point.element);
                   q < points.first_point(point.element + 1); ++q)
                if (points.xi(q).distance_square(point.xi) < smallest)
                {
                  smallest = points.xi(q).distance_square(point.xi);
                  *value = values[q];
                }
            }};
  }

  std::vector<SurfaceField> ShellOutput::fields(const shell::ControlVectors &x) const
  {
    const double half = 0.5 * model.section->thickness();
    const auto mipe = [this, &x](const std::string &name, const double xi)
    {
      return SurfaceField{
          name, 1, [this, &x, xi](const spline::SurfacePoint &point, double *value) {
            *value = principal_strains(model.assembly.section_strain(x, point), xi)[0];
          }};
    };
    std::vector<SurfaceField> all = {mipe("mipe", half), mipe("mipe_back", -half)};
    all.push_back({"membrane_force", 3,
                   [this, &x](const spline::SurfacePoint &point, double *n)
                   {
                     shell::SectionResponse response;
                     model.section->evaluate(model.assembly.section_strain(x, point), false,
                                             response);
                     std::copy(response.n.begin(), response.n.end(), n);
                   }});
    if (model.contact)
    {
      all.push_back(quadrature_field("contact_pressure", model.contact->pressures()));
      all.push_back(quadrature_field("contact_gap", model.contact->gaps()));
    }
    return all;
  }

  std::string ShellOutput::write(const double time, const shell::ControlVectors &x)
  {
    char name[32];
    std::snprintf(name, sizeof(name), "shell-%04u.vtu", n_written++);
    shell::ControlVectors displacement = x;
    for (unsigned int c = 0; c < x.size(); ++c)
      displacement[c] -= model.surface.control_points[c].position;
    if (model.contact)
      model.contact->update(x);
    std::vector<SurfaceField> all = fields(x);
    all.insert(all.begin(),
               output::control_point_field("displacement", model.surface, displacement));
    on_first_rank(
        [&]()
        {
          output::write_surface_vtu((folder / name).string(), model.surface, x, all, parameters,
                                    time);
          collection.add(time, name);
        });
    return name;
  }
} // namespace semilunar::scene
