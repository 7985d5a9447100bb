// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What is read off a flow, for fields that are known: cross-sections of tubes and of boxes cut
// askew, probes, wall shear stress, errors, cell numbers, and the files.
#include <semilunar/mesh/parameters.h>
#include <semilunar/output/cell_numbers.h>
#include <semilunar/output/cross_section.h>
#include <semilunar/output/flow_errors.h>
#include <semilunar/output/flow_probe.h>
#include <semilunar/output/flow_vtu.h>
#include <semilunar/output/velocity_dofs.h>
#include <semilunar/output/wall_shear_stress.h>

#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/numerics/vector_tools.h>

#include <filesystem>

#include "../tests.h"

using namespace semilunar;
using dealii::Point;
constexpr double pi = dealii::numbers::PI;

bool first_rank()
{
  return dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
}

void check(const std::string &what, const double error, const double bound)
{
  if (first_rank())
    tests::check(what, error, bound);
}

/// Poiseuille's velocity along the last axis, in a pipe of radius 1.
template <int dim>
class Flow : public dealii::Function<dim>
{
public:
  Flow() : dealii::Function<dim>(dim) {}
  double value(const Point<dim> &p, const unsigned int component) const override
  {
    const double profile = 2. * (1. - p[0] * p[0] - p[1] * p[1]);
    return component == dim - 1 ? profile : 0.;
  }
};

template <int dim>
class Pressure : public dealii::Function<dim>
{
public:
  double value(const Point<dim> &p, unsigned int) const override { return 3. - 2. * p[dim - 1]; }
};

/// A mesh with a velocity and a pressure on it.
template <int dim>
struct Fields
{
  explicit Fields(std::unique_ptr<mesh::Mesh<dim>> given)
      : mesh(std::move(given)), mapping(2), scalar(mesh->triangulation),
        pressure_dofs(mesh->triangulation), fe(2), pressure_fe(1)
  {
    scalar.distribute_dofs(fe);
    pressure_dofs.distribute_dofs(pressure_fe);
    dofs = std::make_unique<output::VelocityDofs<dim>>(scalar);
    reinit(dofs->handler(), velocity);
    reinit(pressure_dofs, pressure);
    dealii::VectorTools::interpolate(mapping, dofs->handler(), Flow<dim>(), velocity);
    dealii::VectorTools::interpolate(mapping, pressure_dofs, Pressure<dim>(), pressure);
    velocity.update_ghost_values();
    pressure.update_ghost_values();
  }

  static void reinit(const dealii::DoFHandler<dim> &handler, output::FlowVector &vector)
  {
    dealii::IndexSet relevant;
    dealii::DoFTools::extract_locally_relevant_dofs(handler, relevant);
    vector.reinit(handler.locally_owned_dofs(), relevant, MPI_COMM_WORLD);
  }

  output::FlowState<dim> state() const
  {
    return {mapping, dofs->handler(), pressure_dofs, velocity, pressure, 1., 0.03, 0., 1e-3};
  }

  std::unique_ptr<mesh::Mesh<dim>> mesh;
  dealii::MappingQ<dim> mapping;
  dealii::DoFHandler<dim> scalar, pressure_dofs;
  dealii::FE_Q<dim> fe, pressure_fe;
  std::unique_ptr<output::VelocityDofs<dim>> dofs;
  output::FlowVector velocity, pressure;
};

/// Entries of the vector-valued space are those of the scalar one, interleaved.
void test_interleaving(const Fields<3> &fields)
{
  unsigned int n_wrong = 0;
  const auto &fe = fields.dofs->handler().get_fe();
  std::vector<dealii::types::global_dof_index> vector_dofs(fe.dofs_per_cell), dofs(27);
  auto cell = fields.scalar.begin_active();
  for (const auto &vector_cell : fields.dofs->handler().active_cell_iterators())
  {
    if (vector_cell->is_locally_owned())
    {
      vector_cell->get_dof_indices(vector_dofs);
      cell->get_dof_indices(dofs);
      for (unsigned int i = 0; i < fe.dofs_per_cell; ++i)
      {
        const auto [component, node] = fe.system_to_component_index(i);
        n_wrong += vector_dofs[i] != 3 * dofs[node] + component;
      }
    }
    ++cell;
  }
  check("numbers that are not interleaved", n_wrong, 0.);
}

