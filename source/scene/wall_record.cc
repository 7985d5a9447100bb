// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/flow/scaled_jacobian.h>
#include <semilunar/scene/wall_record.h>

#include <cmath>
#include <limits>

namespace semilunar::scene
{
  namespace
  {
    const char *const axes[] = {"x", "y", "z"};

    /// Whether a cell of the wall, on any rank, has its centre within its diameter from a point.
    template <int dim>
    bool is_near_wall(const mesh::Mesh<dim> &mesh, const dealii::Point<dim> &position)
    {
      bool near = false;
      for (const auto &cell : mesh.triangulation.active_cell_iterators())
        near = near || (cell->is_locally_owned() && cell->material_id() == mesh::wall &&
                        cell->center().distance(position) <= cell->diameter());
      return dealii::Utilities::MPI::max(int(near), mesh.triangulation.get_communicator()) > 0;
    }
  } // namespace

  template <int dim>
  WallRecord<dim>::WallRecord(const FlowRecordParameters &parameters, const mesh::Mesh<dim> &mesh,
                              const bool is_held)
      : force_scale(parameters.force_scale), is_held(is_held)
  {
    for (const std::string &name : parameters.forces)
      force_ids.push_back(mesh.boundary_id(name, "Output/Forces"));
    const std::string entry = "Output/Wall probes";
    for (const auto &[name, text] : named_parts(parameters.wall_probes, entry))
    {
      const auto parts = components(text, dim, entry);
      Probe probe{name, {}};
      for (unsigned int d = 0; d < dim; ++d)
        probe.position[d] = number(parts[d], {}, entry);
      if (!is_near_wall(mesh, probe.position))
        throw InputError(entry, name, "the probe does not lie in the wall",
                         "name a point of the wall at rest");
      probes.push_back(probe);
    }
  }

  template <int dim>
  std::vector<output::TimeSeries::Column> WallRecord<dim>::columns() const
  {
    std::vector<output::TimeSeries::Column> result = {{"min_scaled_jacobian", "-"},
                                                      {"interface_error", "cm"},
                                                      {"geometry_solutions", "-"},
                                                      {"lumen_volume", dim == 3 ? "cm^3" : "cm^2"},
                                                      {"largest_wall_displacement", "cm"}};
    const std::string unit = force_scale == 1. ? (dim == 3 ? "dyn" : "dyn/cm") : "-";
    for (unsigned int d = 0; d < dim; ++d)
      result.push_back({std::string("force_with_wall_") + axes[d], unit});
    if (is_held)
      for (unsigned int d = 0; d < dim; ++d)
        result.push_back({std::string("force_of_stent_on_wall_") + axes[d], unit});
    for (const Probe &probe : probes)
      for (unsigned int d = 0; d < dim; ++d)
        result.push_back({probe.name + "_d" + axes[d], "cm"});
    return result;
  }

  template <int dim>
  dealii::Tensor<1, dim> WallRecord<dim>::displacement(const Probe &probe,
                                                       const flow::FlowSolver<dim> &solver) const
  {
    const flow::Vector &rest = solver.reference_positions(), &now = solver.positions();
    double smallest = std::numeric_limits<double>::max();
    dealii::Tensor<1, dim> result;
    for (const unsigned int node : solver.wall()->nodes().owned())
    {
      double squared = 0.;
      for (unsigned int c = 0; c < dim; ++c)
        squared += std::pow(rest.local_element(dim * node + c) - probe.position[c], 2);
      if (squared >= smallest)
        continue;
      smallest = squared;
      for (unsigned int c = 0; c < dim; ++c)
        result[c] = now.local_element(dim * node + c) - rest.local_element(dim * node + c);
    }
    // The nearest one on any rank; the first of those that are as near.
    const MPI_Comm communicator = solver.spaces().communicator();
    const auto nearest = dealii::Utilities::MPI::min_max_avg(smallest, communicator);
    if (dealii::Utilities::MPI::this_mpi_process(communicator) != nearest.min_index)
      result = dealii::Tensor<1, dim>();
    return dealii::Utilities::MPI::sum(result, communicator);
  }

  template <int dim>
  double WallRecord<dim>::largest_displacement(const flow::FlowSolver<dim> &solver) const
  {
    const flow::Vector &rest = solver.reference_positions(), &now = solver.positions();
    double largest = 0.;
    for (const unsigned int node : solver.wall()->nodes().owned())
    {
      double squared = 0.;
      for (unsigned int c = 0; c < dim; ++c)
        squared +=
            std::pow(now.local_element(dim * node + c) - rest.local_element(dim * node + c), 2);
      largest = std::max(largest, squared);
    }
    return std::sqrt(dealii::Utilities::MPI::max(largest, solver.spaces().communicator()));
  }

  template <int dim>
  double WallRecord<dim>::lumen_volume(flow::FlowSolver<dim> &solver) const
  {
    return dealii::Utilities::MPI::sum(solver.cells().volume(), solver.spaces().communicator());
  }

  template <int dim>
  std::vector<double> WallRecord<dim>::row_at_rest(flow::FlowSolver<dim> &solver) const
  {
    std::vector<double> result = {flow::min_scaled_jacobian(solver.spaces(), solver.positions()),
                                  0., 0., lumen_volume(solver)};
    result.resize(columns().size(), 0.);
    return result;
  }

  template <int dim>
  std::vector<double> WallRecord<dim>::row(const flow::StepReport &report,
                                           flow::FlowSolver<dim> &solver) const
  {
    std::vector<double> result = {report.min_scaled_jacobian, report.interface_error,
                                  double(report.n_geometry), lumen_volume(solver),
                                  largest_displacement(solver)};
    const auto force = solver.force_on_blood(force_ids, true);
    for (unsigned int d = 0; d < dim; ++d)
      result.push_back(-force_scale * force[d]);
    if (is_held)
    {
      const auto of_stent = solver.force_of_holds();
      for (unsigned int d = 0; d < dim; ++d)
        result.push_back(force_scale * of_stent[d]);
    }
    for (const Probe &probe : probes)
    {
      const auto d = displacement(probe, solver);
      for (unsigned int c = 0; c < dim; ++c)
        result.push_back(d[c]);
    }
    return result;
  }

  template class WallRecord<2>;
  template class WallRecord<3>;
} // namespace semilunar::scene
