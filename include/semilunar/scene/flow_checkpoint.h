// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_scene_flow_checkpoint_h
#define semilunar_scene_flow_checkpoint_h

#include <semilunar/core/checkpoint.h>
#include <semilunar/coupling/fluid_structure.h>
#include <semilunar/mesh/mesh.h>
#include <semilunar/scene/shell_model.h>

namespace semilunar::scene
{
  /// The distributed part of a checkpoint: mesh and fields of the blood. Collective.
  template <int dim>
  void save_flow(flow::FlowSolver<dim> &flow, mesh::Mesh<dim> &mesh,
                 const std::filesystem::path &folder);
  /// What save_flow() wrote. No handler of unknowns but the solver's may see the mesh. Collective.
  template <int dim>
  void load_flow(flow::FlowSolver<dim> &flow, mesh::Mesh<dim> &mesh,
                 const std::filesystem::path &folder);

  /// Tell checkpoints about what is immersed: the shell's motion and its contact, the points that
  /// hold it and the multipliers there. To be told before the flow.
  /// @param shell null: all is rigid
  void add_structure(Checkpoints &checkpoints, coupling::FluidStructure &coupled,
                     coupling::ShellInFlow *shell, const ShellModel *model);
} // namespace semilunar::scene

#endif