void test_pipe(const std::filesystem::path &folder)
{
  mesh::MeshParameters parameters;
  parameters.shape = mesh::Shape::pipe;
  parameters.pipe = mesh::TubeParameters::pipe(1., 2.);
  parameters.pipe.n_cells_around = 24;
  parameters.pipe.n_cells_along = 4;
  const Fields<3> fields(mesh::make_mesh<3>(parameters, MPI_COMM_WORLD));
  const auto state = fields.state();
  test_interleaving(fields);
  for (const double z : {-0.9, 0., 0.3}) // 0 lies on faces
  {
    output::CrossSection<3> section(2, z);
    section.reinit(state);
    const auto values = section.evaluate(state);
    const std::string at = " at z = " + std::to_string(z).substr(0, 4);
    // arcs of parabolas through three points of the circle, half an arc being pi / 24 wide
    check("area" + at, values.area / pi - 1., std::pow(pi / 24., 4) / 24. + 1e-7);
    check("flow rate" + at, values.flow_rate / pi - 1., 1e-4);
    check("mean pressure" + at, values.pressure - (3. - 2. * z), 1e-10);
  }
  output::FlowProbe<3> inside(Point<3>(0.3, -0.2, 0.1)), at_wall(Point<3>(0., 1., 0.5)),
      outside(Point<3>(0., 1.2, 0.));
  const bool found[] = {inside.reinit(state), at_wall.reinit(state), outside.reinit(state)};
  check("probes found", std::abs(found[0] + 2 * found[1] + 4 * found[2] - 3.), 0.);
  const auto values = inside.evaluate(state);
  check("velocity of a probe", values.velocity[2] - 2. * (1. - 0.13), 1e-3);
  check("pressure of a probe", values.pressure - 2.8, 1e-10);
  const auto outside_values = outside.evaluate(state); // collective
  check("a probe outside is not a number", std::isnan(outside_values.pressure) ? 0. : 1., 0.);

  const std::set<dealii::types::boundary_id> wall = {fields.mesh->boundary_id("wall", "")};
  const auto stress = output::wall_shear_stress(state, wall);
  check("smallest wall shear stress", stress.min / 0.12 - 1., 0.01); // mu |du/dr| = 0.03 * 4
  check("largest wall shear stress", stress.max / 0.12 - 1., 0.01);
  check("mean wall shear stress", stress.mean / 0.12 - 1., 0.01);

  const auto errors = output::flow_errors<3>(
      state,
      [](const Point<3> &p) {
        return dealii::Tensor<1, 3>({0., 0., 2. * (1. - p[0] * p[0] - p[1] * p[1]) - 0.5});
      },
      [](const Point<3> &p) { return 4. - 2. * p[2]; }, false);
  check("distance of velocities", errors.velocity_l2 / (0.5 * std::sqrt(2. * pi)) - 1., 1e-3);
  check("distance of pressures", errors.pressure_l2 / std::sqrt(2. * pi) - 1., 1e-5);

  output::FlowVtu<3> files(folder, {}, wall);
  files.write(state);
  files.write(state);
  for (const char *name :
       {"flow-0000.vtu", "flow-0001.vtu", "wall-0001.vtu", "flow.pvd", "wall.pvd"})
    check(std::string("file ") + name, std::filesystem::file_size(folder / name) > 200 ? 0. : 1.,
          0.);
}

