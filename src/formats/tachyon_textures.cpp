// SPDX-License-Identifier: Apache-2.0
// Tachyon's textures: how surfaces shine, their patterns and the pictures on them.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "formats/tachyon_reader.hpp"
#include "formats/vectors.hpp"

namespace zraka {
namespace {

/// The map from u and v to space whose inverse is u = a·(p - center) + at_u, v likewise. None where
/// the two are parallel.
std::optional<Transform> plane_map(const Vec3& a, const Vec3& b, const Vec3& center, double at_u,
                                   double at_v) {
  const Vec3 c = cross(a, b);
  const double volume = dot(c, c);
  if (!(volume > 0) || !std::isfinite(1 / volume)) return std::nullopt;
  Transform t;
  t.along_x = cross(b, c) * (1 / volume);
  t.along_y = cross(c, a) * (1 / volume);
  t.along_z = c * (1 / volume);
  t.origin = {center.x - at_u * t.along_x.x - at_v * t.along_y.x,
              center.y - at_u * t.along_x.y - at_v * t.along_y.y,
              center.z - at_u * t.along_x.z - at_v * t.along_y.z};
  return t;
}

}  // namespace

std::size_t TachyonReader::SurfaceHash::operator()(const TachyonSurface& s) const {
  std::size_t hash = 0;
  for (const double v : {s.ambient, s.diffuse, s.mirror, s.opacity, s.highlight, s.shininess,
                         s.metal, s.r, s.g, s.b, s.pattern, s.shines, s.cut})
    hash = hash * 1099511628211u ^ std::hash<double>()(v);
  return hash;
}

std::uint32_t TachyonReader::material_of(TachyonSurface surface) {
  surface.cut = cut_group_;
  if (surface == last_) return last_material_;
  const auto [entry, fresh] =
      materials_.try_emplace(surface, static_cast<std::uint32_t>(surfaces_.size()));
  if (fresh) surfaces_.push_back(surface);
  last_ = surface;
  last_material_ = entry->second;
  return last_material_;
}

/// TEXTURE and what it is like, or a name.
bool TachyonReader::surface(std::uint32_t& material) {
  if (in_->take_keyword("TEXTURE")) {
    TachyonSurface own;
    if (!surface_body(own, false)) return false;
    material = material_of(own);
    return true;
  }
  const char* const at = in_->place();
  const std::string_view word = in_->peek();
  if (word.empty())
    return fail(at, fmt::format("the file ends: expected TEXTURE of {}", statement_));
  // A forgotten texture would take the next statement for its name.
  const auto named = names_.find(word);
  if (named == names_.end() && statement_of(word) != nullptr)
    return fail(
        at, fmt::format("'{}' does not belong here: expected TEXTURE, or the name of one, of {}",
                        shown(word), statement_));
  in_->take();
  if (named == names_.end()) {
    warn(at, fmt::format("there is no TEXDEF '{}' before this: white is taken", shown(word)));
    material = material_of({});
  } else {
    material = material_of(named->second);
  }
  return true;
}

bool TachyonReader::surface_body(TachyonSurface& s, bool painted) {
  if (!number_of("AMBIENT", s.ambient) || !number_of("DIFFUSE", s.diffuse) ||
      !number_of("SPECULAR", s.mirror) || !number_of("OPACITY", s.opacity))
    return false;
  const char* at = in_->place();
  if (in_->take_keyword("TRANSMODE")) {
    if (is_keyword(in_->take(), "R3D"))
      warn(at, "TRANSMODE R3D is left out: opacity does not change with the angle");
    at = in_->place();
  }
  if (in_->take_keyword("OUTLINE")) {
    double outline = 0, width = 0;
    if (!number(outline, "OUTLINE") || !number_of("OUTLINE_WIDTH", width)) return false;
    if (outline > 0) warn(at, "OUTLINE is left out: edges are not drawn darker");
  }
  if (in_->take_keyword("PHONG")) {
    s.metal = is_keyword(in_->take(), "METAL") ? 1 : 0;
    if (!number(s.highlight, "PHONG") || !number_of("PHONG_SIZE", s.shininess)) return false;
  }
  const auto to_share = [](double x) { return std::clamp(x, 0.0, 1.0); };
  s.opacity = to_share(s.opacity);
  s.shininess = std::fmax(s.shininess, 0.0);
  if (painted) return expect("VCST");
  Color c;
  if (!color_of("COLOR", c)) return false;
  s.r = c.r, s.g = c.g, s.b = c.b;
  at = in_->place();
  double function = 0;
  if (!number_of("TEXFUNC", function)) return false;
  if (function == 0) return true;
  if (function < 0 || function > 10 || function != std::floor(function))
    return fail(at, fmt::format("TEXFUNC is {}: expected a whole number from 0 to 10", function));
  return read_pattern(static_cast<int>(function), s);
}

/// Textures by a formula: those that ours can be, the others by what comes near them.
bool TachyonReader::read_pattern(int function, TachyonSurface& s) {
  if (function >= 7) return read_image_pattern(function, s);
  const char* const at = in_->place();
  Vec3 center, rotate, scale;
  if (!vector_of("CENTER", center) || !vector_of("ROTATE", rotate) || !vector_of("SCALE", scale))
    return false;
  // Noise of whole numbers: its colour nearly everywhere.
  if (function == 5) return true;
  if (function == 2) {
    warn(at, "TEXFUNC 2 is random grit: its mean colour is taken");
    s.r *= 0.9, s.g *= 0.9, s.b *= 0.9;
    return true;
  }
  const auto [known, fresh] = pattern_of_.try_emplace(
      {static_cast<double>(function), center.x, center.y, center.z, scale.x, scale.y, scale.z},
      patterns_.size());
  s.pattern = static_cast<double>(known->second + 1);
  s.r = s.g = s.b = 1;  // their colours are their own
  if (!fresh) return true;
  Texture t;
  t.transform.origin = center;
  if (function == 1 || function == 6) {
    t.kind = TextureKind::checker;
    t.colors = {{0, 0.2, 1}, {1, 0.2, 0}};
  }
  if (function == 1) {
    // Cells lie around multiples of a third.
    t.size = 1.0 / 3;
    t.transform.origin = {center.x - t.size / 2, center.y - t.size / 2, center.z - t.size / 2};
  }
  if (function == 6) {
    t.mapping = TextureMapping::cylinder;
    t.transform.along_y = {0, 0, 1};
    t.transform.along_z = {0, 1, 0};
    t.repeat_u = 18, t.repeat_v = 10;
  }
  if (function == 3) {
    warn(at, "TEXFUNC 3 is drawn as marble of another kind");
    t.kind = TextureKind::marble;
    t.colors = {{0.5, 0.5, 1}, {1, 0.8, 0.3}, {0.2, 0.5, 0.6}};
    t.size = 2;
    t.turbulence = 1;
  }
  if (function == 4) {
    warn(at, "TEXFUNC 4 is drawn as wood of another kind");
    t.kind = TextureKind::wood;
    t.colors = {{0.8, 1, 0.2}, {0, 0, 0}};
    t.size = 60;
    t.direction = {0, 1, 0};
    t.transform.along_x = {scale.x, 0, 0};
    t.transform.along_y = {0, scale.y, 0};
    t.transform.along_z = {0, 0, scale.z};
  }
  patterns_.push_back(t);
  return true;
}

bool TachyonReader::read_image_pattern(int function, TachyonSurface& s) {
  std::string name;
  const char* const at = in_->place();
  Vec3 center, rotate, scale, u_axis{1, 0, 0}, v_axis{0, 1, 0}, w_axis;
  if (!file_name("an image's name", name) || !vector_of("CENTER", center) ||
      !vector_of("ROTATE", rotate) || !vector_of("SCALE", scale))
    return false;
  if (function >= 9 && (!vector_of("UAXIS", u_axis) || !vector_of("VAXIS", v_axis))) return false;
  if (function == 10 && !vector_of("WAXIS", w_axis)) return false;
  int slice = 0;
  bool is_volume = false;
  if (function == 10) {
    const double depth = rotate.z - std::trunc(rotate.z) + (rotate.z < 0 ? 1 : 0);
    const auto defined = definitions_.find(name);
    if (defined != definitions_.end()) {
      slice = static_cast<int>((defined->second.size[2] - 1.0) * depth);
      is_volume = defined->second.size[2] > 1;
    }
    if (dot(w_axis, w_axis) * scale.z * scale.z > 0)
      warn(at, "TEXFUNC 10 has the same slice of its image everywhere");
  }
  const std::shared_ptr<const Image> image = image_named(at, name, slice);
  s.r = s.g = s.b = 1;
  if (image == nullptr) return true;  // said already
  std::vector<double> key{static_cast<double>(function)};
  for (const Vec3& v : {center, rotate, scale, u_axis, v_axis})
    key.insert(key.end(), {v.x, v.y, v.z});
  key.push_back(slice);
  for (const char c : name) key.push_back(c);
  const auto [known, fresh] = pattern_of_.try_emplace(std::move(key), patterns_.size());
  s.pattern = static_cast<double>(known->second + 1);
  if (!fresh) return true;
  Texture t;
  t.kind = TextureKind::image;
  t.image = image;
  if (!is_targa(name) && definitions_.find(name) == definitions_.end()) t.file = name;
  t.transfer = Transfer::linear;
  t.filter = TextureFilter::distance;
  // Rolled images are a single pixel at 160 times a point's distance from their centre, by scales.
  const double most = std::fmax(std::fabs(scale.x), std::fabs(scale.y));
  t.reach = (function == 7 || function == 8 ? 160 : 20) / most;
  if (is_volume || !(most > 0)) t.reach = 1e30;  // has no smaller ones
  // Tachyon's v goes down.
  if (function == 7 || function == 8) {
    t.mapping = function == 7 ? TextureMapping::cylinder : TextureMapping::sphere;
    t.transform.origin = center;
    t.repeat_u = scale.x, t.offset_u = rotate.x;
    t.repeat_v = -scale.y, t.offset_v = 1 - rotate.y;
  } else {
    const auto map = plane_map(u_axis * scale.x, v_axis * -scale.y, center, rotate.x, 1 - rotate.y);
    if (!map) {
      warn(at, "UAXIS and VAXIS of a texture are parallel, or it has no SCALE: white is drawn");
      pattern_of_.erase(known);
      s.pattern = 0;
      return true;
    }
    t.transform = *map;
  }
  patterns_.push_back(std::move(t));
  return true;
}

bool TachyonReader::read_texdef() {
  std::string name;
  if (!file_name("a name", name)) return false;
  TachyonSurface surface;
  if (!surface_body(surface, false)) return false;
  names_.try_emplace(name, surface);  // of several the first counts
  return true;
}

bool TachyonReader::read_texalias() {
  std::string name, other;
  if (!file_name("a name", name)) return false;
  const char* const at = in_->place();
  if (!file_name("the name of a texture", other)) return false;
  const auto named = names_.find(other);
  if (named == names_.end())
    warn(at, fmt::format("there is no TEXDEF '{}' before this: white is taken", shown(other)));
  names_.try_emplace(name, named == names_.end() ? TachyonSurface{} : named->second);
  return true;
}

}  // namespace zraka
