// SPDX-License-Identifier: Apache-2.0
// count_rays SCENE: the rays that the Standard Procedural Databases' rules ask for, counted by
// trying every shape in double, and what others count who differ in a rule (docs/ray-counts.md).
// Shares nothing with the engine but the scene.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <cmath>
#include <limits>
#include <thread>
#include <vector>
#include <zraka/formats.hpp>

#include "formats/vectors.hpp"
#include "rivals/scene_writer.hpp"

namespace {

using namespace zraka;
using namespace zraka::rivals;

struct Words {
  std::string scene;
  double nearest = 1e-7;         ///< hits of later rays that are nearer are not seen
  bool outward_normals = false;  ///< of closed shapes, also where a ray comes from inside
  bool glass_reflects = false;   ///< also where its share of the reflected ray is 0
  bool blocked = false;
  int levels = 5;
};

struct Counts {
  std::uint64_t camera_hits = 0, later = 0, later_hits = 0, shadow_rays = 0, blocked = 0;
};

struct Ray {
  Vec3 origin, direction;
  int level;
};

/// A hit at `distance`, or none. The normal is the shape's own, not yet turned to the viewer.
struct Hit {
  double distance = std::numeric_limits<double>::infinity();
  Vec3 normal;
  std::uint32_t material = 0;
  bool flat = false;
};

/// Whether the shape is hit further than t_min and nearer than the hit, which is then moved there.
bool meet(const Sphere& s, const Ray& ray, double t_min, Hit& hit) {
  const Vec3 from_center = ray.origin - s.center;
  const double b = dot(from_center, ray.direction);
  const double d = b * b - dot(from_center, from_center) + s.radius * s.radius;
  if (d < 0) return false;
  double t = -b - std::sqrt(d);
  if (t <= t_min) t = -b + std::sqrt(d);
  if (t <= t_min || t >= hit.distance) return false;
  hit.distance = t;
  hit.normal = (from_center + ray.direction * t) * (1 / s.radius);
  hit.flat = false;
  return true;
}

/// Möller and Trumbore (1997); `weights` are those of b and c.
bool meet(const Triangle& s, const Ray& ray, double t_min, Hit& hit, double (&weights)[2]) {
  const Vec3 ab = s.b - s.a, ac = s.c - s.a, p = cross(ray.direction, ac);
  const double determinant = dot(ab, p);
  if (determinant == 0) return false;
  const Vec3 from_a = ray.origin - s.a;
  const double u = dot(from_a, p) / determinant;
  if (u < 0 || u > 1) return false;
  const Vec3 q = cross(from_a, ab);
  const double v = dot(ray.direction, q) / determinant, t = dot(ac, q) / determinant;
  if (v < 0 || u + v > 1 || t <= t_min || t >= hit.distance) return false;
  hit.distance = t;
  hit.normal = cross(ab, ac);
  hit.flat = true;
  weights[0] = u;
  weights[1] = v;
  return true;
}

bool meet(const Triangle& s, const Ray& ray, double t_min, Hit& hit) {
  double weights[2];
  return meet(s, ray, t_min, hit, weights);
}

bool meet(const SmoothTriangle& s, const Ray& ray, double t_min, Hit& hit) {
  double w[2];
  if (!meet(Triangle{s.a, s.b, s.c}, ray, t_min, hit, w)) return false;
  hit.normal =
      unit(s.normal_a) * (1 - w[0] - w[1]) + unit(s.normal_b) * w[0] + unit(s.normal_c) * w[1];
  return true;
}

/// The radius at height z over the base is r + slope·z.
bool meet(const Cone& s, const Ray& ray, double t_min, Hit& hit) {
  const double height = length(s.apex - s.base);
  const Vec3 axis = (s.apex - s.base) * (1 / height), from_base = ray.origin - s.base;
  const double slope = (s.apex_radius - s.base_radius) / height;
  const double z = dot(from_base, axis), dz = dot(ray.direction, axis);
  const Vec3 across = from_base - axis * z, d_across = ray.direction - axis * dz;
  const double r = s.base_radius + slope * z;
  const double a = dot(d_across, d_across) - slope * slope * dz * dz;
  const double b = dot(across, d_across) - slope * dz * r, c = dot(across, across) - r * r;
  const double d = b * b - a * c;
  if (d < 0 || a == 0) return false;
  bool met = false;
  for (const double root : {-std::sqrt(d), std::sqrt(d)}) {
    const double t = (-b + root) / a, at = z + dz * t;
    if (t <= t_min || t >= hit.distance || at < 0 || at > height) continue;
    hit.distance = t;
    hit.normal = unit(across + d_across * t) - axis * slope;
    hit.flat = false;
    met = true;
  }
  return met;
}

Hit nearest_hit(const Scene& scene, const Ray& ray, double t_min) {
  Hit hit;
#define ZRAKA_INTERSECT(Type, plural)                \
  for (const auto& [shape, material, transform] : scene.plural) \
    if (meet(shape, ray, t_min, hit)) hit.material = material;
  ZRAKA_PRIMITIVES(ZRAKA_INTERSECT)
#undef ZRAKA_INTERSECT
  return hit;
}

bool is_blocked(const Scene& scene, const Ray& shadow_ray, double t_min, double distance) {
  Hit hit;
  hit.distance = distance;
#define ZRAKA_INTERSECT(Type, plural)     \
  for (const auto& object : scene.plural) \
    if (meet(object.shape, shadow_ray, t_min, hit)) return true;
  ZRAKA_PRIMITIVES(ZRAKA_INTERSECT)
#undef ZRAKA_INTERSECT
  return false;
}

/// Follows a ray from the eye and all that come of it.
void count(const Scene& scene, const Words& words, const Ray& from_eye, std::vector<Ray>& waiting,
           Counts& counts) {
  waiting.assign(1, from_eye);
  while (!waiting.empty()) {
    const Ray ray = waiting.back();
    waiting.pop_back();
    const bool later = ray.level > 1;
    const Hit hit = nearest_hit(scene, ray, later ? words.nearest : 0);
    counts.later += later;
    if (std::isinf(hit.distance)) continue;
    ++(later ? counts.later_hits : counts.camera_hits);

    const Material& material = scene.materials[hit.material];
    const bool glass = material.refraction.most() > 0, two_sided = hit.flat && !glass;
    const Vec3 point = ray.origin + ray.direction * hit.distance, outward = unit(hit.normal);
    const bool inside = dot(outward, ray.direction) > 0 && !two_sided;
    const Vec3 facing = dot(outward, ray.direction) > 0 ? outward * -1 : outward;

    for (const Light& light : scene.lights) {
      const Vec3 way = light.position - point;
      if (dot(words.outward_normals && !two_sided ? outward : facing, way) <= 0) continue;
      ++counts.shadow_rays;
      if (words.blocked)
        counts.blocked += is_blocked(scene, {point, unit(way), 0}, words.nearest, length(way));
    }
    if (ray.level == words.levels) continue;

    const double cosine = -dot(facing, ray.direction);
    if (material.reflection.most() > 0 || (glass && words.glass_reflects))
      waiting.push_back({point, unit(ray.direction + facing * (2 * cosine)), ray.level + 1});
    const double ratio = inside ? material.ior : 1 / material.ior;
    const double square = 1 - ratio * ratio * (1 - cosine * cosine);
    if (glass && square >= 0)
      waiting.push_back(
          {point, unit(ray.direction * ratio + facing * (ratio * cosine - std::sqrt(square))),
           ray.level + 1});
  }
}

/// Rays from the eye go through the corners of pixels.
Counts count(const Scene& scene, const Words& words) {
  std::atomic<std::uint32_t> next_row = 0;
  std::vector<Counts> parts(std::max(1u, std::thread::hardware_concurrency()));
  std::vector<std::thread> threads;
  for (Counts& part : parts)
    threads.emplace_back([&] {
      const auto [width, height] = scene.resolution;
      const Camera& camera = scene.camera;
      std::vector<Ray> waiting;
      Counts counts;
      for (std::uint32_t y; (y = next_row++) <= height;)
        for (std::uint32_t x = 0; x <= width; ++x) {
          const Vec3 through = camera.window_center +
                               camera.window_right * (static_cast<double>(x) / width - 0.5) +
                               camera.window_up * (0.5 - static_cast<double>(y) / height);
          count(scene, words, {camera.eye, unit(through - camera.eye), 1}, waiting, counts);
        }
      part = counts;
    });
  for (std::thread& thread : threads) thread.join();
  Counts sum;
  for (const Counts& part : parts) {
    sum.camera_hits += part.camera_hits;
    sum.later += part.later;
    sum.later_hits += part.later_hits;
    sum.shadow_rays += part.shadow_rays;
    sum.blocked += part.blocked;
  }
  return sum;
}

}  // namespace

