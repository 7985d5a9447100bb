// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/first_rank.h>
#include <semilunar/scene/shell_output.h>

#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>

#include <cstdio>
#include <map>

namespace semilunar::scene
{
  using output::SurfaceField;

  namespace
  {
    /// The Lagrange polynomials of the n Gauss points, at x.
    std::vector<double> lagrange_values(const unsigned int n, const double x)
    {
      static std::map<unsigned int, std::vector<dealii::Polynomials::Polynomial<double>>> bases;
      auto &basis = bases[n];
      if (basis.empty())
        basis = dealii::Polynomials::generate_complete_Lagrange_basis(
            dealii::QGauss<1>(n).get_points());
      std::vector<double> values;
      for (const auto &polynomial : basis)
        values.push_back(polynomial.value(x));
      return values;
    }
  } // namespace

  ShellOutput::ShellOutput(const std::filesystem::path &folder, const ShellModel &model,
                           const output::SurfaceVtuParameters &parameters)
      : folder(folder), model(model), whole(model.symmetry.whole(model.surface)),
        parameters(parameters), collection((folder / "shell.pvd").string())
  {
  }

  SurfaceField ShellOutput::quadrature_field(const std::string &name,
                                             const std::vector<double> &values) const
  {
    return {name, 1,
            [this, values](const spline::SurfacePoint &point, double *value)
            {
              const auto &degree = model.surface.elements[point.element].degree;
              const std::vector<double> along = lagrange_values(degree[0] + 1, point.xi[0]),
                                        across = lagrange_values(degree[1] + 1, point.xi[1]);
              const double *at_points = &values[model.points.first_point(point.element)];
              *value = 0.;
              for (unsigned int j = 0; j < across.size(); ++j)
                for (unsigned int i = 0; i < along.size(); ++i)
                  *value += along[i] * across[j] * at_points[j * along.size() + i];
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

  SurfaceField ShellOutput::on_all_sectors(const SurfaceField &field) const
  {
    const unsigned int n_elements = model.surface.elements.size();
    return {field.name, field.n_components,
            [n_elements, field](const spline::SurfacePoint &point, double *values) {
              field.evaluate({point.element % n_elements, point.xi}, values);
            }};
  }

  std::string ShellOutput::write(const double time, const shell::ControlVectors &x)
  {
    char name[32];
    std::snprintf(name, sizeof(name), "shell-%04u.vtu", n_written++);
    const shell::ControlVectors whole_x = model.symmetry.whole(x);
    shell::ControlVectors displacement = whole_x;
    for (unsigned int c = 0; c < displacement.size(); ++c)
      displacement[c] -= whole.control_points[c].position;
    if (model.contact)
      model.contact->update(x);
    std::vector<SurfaceField> all = {
        output::control_point_field("displacement", whole, displacement)};
    for (const SurfaceField &field : fields(x))
      all.push_back(on_all_sectors(field));
    on_first_rank(
        [&]()
        {
          output::write_surface_vtu((folder / name).string(), whole, whole_x, all, parameters,
                                    time);
          collection.add(time, name);
        });
    return name;
  }
} // namespace semilunar::scene
