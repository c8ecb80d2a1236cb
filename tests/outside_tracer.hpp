// SPDX-License-Identifier: Apache-2.0
// A small tracer of the lab that shares nothing with the engine, and makes mistakes that the
// catalogue does not have.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <zraka/image.hpp>
#include <zraka/scene.hpp>

#include "outside_slips.hpp"

namespace zraka::outside {

struct Vector {
  double x = 0, y = 0, z = 0;
  friend Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vector operator*(Vector a, Vector b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
  friend Vector operator*(double s, Vector a) { return {s * a.x, s * a.y, s * a.z}; }
  double dot(Vector o) const { return x * o.x + y * o.y + z * o.z; }
  double length() const { return std::sqrt(dot(*this)); }
  Vector unit() const { return 1 / length() * *this; }
};

/// The sheet's TraceRay in double, stage by stage (1 to 7), for spheres and the lab's profile.
class Tracer {
 public:
  Tracer(const Scene& scene, int stage, Slip slip = Slip::none)
      : scene_(scene), stage_(stage), slip_(slip) {}

  Image picture() const {
    const std::uint32_t width = scene_.resolution.width, height = scene_.resolution.height;
    Image image(width, height);
    const Vector eye{0, 0, is(Slip::eye_nearer) ? 1.6 : 2};
    for (std::uint32_t y = 0; y < height; ++y)
      for (std::uint32_t x = 0; x < width; ++x) {
        const Vector at{2.0 * x / width - 1, 1 - 2.0 * y / height, 0};
        const Vector color = is(Slip::parallel_rays) ? trace(at + eye, {0, 0, -1}, 0)
                                                     : trace(eye, (at - eye).unit(), 0);
        float* pixel = image.row(y) + std::size_t{3} * x;
        pixel[0] = static_cast<float>(color.x);
        pixel[1] = static_cast<float>(color.y);
        pixel[2] = static_cast<float>(color.z);
      }
    finish(image);
    return image;
  }

 private:
  bool is(Slip slip) const { return slip_ == slip; }
  static Vector of(const Color& color) { return {color.r, color.g, color.b}; }
  static double clamped(double v) { return v < 0 ? 0 : v > 1 ? 1 : v; }
  static Vector clamped(Vector v) { return {clamped(v.x), clamped(v.y), clamped(v.z)}; }

  Vector center(std::size_t i) const {
    const Vec3& c = scene_.spheres[i].shape.center;
    return {c.x, is(Slip::moved_down) ? c.y - 0.15 : c.y, c.z};
  }
  double radius(std::size_t i) const {
    const double r = scene_.spheres[i].shape.radius;
    if (is(Slip::radius_squared)) return r * r;
    if (is(Slip::radius_halved)) return r / 2;
    return is(Slip::radius_larger) && r < 10 ? 1.15 * r : r;
  }

  static constexpr double kNowhere = std::numeric_limits<double>::infinity();
  struct Hit {
    std::size_t sphere = 0;
    double t = kNowhere;
  };
  Hit nearest(Vector from, Vector way, double epsilon = 1e-4) const {
    Hit hit;
    for (std::size_t i = is(Slip::first_missing) ? 1 : 0; i < scene_.spheres.size(); ++i)
      if (const double t = meet(i, from, way, epsilon); t < hit.t) hit = {i, t};
    return hit;
  }
  Hit farthest(Vector from, Vector way) const {
    Hit hit{0, 0};
    for (std::size_t i = 0; i < scene_.spheres.size(); ++i)
      if (const double t = meet(i, from, way, 1e-4); t < kNowhere && t > hit.t) hit = {i, t};
    return hit.t > 0 ? hit : Hit{};
  }
  double meet(std::size_t i, Vector from, Vector way, double epsilon) const {
    const Vector c = center(i) - from;
    const double along = c.dot(way), r = radius(i),
                 d = r * r - (c - along * way).dot(c - along * way);
    if (d < 0) return std::numeric_limits<double>::infinity();
    const double half = is(Slip::root_forgotten) ? d : std::sqrt(d);
    const double near = along - half, far = along + half;
    if (near > epsilon && !is(Slip::far_root)) return near;
    return far > epsilon ? far : std::numeric_limits<double>::infinity();
  }

