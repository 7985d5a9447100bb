// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_scene_shell_model_h
#define semilunar_scene_shell_model_h

#include <semilunar/core/log.h>
#include <semilunar/shell/equilibrium.h>
#include <semilunar/shell/loads.h>
#include <semilunar/shell/section_parameters.h>
#include <semilunar/shell/supports.h>

#include <functional>
#include <memory>

namespace semilunar::scene
{
  /// Everything but the surface that makes a shell.
  struct ShellParameters
  {
    shell::SectionParameters section;
    shell::SupportParameters supports;
    shell::LoadParameters loads;
    shell::ContactParameters contact;

    void add_parameters(dealii::ParameterHandler &prm);
  };

  /// A shell, built from a surface and parameters. Replicated on all MPI ranks.
  class ShellModel
  {
  public:
    /// @param n_sectors if the surface is one of so many equal sectors about the z axis: all of
    /// them deform alike, and touch each other. Energies and forces are those of the sector.
    /// @throws InputError for parameters that do not fit the surface
    ShellModel(spline::Surface surface, const ShellParameters &parameters, Timers &timers,
               unsigned int n_sectors = 1);
    ShellModel(const ShellModel &) = delete;

    const spline::Surface surface;
    const spline::CyclicSymmetry symmetry;
    const std::unique_ptr<const shell::Section> section;
    const shell::QuadraturePoints points;
    const shell::Equations equations;
    const shell::Assembly assembly;
    const std::unique_ptr<shell::Contact> contact; ///< null if there is none
    const shell::ControlVectors dead_forces;
    const shell::EdgeMoments edge_moments;
    shell::Equilibrium equilibrium;
  };

  /// A line about the size of the model.
  void report_size(const ShellModel &model, Log &log);

  /// The largest in-plane principal Green-Lagrange strain over all quadrature points of a face.
  struct LargestStrain
  {
    double value;
    unsigned int q; ///< quadrature point
  };
  /// @param face +1 for the face the normal points to, -1 for the other
  /// @param counts which quadrature points count
  LargestStrain largest_strain(
      const ShellModel &model, const shell::ControlVectors &x, int face,
      const std::function<bool(unsigned int)> &counts = [](unsigned int) { return true; });
} // namespace semilunar::scene

#endif
