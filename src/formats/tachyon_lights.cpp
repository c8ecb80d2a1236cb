// SPDX-License-Identifier: Apache-2.0
// Tachyon's lights.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "formats/tachyon_reader.hpp"

namespace zraka {

bool TachyonReader::read_attenuation(Light& light) {
  if (!in_->take_keyword("ATTENUATION")) return true;
  const char* const at = in_->place();
  Vec3& a = light.attenuation;
  if (!number_of("CONSTANT", a.x) || !number_of("LINEAR", a.y) || !number_of("QUADRATIC", a.z))
    return false;
  if (a.x < 0 || a.y < 0 || a.z < 0 || a == Vec3{})
    return fail(at, fmt::format("ATTENUATION of {} is {} {} {}: expected numbers of 0 or more, not "
                                "all 0",
                                statement_, a.x, a.y, a.z));
  return true;
}

/// Its sphere is seen, has the light's colour and throws no shadow.
void TachyonReader::add_light(const Light& light, double radius) {
  scene_.lights.push_back(light);
  if (!(radius > 0)) return;
  const std::uint32_t material = material_of({.ambient = 1,
                                              .diffuse = 0,
                                              .r = light.color.r,
                                              .g = light.color.g,
                                              .b = light.color.b,
                                              .shines = 1});
  scene_.spheres.push_back({{light.position, radius}, material});
}

bool TachyonReader::read_light() {
  Light light;
  double radius = 0;
  if (!vector_of("CENTER", light.position) || !number_of("RAD", radius) ||
      !read_attenuation(light) || !color_of("COLOR", light.color))
    return false;
  add_light(light, radius);
  return true;
}

bool TachyonReader::read_directional_light() {
  const char* const at = in_->place();
  Light light;
  light.kind = LightKind::directional;
  Vec3& way = light.direction;
  if (!vector_of("DIRECTION", way) || !color_of("COLOR", light.color)) return false;
  if (way == Vec3{}) return fail(at, "DIRECTION of DIRECTIONAL_LIGHT is 0 0 0");
  scene_.lights.push_back(light);
  return true;
}

bool TachyonReader::read_spotlight() {
  Light light;
  light.kind = LightKind::spot;
  light.linear_edge = true;
  double radius = 0;
  const char* at = in_->place();
  if (!vector_of("CENTER", light.position) || !number_of("RAD", radius) ||
      !vector_of("DIRECTION", light.direction))
    return false;
  if (light.direction == Vec3{}) return fail(at, "DIRECTION of SPOTLIGHT is 0 0 0");
  at = in_->place();
  if (!number_of("FALLOFF_START", light.inner_deg) || !number_of("FALLOFF_END", light.outer_deg) ||
      !read_attenuation(light) || !color_of("COLOR", light.color))
    return false;
  if (light.inner_deg < 0 || !(light.outer_deg > 0) || light.outer_deg > 180 ||
      light.inner_deg > light.outer_deg)
    return fail(at,
                fmt::format("FALLOFF_START and FALLOFF_END of SPOTLIGHT are {} and {}: expected "
                            "degrees from 0 to 180, the first not more than the second",
                            light.inner_deg, light.outer_deg));
  add_light(light, radius);
  return true;
}

bool TachyonReader::read_occlusion(std::string_view samples) {
  if (!expect(samples)) return false;
  const char* const at = in_->place();
  double n = 0;
  if (!number(n, samples)) return false;
  if (n < 0 || n != std::floor(n) || n > kMaxSamples)
    return fail(at, fmt::format("{} of {} is {}: expected a whole number from 0 to {}", samples,
                                statement_, n, kMaxSamples));
  scene_.ambient_occlusion.samples = static_cast<int>(n);
  return true;
}

bool TachyonReader::read_sky_light() {
  return read_occlusion("NUMSAMPLES") && color_of("COLOR", scene_.ambient_occlusion.color);
}

}  // namespace zraka
