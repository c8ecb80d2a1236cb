// SPDX-License-Identifier: Apache-2.0
#include "formats/nff_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/polygon.hpp"
#include "scene/view.hpp"

namespace zraka {
namespace {

/// Corners of a polygon; cutting one into triangles takes time that grows with their square.
constexpr std::size_t kMostCorners = 20000;

constexpr const char* kInsideOut =
    "a negative radius makes only the inside visible in NFF; here both sides are";
constexpr std::array<std::string_view, 6> kWordsOfView = {"from",  "at",     "up",
                                                          "angle", "hither", "resolution"};

}  // namespace

void NffReader::add(Severity severity, const char* at, std::string message, std::string hint) {
  const auto position = static_cast<std::size_t>(at - text_.data());
  const TextPosition place = places_.at(position);
  (severity == Severity::error ? errors_ : warnings_)
      .push_back({severity, name_, place.line, place.column, std::move(message), std::move(hint),
                  places_.excerpt(position)});
}

void NffReader::warn_once(bool& said, const char* at, std::string message) {
  if (!said) add(Severity::warning, at, std::move(message));
  said = true;
}

void NffReader::skip_space() {
  for (; at_ != end_; ++at_) {
    if (*at_ == '#') {
      at_ = std::find(at_, end_, '\n');
      if (at_ == end_) return;
    } else if (*at_ != ' ' && *at_ != '\n' && *at_ != '\t' && *at_ != '\r') {
      return;
    }
  }
}

std::string_view NffReader::word_at(const char* at) const {
  const char* stop = std::find_if(
      at, end_, [](char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r' || c == '#'; });
  return {at, static_cast<std::size_t>(stop - at)};
}

bool NffReader::number(double& value, const char* what) {
  skip_space();
  if (at_ == end_) return fail(at_, fmt::format("the file ends: expected {}", what));
  const char* const stop = read_number(at_, end_, value);
  const auto ends = [&](const char* p) {
    return p == end_ || *p == ' ' || *p == '\n' || *p == '\t' || *p == '\r' || *p == '#';
  };
  if (stop != nullptr && ends(stop) && std::isfinite(value)) {
    at_ = stop;
    return true;
  }
  const std::string_view word = word_at(at_);
  // What is too small for a double is 0.
  const std::optional<double> rounded = parse_number(word);
  if (rounded && std::isfinite(*rounded)) {
    value = *rounded;
    at_ += word.size();
    return true;
  }
  return fail(at_, fmt::format("'{}' is not a finite number: expected {}", shown(word), what));
}

bool NffReader::vector(Vec3& v, const char* what) {
  return number(v.x, what) && number(v.y, what) && number(v.z, what);
}

/// Does a number follow before the line ends?
bool NffReader::number_on_line() {
  const char* p = at_;
  while (p != end_ && (*p == ' ' || *p == '\t')) ++p;
  return p != end_ && (*p == '-' || *p == '+' || *p == '.' || (*p >= '0' && *p <= '9'));
}

bool NffReader::read_view() {
  double hither = 0, width = 0, height = 0;
  view_failed_ = true;  // until it has been read
  for (const std::string_view want : kWordsOfView) {
    skip_space();
    const std::string_view word = word_at(at_);
    if (word != want)
      return fail(at_, fmt::format("'{}' does not belong here: expected '{}' of the view",
                                   shown(word), want));
    at_ += word.size();
    const char* place = at_;
    if (want == "from" && !vector(from_, "the eye's place")) return false;
    if (want == "at" && !vector(to_, "the place looked at")) return false;
    if (want == "up" && !vector(up_, "the upward direction")) return false;
    if (want == "angle") {
      if (!number(angle_, "the angle of view")) return false;
      if (!(angle_ > 0 && angle_ < 180))
        return fail(place, fmt::format("angle is {}: expected degrees from 0 to 180", angle_));
    }
    if (want == "hither" && !number(hither, "the hither distance")) return false;
    if (want == "resolution") {
      if (!number(width, "the width") || !number(height, "the height")) return false;
      if (width < 1 || height < 1 || width != std::floor(width) || height != std::floor(height))
        return fail(place, fmt::format("resolution is {} {}: expected whole numbers, 1 or more",
                                       width, height));
      if (width * height > static_cast<double>(kMaxPixels))
        return fail(place, fmt::format("resolution is {} {}: expected {} pixels at most", width,
                                       height, kMaxPixels));
      scene_.resolution = {static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)};
    }
  }
  viewed_ = true;
  view_failed_ = false;
  if (from_ == to_) return fail(at_, "the eye is at the place that it looks at");
  if (!look_at(from_, to_, up_, angle_, 1))
    return fail(at_, "the upward direction is the one of the view");
  return true;
}

bool NffReader::read_light() {
  Light light;
  if (!vector(light.position, "the light's place")) return false;
  if (number_on_line()) {
    if (!number(light.color.r, "the light's red") || !number(light.color.g, "the light's green") ||
        !number(light.color.b, "the light's blue"))
      return false;
  } else {
    plain_lights_.push_back(scene_.lights.size());  // the intensity is known once all lights are
  }
  scene_.lights.push_back(light);
  return true;
}

bool NffReader::read_material() {
  constexpr std::array<const char*, 8> kNames = {"red", "green", "blue", "Kd",
                                                 "Ks",  "Shine", "T",    "index of refraction"};
  Row row;
  const char* place = at_;
  for (std::size_t i = 0; i < row.size(); ++i)
    if (!number(row[i], kNames[i])) return false;
  if (const double most = std::max({row[0], row[1], row[2]}); most > 1)
    warn_once(too_bright_said_, place,
              fmt::format("a colour of {} is brighter than white: NFF's are from 0 to 1", most));
  material_ = material_of(row);
  return true;
}

/// The scene's material of these numbers, a new one if there is none.
std::uint32_t NffReader::material_of(const Row& row) {
  const auto [entry, fresh] =
      materials_.try_emplace(row, static_cast<std::uint32_t>(scene_.materials.size()));
  if (!fresh) return entry->second;
  rows_.push_back(row);
  const auto [r, g, b, kd, ks, shine, t, index] = row;
  const Color color{r * kd, g * kd, b * kd};
  // Opaque materials carry any index; and a Shine of 100000 with no Ks, which is no highlight.
  scene_.materials.push_back({.ambient = color,
                              .diffuse = color,
                              .specular = {ks, ks, ks},
                              .shininess = std::fmax(shine, 0.0),
                              .reflection = ks,
                              .refraction = t,
                              .ior = t != 0 && index > 0 ? index : 1});
  return entry->second;
}

bool NffReader::read_sphere() {
  Sphere s;
  const char* place = at_;
  if (!vector(s.center, "the sphere's centre") || !number(s.radius, "the sphere's radius"))
    return false;
  if (s.radius == 0) return fail(place, "the sphere's radius is 0");
  if (s.radius < 0) warn_once(inside_out_said_, place, kInsideOut);
  s.radius = std::fabs(s.radius);
  scene_.spheres.push_back({s, *material_});
  return true;
}

bool NffReader::read_cone() {
  Cone c;
  const char* place = at_;
  if (!vector(c.base, "the cone's base") || !number(c.base_radius, "the base's radius") ||
      !vector(c.apex, "the cone's apex") || !number(c.apex_radius, "the apex' radius"))
    return false;
  if (c.base_radius < 0 || c.apex_radius < 0) warn_once(inside_out_said_, place, kInsideOut);
  c.base_radius = std::fabs(c.base_radius);
  c.apex_radius = std::fabs(c.apex_radius);
  if (c.base == c.apex) return fail(place, "the cone's ends are one point");
  if (!(c.base_radius + c.apex_radius > 0)) return fail(place, "both of the cone's radii are 0");
  scene_.cones.push_back({c, *material_});
  return true;
}

bool NffReader::read_polygon(bool with_normals) {
  double count = 0;
  skip_space();
  const char* place = at_;
  if (!number(count, "the number of corners")) return false;
  const double room = static_cast<double>(end_ - at_) / (with_normals ? 12 : 6);
  if (count < 3 || count != std::floor(count) || count > static_cast<double>(kMostCorners) ||
      count > room + 1)
    return fail(
        place,
        fmt::format(
            "number of corners is {}: expected a whole number from 3 to {}, and as many corners",
            count, +kMostCorners));
  std::vector<Vec3> corners(static_cast<std::size_t>(count)),
      normals(with_normals ? corners.size() : 0);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (!vector(corners[i], "a corner")) return false;
    if (with_normals && !vector(normals[i], "a corner's normal")) return false;
  }
  for (const auto& [a, b, c] : triangulate(corners)) {
    if (with_normals)
      scene_.smooth_triangles.push_back(
          {{corners[a], corners[b], corners[c], normals[a], normals[b], normals[c]}, *material_});
    else
      scene_.triangles.push_back({{corners[a], corners[b], corners[c]}, *material_});
  }
  return true;
}

bool NffReader::read_entity(std::string_view word) {
  const char* place = at_;
  at_ += word.size();
  has_globals_ = has_globals_ || word == "v" || word == "b" || word == "l";
  if (word == "v") return read_view();
  if (word == "b") {
    return number(scene_.background.r, "the background's red") &&
           number(scene_.background.g, "the background's green") &&
           number(scene_.background.b, "the background's blue");
  }
  if (word == "l") return read_light();
  if (word == "f") return read_material();
  if (word == "s" || word == "c" || word == "p" || word == "pp") {
    if (!material_) {
      fail(place, fmt::format("'{}' has no material: expected 'f' before the first shape", word));
      material_ = 0;  // said once
    }
    return word == "s" ? read_sphere() : word == "c" ? read_cone() : read_polygon(word == "pp");
  }
  // What is left of a view that was wrong has been spoken of.
  if (view_failed_ &&
      std::find(kWordsOfView.begin(), kWordsOfView.end(), word) != kWordsOfView.end())
    return false;
  return fail(place, fmt::format("'{}' is no word of NFF: expected v, b, l, f, s, c, p or pp",
                                 shown(word)));
}

void NffReader::set_scene_up() {
  const double aspect = static_cast<double>(scene_.resolution.width) / scene_.resolution.height;
  scene_.camera = look_at(from_, to_, up_, angle_, aspect).value();
  // The databases' rule, for formats without intensities.
  const auto n = static_cast<double>(std::max<std::size_t>(1, scene_.lights.size()));
  const double intensity = std::sqrt(n) / (2 * n);
  for (const std::size_t i : plain_lights_)
    scene_.lights[i].color = {intensity, intensity, intensity};
  scene_.ambient_light = {intensity, intensity, intensity};
}

/// Every few megabytes room is taken for what is likely to come, for a list that grows by copies is
/// in memory twice.
void NffReader::look_ahead() {
  constexpr std::uint64_t kStep = 1 << 24;
  const std::uint64_t read = taken_ + static_cast<std::uint64_t>(at_ - text_.data());
  if (read - looked_ahead_ < kStep) return;
  looked_ahead_ = read;
  const double part = static_cast<double>(read) / static_cast<double>(whole_);
  const auto make_room = [&](auto& objects) {
    const double likely = static_cast<double>(objects.size()) / part * 1.01 + 1000;
    if (objects.size() < 1000 || likely <= static_cast<double>(objects.capacity())) return;
    try {
      objects.reserve(static_cast<std::size_t>(likely));
    } catch (const std::exception&) {  // it may do without
    }
  };
#define ZRAKA_MAKE_ROOM(Type, plural) make_room(scene_.plural);
  ZRAKA_SHAPES(ZRAKA_MAKE_ROOM)
#undef ZRAKA_MAKE_ROOM
}

void NffReader::read_to(const char* stop) {
  while (!has_enough()) {
    look_ahead();
    skip_space();
    if (at_ >= stop) return;
    if (read_entity(word_at(at_))) continue;
    at_ = std::find(at_, end_, '\n');  // on with the next line
  }
}

bool NffReader::read_shapes() {
  scene_.materials.resize(1);  // stands for the last one before the block
  material_ = 0;
  for (;;) {
    skip_space();
    if (at_ == end_) return true;
    if (!read_entity(word_at(at_)) || has_globals_ || !warnings_.empty()) return false;
  }
}

bool NffReader::comes_to(const char* place) {
  if (at_ > place) return false;
  skip_space();
  return at_ == place;
}

bool NffReader::take(const NffReader& block, const char* after) {
  if (!material_) return false;
  std::vector<std::uint32_t> material(block.rows_.size() + 1, *material_);
  for (std::size_t i = 0; i < block.rows_.size(); ++i)
    material[i + 1] = material_of(block.rows_[i]);
  material_ = material[*block.material_];
  const auto append = [&](auto& all, const auto& more) {
    for (const auto& object : more) all.push_back({object.shape, material[object.material]});
  };
#define ZRAKA_APPEND(Type, plural) append(scene_.plural, block.scene_.plural);
  ZRAKA_SHAPES(ZRAKA_APPEND)
#undef ZRAKA_APPEND
  if (after != nullptr)
    at_ = after;
  else
    taken_ += block.text_.size();
  look_ahead();
  return true;
}

Result<ReadScene> NffReader::finish() {
  if (has_enough()) fail(at_, "too many problems; the rest of the file is not read");
  if (!viewed_ && !view_failed_) fail(end_, "the file has no view: expected 'v'");
  if (!errors_.empty()) return tl::make_unexpected(std::move(errors_));
  set_scene_up();
  return ReadScene{std::move(scene_), std::move(warnings_)};
}

}  // namespace zraka
