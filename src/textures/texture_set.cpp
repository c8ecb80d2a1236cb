// SPDX-License-Identifier: Apache-2.0
#include "textures/texture_set.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "math/elementary.hpp"
#include "textures/kinds.hpp"

namespace zraka {
namespace {

constexpr const TextureCode* kKinds[] = {
#define ZRAKA_ADDRESS(kind) &texture_kinds::kind,
    ZRAKA_TEXTURES(ZRAKA_ADDRESS)
#undef ZRAKA_ADDRESS
};

const TextureCode& code_of(const PreparedTexture& texture) {
  return *kKinds[static_cast<std::size_t>(texture.kind)];
}

V3<double> to_v3(const Vec3& v) {
  return {v.x, v.y, v.z};
}

constexpr double kHuge = kHugeNumber;

V3<double> finite_point(const V3<double>& p) {
  const auto finite = [](double v) { return std::fabs(v) < kHuge ? v : 0.0; };
  return {finite(p.x), finite(p.y), finite(p.z)};
}

V3<double> finite_axis(const V3<double>& a) {
  const auto finite = [](double v) { return std::fabs(v) < kHuge ? v : kHuge; };
  return {finite(a.x), finite(a.y), finite(a.z)};
}

/// The inverse by Cramer's rule. Where there is none, every point is the texture's origin.
IntoTexture inverse(const Transform& from_texture) {
  const V3<double> x = to_v3(from_texture.along_x), y = to_v3(from_texture.along_y),
                   z = to_v3(from_texture.along_z);
  const double volume = dot(x, cross(y, z));
  if (volume == 0 || !std::isfinite(1 / volume)) return {{}, {}, {}, {}};
  IntoTexture into{cross(y, z) * (1 / volume), cross(z, x) * (1 / volume),
                   cross(x, y) * (1 / volume)};
  into.origin = into.direction(-to_v3(from_texture.origin));
  return into;
}

/// Of any length but 0 and of any finite numbers, else along x.
V3<double> unit(const V3<double>& d) {
  const double most = std::max({std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)});
  const V3<double> scaled{d.x / most, d.y / most, d.z / most};
  const double length = std::sqrt(dot(scaled, scaled));
  if (!(length > 0)) return {1, 0, 0};  // NaN as well
  return {scaled.x / length, scaled.y / length, scaled.z / length};
}

/// How far along an axis of what the texture lies in takes a place as far as its finest parts.
double least_step(const PreparedTexture& t, const V3<double>& axis) {
  const V3<double> d = t.into.direction(axis);
  const double x = d.x / t.finest.x, y = d.y / t.finest.y, z = d.z / t.finest.z;
  const double step = 1 / std::sqrt(x * x + y * y + z * z);
  return step < kHuge ? step : 1;
}

PreparedTexture prepared(const Texture& from) {
  PreparedTexture t;
  t.kind = from.kind;
  t.mapping = from.mapping;
  t.into = inverse(from.transform);
  t.repeat_u = from.repeat_u, t.repeat_v = from.repeat_v;
  t.offset_u = from.offset_u, t.offset_v = from.offset_v;
  for (const Color& c : from.colors) t.colors.push_back({c.r, c.g, c.b});
  while (t.colors.size() < 2) t.colors.push_back(t.colors.empty() ? V3<double>{} : t.colors[0]);
  for (std::size_t i = 0; i < 2; ++i) t.first_colors[i] = t.colors[i];
  t.size = from.size > 0 ? std::clamp(from.size, 1 / kHuge, kHuge) : 1;
  int exponent = 0;
  if (std::frexp(t.size, &exponent) == 0.5) t.per_size = 1 / t.size;
  t.direction = unit(to_v3(from.direction));
  t.turbulence = std::fabs(from.turbulence) < kHuge ? from.turbulence : 0;
  t.octaves = std::clamp(from.octaves, 1, 32);
  t.seed = from.seed;
  t.wrap = from.wrap;
  t.filter = from.filter;
  t.reach = from.reach > 0 ? from.reach : 1;

  t.finest = V3<double>{1, 1, 1} * (t.size / 64);
  if (const auto prepare = code_of(t).prepare) prepare(from, t);
  t.least_step = {least_step(t, {1, 0, 0}), least_step(t, {0, 1, 0}), least_step(t, {0, 0, 1})};
  for (const V3<double>& row : {t.into.x, t.into.y, t.into.z})
    t.error_scale = std::max(t.error_scale, std::sqrt(dot(row, row)));
  t.sees_footprint = t.kind != TextureKind::image || t.filter == TextureFilter::mip;
  t.keeps_v = t.into.y.x == 0 && t.into.y.y == 1 && t.into.origin.y == 0;
  return t;
}

/// How often and from where on a texture goes round, for u and v that go round once.
V3<double> repeated(const PreparedTexture& t, double u, double v) {
  return {u * t.repeat_u + t.offset_u, v * t.repeat_v + t.offset_v, 0};
}

}  // namespace