int main(int argc, char** argv) {
  Words words;
  CLI::App app("Counts a scene's rays by the databases' rules, trying every shape in double.");
  app.add_option("scene", words.scene, "a scene file")->required();
  app.add_option("--nearest", words.nearest, "later rays do not see hits that are nearer")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app.add_option("--levels", words.levels, "levels of rays, of which the eye's are the first")
      ->check(CLI::Range(1, 200))
      ->capture_default_str();
  app.add_flag("--outward-normals", words.outward_normals,
               "normals of closed shapes look outward, also for rays inside");
  app.add_flag("--glass-reflects", words.glass_reflects,
               "a reflected ray from all glass, also where its share is 0");
  app.add_flag("--blocked", words.blocked, "trace the shadow rays, too, and count those that hit");
  CLI11_PARSE(app, argc, argv);
  const auto read = read_scene(words.scene);
  if (!read) {
    for (const Diagnostic& problem : read.error()) fmt::print(stderr, "{}", to_string(problem));
    return 1;
  }
  const Counts counts = count(read->scene, words);
  fmt::print("rays from the eye that hit  {}\nlater rays                  {}\n", counts.camera_hits,
             counts.later);
  fmt::print("later rays that hit         {}\nshadow rays                 {}\n", counts.later_hits,
             counts.shadow_rays);
  if (words.blocked) fmt::print("shadow rays that hit        {}\n", counts.blocked);
}
