// SPDX-License-Identifier: Apache-2.0
#include "explain/rays_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/append.hpp"
#include "core/base64.hpp"
#include "core/json.hpp"
#include "math/bounds.hpp"

namespace zraka {
namespace {

constexpr std::size_t kSegmentKinds = kSegmentNames.size();

/// Linear red, green, blue of each kind's lines.
constexpr float kColors[kSegmentKinds][3] = {{0.9f, 0.9f, 0.9f}, {0.1f, 0.6f, 0.9f},
                                             {0.8f, 0.2f, 0.8f}, {0.9f, 0.7f, 0.1f},
                                             {0.8f, 0.1f, 0.1f}, {0.6f, 0.5f, 0.3f}};

void put_little_endian(float value, std::string& bytes) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(bits >> shift & 0xFF);
}

}  // namespace

std::string rays_as_obj(const std::vector<Segment>& segments, const std::string& title) {
  std::string text = fmt::format("# {}\n", title);
  std::size_t vertex = 0;
  for (std::size_t kind = 0; kind < kSegmentKinds; ++kind) {
    bool named = false;
    for (const Segment& s : segments) {
      if (static_cast<std::size_t>(s.kind) != kind) continue;
      if (!named) append(text, "o {}\n", kSegmentNames[kind]);
      named = true;
      for (const Vec3& p : {s.from, s.to}) append(text, "v {} {} {}\n", p.x, p.y, p.z);
      append(text, "l {} {}\n", vertex + 1, vertex + 2);
      vertex += 2;
    }
  }
  return text;
}

std::string rays_as_gltf(const std::vector<Segment>& segments) {
  // Floats are spent on the rays, not on their distance from the world's origin.
  Bounds box;
  for (const Segment& s : segments)
    for (const Vec3& p : {s.from, s.to}) box.include({p, p});
  const Vec3 center =
      box.empty() ? Vec3{}
                  : Vec3{box.lower.x / 2 + box.upper.x / 2, box.lower.y / 2 + box.upper.y / 2,
                         box.lower.z / 2 + box.upper.z / 2};
  Json gltf = {{"asset", {{"version", "2.0"}, {"generator", "zraka explain"}}},
               {"extensionsUsed", {"KHR_materials_unlit"}},
               {"scene", 0},
               {"scenes", Json::array({{{"nodes", Json::array()}}})},
               {"nodes", Json::array()},
               {"meshes", Json::array()},
               {"materials", Json::array()},
               {"accessors", Json::array()},
               {"bufferViews", Json::array()}};
  std::string bytes;
  for (std::size_t kind = 0; kind < kSegmentKinds; ++kind) {
    const std::size_t start = bytes.size();
    float lower[3] = {HUGE_VALF, HUGE_VALF, HUGE_VALF},
          upper[3] = {-HUGE_VALF, -HUGE_VALF, -HUGE_VALF};
    for (const Segment& s : segments) {
      if (static_cast<std::size_t>(s.kind) != kind) continue;
      for (const Vec3& p : {s.from, s.to}) {
        const double offset[3] = {p.x - center.x, p.y - center.y, p.z - center.z};
        for (int i = 0; i < 3; ++i) {
          const auto value = static_cast<float>(offset[i]);
          lower[i] = std::min(lower[i], value);
          upper[i] = std::max(upper[i], value);
          put_little_endian(value, bytes);
        }
      }
    }
    if (bytes.size() == start) continue;
    const std::size_t index = gltf["nodes"].size();
    const std::string name(kSegmentNames[kind]);
    gltf["scenes"][0]["nodes"].push_back(index);
    gltf["nodes"].push_back(
        {{"name", name}, {"mesh", index}, {"translation", {center.x, center.y, center.z}}});
    gltf["meshes"].push_back({{"name", name},
                              {"primitives", Json::array({{{"attributes", {{"POSITION", index}}},
                                                           {"material", index},
                                                           {"mode", 1}}})}});
    const float* c = kColors[kind];
    gltf["materials"].push_back(
        {{"name", name},
         {"pbrMetallicRoughness", {{"baseColorFactor", {c[0], c[1], c[2], 1}}}},
         {"extensions", {{"KHR_materials_unlit", Json::object()}}}});
    gltf["accessors"].push_back({{"bufferView", index},
                                 {"componentType", 5126},
                                 {"type", "VEC3"},
                                 {"count", (bytes.size() - start) / 12},
                                 {"min", lower},
                                 {"max", upper}});
    gltf["bufferViews"].push_back({{"buffer", 0},
                                   {"byteOffset", start},
                                   {"byteLength", bytes.size() - start},
                                   {"target", 34962}});
  }
  gltf["buffers"] =
      Json::array({{{"byteLength", bytes.size()},
                    {"uri", "data:application/octet-stream;base64," + base64(bytes)}}});
  return gltf.dump(1) + "\n";
}

}  // namespace zraka
