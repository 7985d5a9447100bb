// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_scene_static_analysis_h
#define semilunar_scene_static_analysis_h

#include <semilunar/output/surface_vtu.h>
#include <semilunar/scene/reference_curve.h>
#include <semilunar/scene/shell_model.h>
#include <semilunar/shell/static_solver.h>

#include <semilunar/core/run_context.h>

namespace semilunar::scene
{
  /// The static analysis of a shell, whatever the surface: load steps, files, quantities.
  struct StaticAnalysis
  {
    ShellParameters shell;
    shell::StaticSolverParameters solver;
    output::SurfaceVtuParameters vtu;
    std::string probes, stop_at, reference_curve;

    void add_parameters(dealii::ParameterHandler &prm);

    /// Report the size of the model, unless this is a dry run bring the load on, write every
    /// accepted step, and add the general quantities of a shell.
    /// @param start positions near the equilibrium at the full load to go on from with one load
    /// step; null: the load is brought on from none
    /// @return the last accepted positions of the control points
    /// @throws NumericsError naming the last good state
    shell::ControlVectors run(ShellModel &model, RunContext &context,
                              const shell::ControlVectors *start = nullptr) const;
  };
} // namespace semilunar::scene

#endif