/// The pipe with an elastic wall: what is read off the blood does not see it.
void test_elastic_pipe(const std::filesystem::path &folder)
{
  mesh::MeshParameters parameters;
  parameters.shape = mesh::Shape::pipe;
  parameters.pipe = mesh::TubeParameters::pipe(1., 2.);
  parameters.pipe.n_cells_around = 24;
  parameters.pipe.n_cells_along = 4;
  parameters.pipe.wall_thickness = 0.2;
  const Fields<3> fields(mesh::make_mesh<3>(parameters, MPI_COMM_WORLD));
  const auto state = fields.state();
  output::CrossSection<3> section(2, 0.3);
  section.reinit(state);
  const auto values = section.evaluate(state);
  check("area within a wall", values.area / pi - 1., std::pow(pi / 24., 4) / 24. + 1e-7);
  check("flow rate within a wall", values.flow_rate / pi - 1., 1e-4);
  check("mean pressure within a wall", values.pressure - 2.4, 1e-10);
  const auto stress = output::wall_shear_stress(state, {});
  check("smallest shear stress on an elastic wall", stress.min / 0.12 - 1., 0.01);
  check("largest shear stress on an elastic wall", stress.max / 0.12 - 1., 0.01);
  output::FlowVtu<3> files(folder, {}, {});
  files.write(state);
  check("file of an elastic wall",
        std::filesystem::file_size(folder / "wall-0000.vtu") > 200 ? 0. : 1., 0.);
}

/// A box of side 1 turned by 0.3: the plane leaves cells through their sides.
void test_oblique_cut()
{
  mesh::MeshParameters parameters;
  parameters.box.n_cells = {6, 6};
  parameters.box.lower = {-0.5, -0.5};
  parameters.box.upper = {0.5, 0.5};
  auto mesh = mesh::make_mesh<2>(parameters, MPI_COMM_WORLD);
  dealii::GridTools::rotate(0.3, mesh->triangulation);
  const Fields<2> fields(std::move(mesh));
  for (const unsigned int n_points : {4, 64})
  {
    output::CrossSection<2> section(1, 0.1, n_points);
    section.reinit(fields.state());
    const auto values = section.evaluate(fields.state());
    check("length of an oblique cut, " + std::to_string(n_points) + " points",
          values.area * std::cos(0.3) - 1., 0.4 / n_points);
  }
}

void test_cell_numbers()
{
  mesh::MeshParameters parameters; // unit square of 4 x 4 cells
  const Fields<2> fields(mesh::make_mesh<2>(parameters, MPI_COMM_WORLD));
  const auto state = fields.state(); // speed 2 (1 - x^2 - y^2) along y
  const auto numbers = output::cell_numbers(state);
  const double reynolds =
      dealii::Utilities::MPI::max(numbers.reynolds.linfty_norm(), MPI_COMM_WORLD);
  const double cfl = dealii::Utilities::MPI::max(numbers.cfl.linfty_norm(), MPI_COMM_WORLD);
  check("largest cell Reynolds number", reynolds / (2. * 0.25 / 2. / 0.03) - 1., 1e-5);
  check("largest CFL number", cfl / (2. * 1e-3 * 2. / 0.25) - 1., 1e-5);
  // the velocity is quadratic: its gradient does not jump, and the vorticity is -4x
  const auto indicators = output::error_indicators(state, 0.);
  check("jumps of a smooth field",
        dealii::Utilities::MPI::max(indicators.linfty_norm(), MPI_COMM_WORLD), 1e-6);
  const auto weighted = output::error_indicators(state, 1.);
  const double sum = dealii::Utilities::MPI::sum(std::pow(weighted.l2_norm(), 2), MPI_COMM_WORLD);
  check("vorticity in the indicators", sum / (2. / 16. * 16. / 3.) - 1., 1e-5);
}

int main(int argc, char *argv[])
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_pipe(".");
  std::filesystem::create_directory("elastic");
  test_elastic_pipe("elastic");
  test_oblique_cut();
  test_cell_numbers();
}
