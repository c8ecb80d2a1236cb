// SPDX-License-Identifier: Apache-2.0
// The fold of docs/explain.md, C = local + k1·Crefl + k2·Crefr, from nothing but what `explain`
// prints as JSON, each operation in binary32.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <nlohmann/json.hpp>
#include <zraka/explain.hpp>
#include <zraka/school/mistakes.hpp>

namespace zraka {

inline Float3 color_from(const nlohmann::json& c) {
  return {c[0].get<float>(), c[1].get<float>(), c[2].get<float>()};
}

struct Fold {
  const nlohmann::json& explanation;
  Mistake mistake = Mistake::none;  ///< two of them change what is added

  Float3 color() const { return color_of(explanation["tree"]); }

 private:
  static void add(Float3& sum, const Float3& more, float share = 1) {
    for (std::size_t c = 0; c < 3; ++c) sum[c] = sum[c] + more[c] * share;
  }

  void add_child(Float3& sum, const nlohmann::json& child) const {
    if (child["ray"].is_null()) return;
    const Float3 color = color_of(child["ray"]);
    if (!child.contains("shares")) return add(sum, color, child["share"].get<float>());
    const Float3 shares = color_from(child["shares"]);
    for (std::size_t c = 0; c < 3; ++c) sum[c] = sum[c] + color[c] * shares[c];
  }

  Float3 color_of(const nlohmann::json& ray) const {
    if (ray["kind"] == "mean") return mean_of(ray["corners"]);
    if (ray["hit"].is_null()) {
      if (!explanation.contains("sky") && !ray.contains("fog")) {
        EXPECT_EQ(color_from(ray["color"]), color_from(explanation["background"]));
      }
      return color_from(ray["color"]);
    }
    const nlohmann::json& hit = ray["hit"];
    Float3 color = local_of(hit);
    EXPECT_EQ(color, color_from(hit["local"]));
    if (hit.contains("sky_beyond")) {
      add(color, color_from(hit["sky_beyond"]["reflected"]));
      add(color, color_from(hit["sky_beyond"]["refracted"]));
    }
    add_child(color, hit["reflected"]);
    add_child(color, hit["refracted"]);
    if (hit.contains("split"))
      for (const nlohmann::json& part : hit["split"]) add_child(color, part);
    EXPECT_EQ(color, color_from(hit["sum"]));
    if (explanation["clamp_levels"].get<bool>())
      for (float& c : color) c = std::min(std::max(c, 0.0f), 1.0f);
    if (hit.contains("medium")) {
      const Float3 left = color_from(hit["medium"]["transmittance"]);
      for (std::size_t c = 0; c < 3; ++c) color[c] = color[c] * left[c];
    }
    if (ray.contains("fog")) {
      const Float3 fog = color_from(ray["fog"]["color"]);
      const float left = ray["fog"]["left"].get<float>();
      for (std::size_t c = 0; c < 3; ++c) color[c] = color[c] * left + fog[c] * (1 - left);
    }
    EXPECT_EQ(color, color_from(ray["color"]));
    return color;
  }

  Float3 local_of(const nlohmann::json& hit) const {
    Float3 color = color_from(hit["ambient"]);
    for (const nlohmann::json& light : hit["lights"]) {
      if (mistake == Mistake::shadow_takes_ambient && light["reach"] == "blocked") color = {};
      for (const char* term : {"diffuse", "specular"})
        if (!light[term].is_null()) add(color, color_from(light[term]));
    }
    if (mistake == Mistake::total_white && !hit["snell"].is_null() && hit["snell"]["total"])
      add(color, {1, 1, 1}, hit["material"]["k2"].get<float>());
    return color;
  }

  Float3 mean_of(const nlohmann::json& corners) const {
    const Float3 a = color_of(corners[0]), b = color_of(corners[1]), c = color_of(corners[2]),
                 d = color_of(corners[3]);
    Float3 mean;
    for (std::size_t i = 0; i < 3; ++i) mean[i] = ((a[i] + b[i]) + (c[i] + d[i])) * 0.25f;
    return mean;
  }
};

inline bool same_bits(const Float3& a, const float* b) {
  for (std::size_t c = 0; c < 3; ++c)
    if (std::bit_cast<std::uint32_t>(a[c]) != std::bit_cast<std::uint32_t>(b[c])) return false;
  return true;
}

}  // namespace zraka
