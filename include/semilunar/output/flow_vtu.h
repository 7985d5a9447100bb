// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_output_flow_vtu_h
#define semilunar_output_flow_vtu_h

#include <semilunar/output/flow_state.h>
#include <semilunar/output/pvd.h>

#include <filesystem>
#include <set>
#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace semilunar::output
{
  struct FlowVtuParameters
  {
    double interval = 0.;   ///< between files [s]; 0: first and last state only
    bool high_order = true; ///< cells of the velocity's degree, else divided into linear ones
    bool wall = true;       ///< also write the walls
    bool derived = true;    ///< vorticity, Q criterion, cell Reynolds and CFL numbers

    void add_parameters(dealii::ParameterHandler &prm);
  };

  /// Writes states of a flow for ParaView, all ranks into one file: flow-0000.vtu, ... with
  /// velocity, pressure, vorticity, Q criterion (O4), cell Reynolds and CFL numbers (O5), whether
  /// a cell is in an elastic wall, and wall-0000.vtu, ... with the wall shear stress (O6) of the
  /// walls, elastic ones among them; collected in flow.pvd, wall.pvd.
  template <int dim>
  class FlowVtu
  {
  public:
    FlowVtu(const std::filesystem::path &folder, const FlowVtuParameters &parameters,
            std::set<dealii::types::boundary_id> walls);

    /// Collective. @return name of the file. @throws InputError if it cannot be written
    std::string write(const FlowState<dim> &state);

    /// Save or restore which files there are.
    template <class Archive>
    void serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &flow_collection &wall_collection &n_written;
    }

  private:
    void write_walls(const FlowState<dim> &state, const std::string &number);

    const std::filesystem::path folder;
    const FlowVtuParameters parameters;
    const std::set<dealii::types::boundary_id> walls;
    PvdCollection flow_collection, wall_collection;
    unsigned int n_written = 0;
  };
} // namespace semilunar::output

#endif
