// SPDX-License-Identifier: Apache-2.0
// Reads scenes of "The Ray Tracer Challenge" (Buck 2019): items that are added, and definitions
// that they are made from.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "core/scene_folder.hpp"
#include "formats/formats.hpp"
#include "formats/placed_shapes.hpp"
#include "formats/yaml.hpp"

namespace zraka {

class ChallengeReader {
 public:
  ChallengeReader(const std::string& name, const ReadOptions& options)
      : name_(name),
        folder_{options.folder.value_or(""), options.allow_outside},
        has_folder_(options.folder.has_value()) {}

  Result<ReadScene> read(const yaml::Node& root);

 private:
  using Node = yaml::Node;
  /// Where a shape goes: under a transform, with a material where it has none of its own.
  struct Place {
    Transform world;
    std::uint32_t material = 0;
    bool has_shadow = true;
    int depth = 0;
  };

  // challenge.cpp: items, definitions and values.
  void read_item(const Node& item);
  void define(const Node& item);
  /// What is defined, with what the item says itself in its place.
  Node expanded(const Node& item, int depth = 0);
  static Node merged(const Node& base, const Node& over);
  void add_camera(const Node& item);
  void add_light(const Node& item);
  std::optional<double> number(const Node& of, std::string_view key, double usual);
  bool flag(const Node& of, std::string_view key, bool usual);
  std::optional<Vec3> vector(const Node& node, std::string_view what);
  Vec3 vector(const Node& of, std::string_view key, const Vec3& usual);
  void fail(const Node& at, std::string message, std::string hint = {});
  void warn(const Node& at, std::string message);

  // challenge_materials.cpp
  std::uint32_t material_of(const Node& shape, const Place& place);
  std::optional<std::uint32_t> pattern_of(const Node& pattern);
  Transform transform_of(const Node* node);
  void add_steps(const Node& list, Transform& transform, int depth);
  std::optional<Transform> step_of(const Node& step);
  std::uint32_t texture_times(std::uint32_t texture, double factor);

  // challenge_shapes.cpp
  void add_shape(const Node& item, const Place& place);
  void add_body(std::string_view kind, const Node& item, const Place& place);
  void add_mesh(const Node& item, const Place& place);
  void add_csg(const Node& item, const Place& place);
  std::optional<CsgMember> member_of(const Node& item, const Place& place);
  std::optional<AnyBody> body_of(std::string_view kind, const Node& item, bool is_member);
  bool add_cone(const Node& item, const Place& place);
  static std::string kind_of(const Node& item);
  bool may_add(const Node& at);

  const std::string& name_;
  SceneFolder folder_;
  bool has_folder_;
  ReadScene read_;
  Scene& scene_ = read_.scene;
  PlacedShapes shapes_{scene_};
  Diagnostics errors_;
  std::map<std::string, Node, std::less<>> definitions_;
  int nesting_ = 0;          ///< of groups
  std::size_t defined_ = 0;  ///< nodes in all definitions, and in what was made of them
  bool has_camera_ = false;
};

}  // namespace zraka
