// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_flow_state_transfer_h
#define semilunar_flow_state_transfer_h

#include <semilunar/flow/spaces.h>

#include <deal.II/distributed/solution_transfer.h>

#include <memory>

namespace semilunar::flow
{
  /// Carries vectors of velocities and pressures, and numbers at Gauss points, over to a refined
  /// mesh or through a file written with Triangulation::save().
  template <int dim>
  class StateTransfer
  {
  public:
    struct State
    {
      std::vector<Vector *> velocities, pressures;
      std::vector<Lanes> *at_points = nullptr; ///< [batch][point] of owned cells; empty: none
    };

    explicit StateTransfer(const Spaces<dim> &spaces) : spaces(spaces) {}

    /// Before the mesh is refined, or before it is saved. All vectors readable.
    void prepare(const State &state, bool for_file);
    /// After Spaces::distribute_dofs() on the new mesh: fill the vectors, which are sized here, and
    /// make them readable. Numbers at points come if they were given to prepare().
    void finish(const State &state);
    /// The same from a file that was loaded by Triangulation::load(). @param with_points whether it
    /// holds numbers at points
    void load(const State &state, bool with_points);

  private:
    using Transfer = dealii::parallel::distributed::SolutionTransfer<dim, Vector>;

    void split(const State &state);
    void attach(bool for_file);
    void make_point_space();
    void size_parts(std::size_t n_velocities, std::size_t n_pressures);
    void merge(const State &state);

    const Spaces<dim> &spaces;
    std::vector<Vector> velocity_parts, pressure_parts;
    Vector point_values;
    std::unique_ptr<dealii::DoFHandler<dim>> point_dofs;
    std::unique_ptr<Transfer> velocity_transfer, pressure_transfer, point_transfer;
  };
} // namespace semilunar::flow

#endif