void roll(const PreparedTexture& t, TexturePlace& place) {
  constexpr double kPi = 3.14159265358979323846;
  const V3<double> p = place.point;
  const double round = p.x * p.x + p.z * p.z, all = round + p.y * p.y;
  const double away = std::sqrt(round);
  double u = away > 0 ? elementary::atan2(p.z, p.x) / (2 * kPi) : 0;
  if (u < 0) u += 1;
  const bool sphere = t.mapping == TextureMapping::sphere;
  double v = p.y;
  if (sphere) v = all > 0 ? 0.5 + elementary::asin(std::fmin(std::fmax(p.y / std::sqrt(all), -1.0), 1.0)) / kPi : 0.5;
  place.point = finite_point(repeated(t, u, v));
  place.away = std::sqrt(all);
  if (!t.sees_footprint) return;
  for (V3<double>& axis : place.axes) {
    const double along_u =
        round > 0 ? (p.x * axis.z - p.z * axis.x) / (round * 2 * kPi) : kHuge;
    double along_v = axis.y;
    if (sphere)
      along_v = away > 0 ? (axis.y * round - p.y * (p.x * axis.x + p.z * axis.z)) / (all * away * kPi)
                         : kHuge;
    axis = finite_axis({along_u * t.repeat_u, along_v * t.repeat_v, 0});
  }
}

namespace {

void find_place(const PreparedTexture& t, const TexturePoint& at, TexturePlace& place) {
  place.distance = at.distance;
  place.error = 0, place.away = 1, place.v_ends = false;
  if (t.mapping == TextureMapping::uv) {
    place.point = finite_point(t.into.point({at.u, at.v, 0}));
    for (int i = 0; t.sees_footprint && i < 2; ++i)
      place.axes[i] = finite_axis(t.into.direction({at.footprint_u[i], at.footprint_v[i], 0}));
    place.v_ends = at.v_ends && t.keeps_v;
  } else {
    place.point = finite_point(t.into.point(at.point));
    for (int i = 0; t.sees_footprint && i < 2; ++i)
      place.axes[i] = finite_axis(t.into.direction(at.footprint[i]));
    place.error = at.error * t.error_scale;
    if (t.mapping == TextureMapping::cylinder || t.mapping == TextureMapping::sphere) roll(t, place);
  }
}

TexturePlace place_of(const PreparedTexture& t, const TexturePoint& at) {
  TexturePlace place;
  find_place(t, at, place);
  return place;
}

/// Whether find_place() makes the same of every point.
bool lie_alike(const PreparedTexture& a, const PreparedTexture& b) {
  return a.mapping == b.mapping && std::memcmp(&a.into, &b.into, sizeof(a.into)) == 0 &&
         a.repeat_u == b.repeat_u && a.repeat_v == b.repeat_v && a.offset_u == b.offset_u &&
         a.offset_v == b.offset_v && a.sees_footprint == b.sees_footprint;
}

/// Whether find_taps() makes the same of every place.
bool take_same_texels(const PreparedTexture& a, const PreparedTexture& b) {
  const auto by_distance = [](const PreparedTexture& t) {
    return t.filter == TextureFilter::distance && t.pyramid != nullptr;
  };
  return by_distance(a) && by_distance(b) && a.reach == b.reach &&
         a.pyramid->level(0).width == b.pyramid->level(0).width &&
         a.pyramid->level(0).height == b.pyramid->level(0).height;
}

double brightness(const TextureValue& c) {
  return (c.x + c.y + c.z) / 3;
}

double length(double a, double b) {
  return std::sqrt(a * a + b * b);
}

double step_for(double footprint, double least) {
  return footprint < kHuge ? std::max(footprint, least) : kHuge;
}

/// The difference of brightness over twice a step, where move(at, ±step) goes that far.
template <class Move>
double difference(const PreparedTexture& t, const TexturePoint& at, double footprint, double least,
                  Move move) {
  const double step = step_for(footprint, least);
  TexturePoint ahead = at, behind = at;
  move(ahead, step);
  move(behind, -step);
  const auto value = code_of(t).value;
  return (brightness(value(t, place_of(t, ahead))) - brightness(value(t, place_of(t, behind)))) /
         (2 * step);
}

/// The same along x, y and z at once: of a solid texture all places have one footprint.
V3<double> slope_of_values(const PreparedTexture& t, const TexturePoint& at,
                           const double (&footprint)[3]) {
  const double steps[3] = {step_for(footprint[0], t.least_step.x),
                           step_for(footprint[1], t.least_step.y),
                           step_for(footprint[2], t.least_step.z)};
  V3<double> points[6];
  for (V3<double>& point : points) point = at.point;
  points[0].x += steps[0], points[1].x -= steps[0];
  points[2].y += steps[1], points[3].y -= steps[1];
  points[4].z += steps[2], points[5].z -= steps[2];
  for (V3<double>& point : points) point = finite_point(t.into.point(point));
  TextureValue values[6];
  code_of(t).values(t, place_of(t, at), points, 6, values);
  const auto along = [&](std::size_t i) {
    return (brightness(values[2 * i]) - brightness(values[2 * i + 1])) / (2 * steps[i]);
  };
  return {along(0), along(1), along(2)};
}

}  // namespace