  bool lies_behind(Vector point, Vector l) const {
    for (std::size_t i = 0; i < scene_.spheres.size(); ++i)
      if ((point - center(i)).length() > radius(i) + 1e-3 &&
          meet(i, point, -1.0 * l, 1e-4) < kNowhere)
        return true;
    return false;
  }
  bool lit(Vector point, Vector l, double distance) const {
    if (stage_ < 5) return true;
    bool blocked = false;
    if (is(Slip::shadow_of_first_only))
      blocked = meet(0, point, l, 1e-4) < distance;
    else if (is(Slip::shadow_not_by_glass))
      for (std::size_t i = 0; i < scene_.spheres.size(); ++i)
        blocked = blocked || (scene_.materials[scene_.spheres[i].material].refraction.r == 0 &&
                              meet(i, point, l, 1e-4) < distance);
    else if (is(Slip::shadow_not_of_last))
      for (std::size_t i = 0; i + 1 < scene_.spheres.size(); ++i)
        blocked = blocked || meet(i, point, l, 1e-4) < distance;
    else if (is(Slip::shadow_behind))
      blocked = nearest(point, l).t < distance || lies_behind(point, l);
    else
      blocked = nearest(point, l).t < (is(Slip::shadow_short) ? std::min(1.0, distance) : distance);
    return blocked == is(Slip::shadow_inverted);
  }

  Vector local(const Material& m, Vector point, Vector n, Vector v, double radius_at) const {
    const Vector ia = of(scene_.ambient_light);
    Vector sum = ia * of(is(Slip::ambient_is_diffuse) ? m.diffuse : m.ambient);
    if (is(Slip::no_ambient) && stage_ > 2) sum = {};
    if (is(Slip::ambient_triple)) sum = 3 * sum;
    if (stage_ < 3) return sum;
    for (const auto& light : scene_.lights) {
      const Vector at{light.position.x, light.position.y, light.position.z};
      const Vector way = is(Slip::light_at_eye)      ? Vector{0, 0, 2} - point
                         : is(Slip::light_from_afar) ? at
                                                     : at - point;
      const double distance = way.length();
      const Vector l = way.unit();
      double facing = l.dot(n);
      if (facing < 0 && !is(Slip::diffuse_wrapped)) continue;
      const Vector feeler = is(Slip::shadow_from_center) ? point - radius_at * n : point;
      if (!lit(feeler, l, distance)) {
        if (is(Slip::shadow_of_all)) return 1.0 / 3 * sum;
        continue;
      }
      if (is(Slip::ambient_where_unlit)) sum = {};
      double share = facing;
      if (is(Slip::diffuse_root)) share = std::sqrt(share);
      if (is(Slip::diffuse_linear)) share = 1 - std::acos(std::min(facing, 1.0)) / std::acos(0.0);
      if (is(Slip::diffuse_squared)) share *= share;
      if (is(Slip::diffuse_wrapped)) share = 0.5 * facing + 0.5;
      if (is(Slip::diffuse_by_distance)) share *= 4 / (distance * distance);
      if (is(Slip::diffuse_stepped)) share = std::ceil(4 * share) / 4;
      if (is(Slip::light_twice)) share *= 2;
      Vector kd = of(m.diffuse);
      if (is(Slip::diffuse_blue_and_red)) std::swap(kd.x, kd.z);
      sum = sum + share * (of(light.color) * kd);
      if (stage_ < 4 || facing < 0) continue;
      const Vector to_eye = is(Slip::view_from_origin) ? (-1.0 * point).unit() : v;
      const double r_v = (2 * facing * n - l).dot(to_eye);
      if (r_v < 0) continue;
      double shine = std::pow(r_v, is(Slip::exponent_fixed) ? 120 : m.shininess);
      if (is(Slip::specular_times_facing)) shine *= facing;
      if (is(Slip::specular_third)) shine /= 3;
      if (is(Slip::highlight_stepped)) shine = shine < 0.5 ? 0 : 1;
      Vector ks = of(m.specular);
      if (is(Slip::specular_white)) ks = {1, 1, 1};
      if (is(Slip::specular_squared_color)) ks = ks * ks;
      if (is(Slip::light_twice)) shine *= 2;
      sum = sum + shine * (of(light.color) * ks);
    }
    return sum;
  }

