// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_flow_spaces_h
#define semilunar_flow_spaces_h

#include <semilunar/flow/hanging_nodes.h>
#include <semilunar/flow/lanes.h>

#include <deal.II/base/partitioner.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <array>
#include <memory>

namespace semilunar::flow
{
  using Vector = dealii::LinearAlgebra::distributed::Vector<double>;

  /// Where a cell is worked on.
  struct CellLane
  {
    unsigned int batch = dealii::numbers::invalid_unsigned_int, lane = 0;
  };

  /// The Taylor-Hood pair on the locally owned and ghost cells, and cells in batches of n_lanes.
  /// Cells of the artery wall (mesh::wall) have velocities, too; their pressures mean nothing.
  /// The velocity has one scalar space for all components: component c of node i is entry dim i + c
  /// of a velocity vector.
  template <int dim>
  class Spaces
  {
  public:
    using Partitioner = dealii::Utilities::MPI::Partitioner;
    using NodesOfLanes = std::array<unsigned int, n_lanes>;

    Spaces(const dealii::parallel::distributed::Triangulation<dim> &triangulation,
           unsigned int degree);

    /// After construction and whenever the mesh was refined. Collective.
    void distribute_dofs();

    unsigned int degree() const { return velocity_element.degree; }
    const dealii::DoFHandler<dim> &velocity_dofs() const { return velocity_handler; }
    const dealii::DoFHandler<dim> &pressure_dofs() const { return pressure_handler; }
    MPI_Comm communicator() const { return velocity_handler.get_communicator(); }

    const dealii::AffineConstraints<double> &velocity_constraints() const
    {
      return velocity_affine;
    }
    const dealii::AffineConstraints<double> &pressure_constraints() const
    {
      return pressure_affine;
    }
    const HangingNodes &velocity_hanging() const { return hanging_velocity; }
    const HangingNodes &pressure_hanging() const { return hanging_pressure; }

    /// Of scalar velocity nodes, of interleaved velocities, of pressures.
    const std::shared_ptr<const Partitioner> &nodes() const { return node_partitioner; }
    const std::shared_ptr<const Partitioner> &velocities() const { return velocity_partitioner; }
    const std::shared_ptr<const Partitioner> &pressures() const { return pressure_partitioner; }

    /// Update the ghosts and interpolate hanging nodes.
    void make_readable_velocity(const Vector &velocity) const;
    void make_readable_pressure(const Vector &pressure) const;

    /// Batches of cells of the lumen: those of owned cells come first, those of ghost cells after
    /// them.
    unsigned int n_owned_batches() const { return owned_batches; }
    unsigned int n_batches() const { return lumen_batches; }
    /// Batches of wall cells follow, numbers n_batches() and up, owned cells first as well.
    unsigned int end_of_owned_wall() const { return owned_wall_end; }
    unsigned int end_of_wall() const { return n_cells_of_batch.size(); }
    /// Whether any rank has cells of the lumen, of the wall.
    bool has_lumen() const { return lumen_exists; }
    bool has_wall() const { return wall_exists; }
    unsigned int n_filled_lanes(const unsigned int batch) const { return n_cells_of_batch[batch]; }
    /// Stored node of each lane, [lexicographic node]; lanes without a cell repeat the first.
    const NodesOfLanes *velocity_nodes(const unsigned int batch) const
    {
      return velocity_nodes_of_batch.data() + std::size_t(batch) * velocity_element.dofs_per_cell;
    }
    const NodesOfLanes *pressure_nodes(const unsigned int batch) const
    {
      return pressure_nodes_of_batch.data() + std::size_t(batch) * pressure_element.dofs_per_cell;
    }
    /// By active cell index; invalid for artificial cells.
    const CellLane &lane_of(const unsigned int active_cell_index) const
    {
      return lane_of_cell[active_cell_index];
    }
    /// Whether a cell that is not artificial holds blood.
    bool in_lumen(const unsigned int active_cell_index) const
    {
      return lane_of_cell[active_cell_index].batch < n_batches();
    }

  private:
    void number_unknowns();
    void make_batches();
    void append_cells(bool owned, bool in_wall);

    const dealii::FE_Q<dim> velocity_element, pressure_element;
    dealii::DoFHandler<dim> velocity_handler, pressure_handler;
    dealii::AffineConstraints<double> velocity_affine, pressure_affine;
    std::shared_ptr<const Partitioner> node_partitioner, velocity_partitioner, pressure_partitioner;
    HangingNodes hanging_velocity, hanging_pressure;

    unsigned int owned_batches = 0, lumen_batches = 0, owned_wall_end = 0;
    bool lumen_exists = false, wall_exists = false;
    std::vector<unsigned int> n_cells_of_batch;
    std::vector<NodesOfLanes> velocity_nodes_of_batch, pressure_nodes_of_batch;
    std::vector<CellLane> lane_of_cell;
  };
} // namespace semilunar::flow

#endif