TextureValue value_at(const PreparedTexture& texture, const TexturePlace& at) {
  return code_of(texture).value(texture, at);
}

TextureSet::TextureSet(const std::vector<Texture>& textures) {
  textures_.reserve(textures.size());
  for (const Texture& texture : textures) textures_.push_back(prepared(texture));
  // Those that are alike are a material's, which stand side by side.
  constexpr std::size_t kNear = 8;
  for (std::size_t i = 0; i < textures_.size(); ++i) {
    PreparedTexture& t = textures_[i];
    for (std::size_t j = i < kNear ? 0 : i - kNear; j <= i; ++j) {
      const auto index = static_cast<std::uint32_t>(j);
      if (j != i && !lie_alike(textures_[j], t)) continue;
      if (t.placed_like == PreparedTexture::kNone) t.placed_like = index;
      if (t.sampled_like == PreparedTexture::kNone && take_same_texels(textures_[j], t))
        t.sampled_like = index;
    }
  }
}

TextureValue TextureSet::value(std::uint32_t texture, const TexturePoint& at) const {
  const PreparedTexture& t = textures_[texture];
  return code_of(t).value(t, place_of(t, at));
}

TextureValue TextureSet::value(std::uint32_t texture, const TexturePoint& at,
                               TextureLookup& known) const {
  if (known.texture == texture) return known.value;  // a colour is two coefficients with one texture
  known.texture = texture;
  const PreparedTexture& t = textures_[texture];
  if (known.placed != t.placed_like) {
    known.placed = t.placed_like, known.sampled = PreparedTexture::kNone;
    find_place(t, at, known.place);
  }
  if (t.sampled_like == PreparedTexture::kNone)
    return known.value = code_of(t).value(t, known.place);
  if (known.sampled != t.sampled_like) {
    known.sampled = t.sampled_like;
    find_taps(t, known.place, known.taps);
  }
  return known.value = value_of_taps(t, known.taps);
}

V3<double> TextureSet::slope(std::uint32_t texture, const TexturePoint& at) const {
  const PreparedTexture& t = textures_[texture];
  const V3<double>&a = at.footprint[0], &b = at.footprint[1], &least = t.least_step;
  if (t.mapping == TextureMapping::uv) {
    const double u = length(at.footprint_u[0], at.footprint_u[1]);
    const double v = length(at.footprint_v[0], at.footprint_v[1]);
    return {difference(t, at, u, least.x, [](TexturePoint& p, double step) { p.u += step; }),
            difference(t, at, v, least.y, [](TexturePoint& p, double step) { p.v += step; }), 0};
  }
  const double along[3] = {length(a.x, b.x), length(a.y, b.y), length(a.z, b.z)};
  if (t.mapping == TextureMapping::solid && code_of(t).values != nullptr)
    return slope_of_values(t, at, along);
  return {difference(t, at, along[0], least.x,
                     [](TexturePoint& p, double step) { p.point.x += step; }),
          difference(t, at, along[1], least.y,
                     [](TexturePoint& p, double step) { p.point.y += step; }),
          difference(t, at, along[2], least.z,
                     [](TexturePoint& p, double step) { p.point.z += step; })};
}

std::uint64_t TextureSet::bytes() const {
  std::uint64_t bytes = 0;
  for (const PreparedTexture& t : textures_)
    for (std::size_t i = 1; t.pyramid != nullptr && i < t.pyramid->levels(); ++i)
      bytes += t.pyramid->level(i).pixels.size() * sizeof(float);
  return bytes;
}

}  // namespace zraka
