// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_scene_shell_output_h
#define semilunar_scene_shell_output_h

#include <semilunar/output/pvd.h>
#include <semilunar/output/surface_vtu.h>
#include <semilunar/scene/shell_model.h>

#include <filesystem>

namespace semilunar::scene
{
  /// Writes states of a shell as shell-0001.vtu, ... and the collection shell.pvd: displacement,
  /// largest principal strain on both faces (mipe on the face the normal points to, mipe_back on
  /// the other), membrane forces, and contact pressure and gap. Of a symmetric model, all sectors.
  class ShellOutput
  {
  public:
    ShellOutput(const std::filesystem::path &folder, const ShellModel &model,
                const output::SurfaceVtuParameters &parameters);

    /// Write the state with control points at x. Collective.
    /// @param time of the collection: the time, or the load factor
    /// @return name of the file
    std::string write(double time, const shell::ControlVectors &x);

    /// Save or restore which files were written.
    template <class Archive>
    void serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &collection &n_written;
    }

  private:
    const std::filesystem::path folder;
    const ShellModel &model;
    const spline::Surface whole; // all sectors of the model
    const output::SurfaceVtuParameters parameters;
    output::PvdCollection collection;
    unsigned int n_written = 0;

    /// Of the model's surface.
    std::vector<output::SurfaceField> fields(const shell::ControlVectors &x) const;
    /// A field of the model's surface that all its images share.
    output::SurfaceField on_all_sectors(const output::SurfaceField &field) const;
    /// Interpolates values at the quadrature points, element by element.
    output::SurfaceField quadrature_field(const std::string &name,
                                          const std::vector<double> &values) const;
  };
} // namespace semilunar::scene

#endif