  Vector trace(Vector from, Vector way, int depth) const {
    if (depth > (is(Slip::one_bounce) ? 1 : 4)) return {};
    const Hit hit = is(Slip::farthest_hit) && depth == 0 ? farthest(from, way) : nearest(from, way);
    if (!(hit.t < kNowhere) && is(Slip::missed_are_ambient) && depth > 0)
      return of(scene_.ambient_light);
    if (!(hit.t < kNowhere))
      return is(Slip::background_grey) ? Vector{0.2, 0.2, 0.2} : of(scene_.background);
    if (stage_ == 1) return {1, 1, 1};
    const Material& m = scene_.materials[scene_.spheres[hit.sphere].material];
    const Vector point = from + hit.t * way, v = -1.0 * way;
    Vector n = (point - center(hit.sphere)).unit();
    if (is(Slip::normal_from_origin)) n = point.unit();
    if (is(Slip::normal_z_reversed)) n.z = -n.z;
    const bool inside = v.dot(n) < 0;
    if (inside) n = -1.0 * n;
    Vector own = local(m, point, is(Slip::normal_not_unit) ? radius(hit.sphere) * n : n, v,
                       radius(hit.sphere));
    double k1 = m.reflection.r, k2 = stage_ < 7 ? 0 : m.refraction.r;
    if (stage_ < 6) return clamped(own);
    if (is(Slip::local_shared)) own = (1 - k1 - k2) * own;
    if (is(Slip::local_less_mirror)) own = (1 - k1) * own;
    if (is(Slip::refraction_is_rest) && k2 > 0) k2 = 1 - k1;
    const double cosine = v.dot(n);
    if (is(Slip::reflection_squared)) k1 *= k1;
    if (is(Slip::reflection_schlick) && k1 > 0) k1 += (1 - k1) * std::pow(1 - cosine, 5);
    Vector reflected, refracted;
    if (k1 > 0) {
      Vector u = v;
      if (is(Slip::mirror_from_light)) {
        const Vec3& p = scene_.lights[0].position;
        u = (Vector{p.x, p.y, p.z} - point).unit();
      }
      reflected = k1 * trace(point, (2 * u.dot(n) * n - u).unit(), depth + 1);
      if (is(Slip::reflection_colored)) reflected = of(m.diffuse) * reflected;
    }
    const double ior = is(Slip::one_ior) ? 1 / 1.5 : m.ior;
    const double b = inside ? 1 / ior : ior, d = b * b * cosine * cosine - b * b + 1;
    if (k2 > 0 && d >= 0)
      refracted =
          k2 *
          trace(point,
                ((is(Slip::brackets_forgotten) ? 2 : 1) * b * cosine * n - std::sqrt(d) * n - b * v)
                    .unit(),
                depth + 1);
    Vector sum = own + reflected + refracted;
    if (is(Slip::brightest_counts))
      sum = {std::max({own.x, reflected.x, refracted.x}),
             std::max({own.y, reflected.y, refracted.y}),
             std::max({own.z, reflected.z, refracted.z})};
    if (is(Slip::mean_of_three)) sum = 1.0 / 3 * sum;
    return clamped(sum);
  }

  void finish(Image& image) const {
    float brightest = 0;
    for (const float value : image.pixels) brightest = std::max(brightest, value);
    for (std::size_t i = 0; i + 2 < image.pixels.size(); i += 3) {
      float* p = image.pixels.data() + i;
      if (is(Slip::green_lost)) p[1] = 0;
      if (is(Slip::channels_turned)) std::tie(p[0], p[1], p[2]) = std::tuple(p[1], p[2], p[0]);
      for (int c = 0; c < 3; ++c) {
        if (is(Slip::few_colors)) p[c] = std::floor(8 * p[c]) / 8;
        if (is(Slip::tone_mapped)) p[c] = p[c] / (1 + p[c]);
        if (is(Slip::colors_squared)) p[c] *= p[c];
        if (is(Slip::normalised_by_brightest) && brightest > 0) p[c] /= brightest * 0.8F;
        p[c] = std::floor(std::min(p[c], 1.0F) * 255 + 0.5F) / 255;
      }
    }
  }

  const Scene& scene_;
  int stage_;
  Slip slip_;
};

}  // namespace zraka::outside
