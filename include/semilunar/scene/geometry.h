// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_scene_geometry_h
#define semilunar_scene_geometry_h

#include <semilunar/output/surface_vtu.h>
#include <semilunar/scene/scene.h>
#include <semilunar/scene/surface_source.h>

namespace semilunar::scene
{
  /// Builds a surface, checks it, reports on it and writes it as surface.iga, surface.vtu
  /// and surface.stl.
  class Geometry : public Scene
  {
  public:
    void add_parameters(dealii::ParameterHandler &prm) override;
    std::string finer() const override { return "Surface/Elements * 2"; }
    void run(RunContext &context) override;

  private:
    SurfaceSource source;
    output::SurfaceVtuParameters vtu;
    std::string cad_file;
  };
} // namespace semilunar::scene

#endif
