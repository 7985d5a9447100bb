// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/output/flow_probe.h>

#include <deal.II/base/geometry_info.h>

#include <limits>

namespace semilunar::output
{
  namespace
  {
    /// How far outside of a cell a point may lie that is taken to be in it, in reference
    /// coordinates: points on curved boundaries are not exactly on those of the mesh.
    constexpr double reference_tolerance = 1e-3;

    template <int dim>
    struct Place
    {
      typename dealii::Triangulation<dim>::active_cell_iterator cell;
      dealii::Point<dim> xi;
      double distance = std::numeric_limits<double>::infinity(); ///< from the cell, reference
    };

    template <int dim>
    Place<dim> locate(const FlowState<dim> &state, const dealii::Point<dim> &position)
    {
      Place<dim> best;
      for (const auto &cell : state.triangulation().active_cell_iterators())
      {
        if (!cell->is_locally_owned())
          continue;
        auto box = state.mapping.get_bounding_box(cell);
        box.extend(0.1 * cell->diameter());
        if (!box.point_inside(position))
          continue;
        try
        {
          const auto xi = state.mapping.transform_real_to_unit_cell(cell, position);
          const double distance = dealii::GeometryInfo<dim>::distance_to_unit_cell(xi);
          if (distance < best.distance)
            best = {cell, dealii::GeometryInfo<dim>::project_to_unit_cell(xi), distance};
        }
        catch (const typename dealii::Mapping<dim>::ExcTransformationFailed &)
        {
          // the point lies far outside of this cell
        }
      }
      return best;
    }
  } // namespace

  template <int dim>
  bool FlowProbe<dim>::reinit(const FlowState<dim> &state)
  {
    namespace MPI = dealii::Utilities::MPI;
    velocity = {};
    pressure = {};
    const Place<dim> place = locate(state, position);
    const MPI_Comm communicator = state.communicator();
    found = MPI::min(place.distance, communicator) <= reference_tolerance;
    const bool is_mine = place.distance <= reference_tolerance;
    const unsigned int rank = MPI::this_mpi_process(communicator);
    if (MPI::min(is_mine ? rank : MPI::n_mpi_processes(communicator), communicator) != rank)
      return found;
    if (is_mine)
    {
      for (unsigned int d = 0; d < dim; ++d)
        velocity[d].add(state.velocity_dofs, place.cell, {place.xi}, {1.}, d);
      pressure.add(state.pressure_dofs, place.cell, {place.xi}, {1.}, 0);
    }
    return found;
  }

  template <int dim>
  typename FlowProbe<dim>::Values FlowProbe<dim>::evaluate(const FlowState<dim> &state) const
  {
    std::vector<double> sums(dim + 1);
    for (unsigned int d = 0; d < dim; ++d)
      sums[d] = velocity[d].local_value(state.velocity);
    sums[dim] = pressure.local_value(state.pressure);
    dealii::Utilities::MPI::sum(sums, state.communicator(), sums);
    Values values;
    for (unsigned int d = 0; d < dim; ++d)
      values.velocity[d] = found ? sums[d] : std::numeric_limits<double>::quiet_NaN();
    values.pressure = found ? sums[dim] : std::numeric_limits<double>::quiet_NaN();
    return values;
  }

  template class FlowProbe<2>;
  template class FlowProbe<3>;
} // namespace semilunar::output
