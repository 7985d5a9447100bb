// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/core/nearest_name.h>
#include <semilunar/core/parameters.h>
#include <semilunar/scene/flow.h>
#include <semilunar/scene/geometry.h>
#include <semilunar/scene/immersed_shell.h>
#include <semilunar/scene/registry.h>
#include <semilunar/scene/shell_dynamics.h>
#include <semilunar/scene/shell_statics.h>
#include <semilunar/scene/valve_dynamics.h>
#include <semilunar/scene/valve_fsi.h>
#include <semilunar/scene/valve_statics.h>

#include <algorithm>

namespace semilunar::scene
{
  namespace
  {
    template <typename Kind>
    SceneKind kind(const std::string &description)
    {
      return {description, []() { return std::make_unique<Kind>(); }};
    }
  } // namespace

  const std::map<std::string, SceneKind> &scene_kinds()
  {
    static const std::map<std::string, SceneKind> kinds = {
        {"flow", kind<Flow>("blood flow through a rigid artery, a pipe, a channel or a mesh that "
                            "moves as given")},
        {"geometry", kind<Geometry>("build a surface, check it, report on it and write it")},
        {"immersed shell", kind<ImmersedShell>("a shell of any shape or a rigid surface in a flow, "
                                               "moving each other")},
        {"shell dynamics", kind<ShellDynamics>("any shell in motion")},
        {"shell statics", kind<ShellStatics>("any shell under static loads")},
        {"valve dynamics", kind<ValveDynamics>("the leaflets of a valve design, opening and "
                                               "closing under a transvalvular pressure")},
        {"valve fsi",
         kind<ValveFsi>("leaflets, stent and blood in a rigid or elastic artery, moving "
                        "each other")},
        {"valve statics",
         kind<ValveStatics>(
             "the leaflets of a valve design under static pressure, touching each other")},
    };
    return kinds;
  }

  std::vector<std::string> scene_kind_names()
  {
    std::vector<std::string> names;
    for (const auto &[name, kind] : scene_kinds())
      names.push_back(name);
    return names;
  }

  std::unique_ptr<Scene> declare_scene(const std::string &kind, const std::string &where,
                                       dealii::ParameterHandler &prm)
  {
    const auto found = scene_kinds().find(kind);
    if (found == scene_kinds().end())
      throw InputError(where, kind, "there is no such kind of scene",
                       suggest(kind, scene_kind_names()));
    prm.declare_entry("Scene", kind, dealii::Patterns::Selection(kind),
                      "Kind of scene: " + found->second.description + ".");
    std::unique_ptr<Scene> scene = found->second.create();
    scene->add_parameters(prm);
    scene->levels.finer = scene->finer();
    scene->levels.add_parameters(prm);
    scene->study.add_parameters(prm);
    return scene;
  }

  std::vector<std::string> kinds_with_section(const std::string &path)
  {
    std::vector<std::string> kinds;
    for (const std::string &kind : scene_kind_names())
    {
      dealii::ParameterHandler prm;
      const std::unique_ptr<Scene> scene = declare_scene(kind, "", prm);
      const std::vector<ParameterDescription> entries = list_parameters(prm);
      if (std::any_of(entries.begin(), entries.end(),
                      [&](const auto &entry) { return entry.path.rfind(path + "/", 0) == 0; }))
        kinds.push_back(kind);
    }
    return kinds;
  }
} // namespace semilunar::scene
