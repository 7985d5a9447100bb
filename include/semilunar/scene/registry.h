// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_scene_registry_h
#define semilunar_scene_registry_h

#include <semilunar/scene/scene.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace semilunar::scene
{
  struct SceneKind
  {
    std::string description;
    std::function<std::unique_ptr<Scene>()> create;
  };

  /// All kinds of scenes by name: what the entry Scene of a scene file selects.
  const std::map<std::string, SceneKind> &scene_kinds();

  std::vector<std::string> scene_kind_names();

  /// A new scene of this kind, all its entries declared in @p prm.
  /// @throws InputError at @p where if there is no such kind
  std::unique_ptr<Scene> declare_scene(const std::string &kind, const std::string &where,
                                       dealii::ParameterHandler &prm);

  /// The kinds that have a section of this path.
  std::vector<std::string> kinds_with_section(const std::string &path);
} // namespace semilunar::scene

#endif
