// SPDX-License-Identifier: Apache-2.0
// A crowd of shapes of one kind and rays through it, for the engine to trace and the truth to
// judge.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "probed_scenes.hpp"
#include "truth/shapes.hpp"

namespace zraka::truth {

#define ZRAKA_ADD(Type, plural)                      \
  inline void add(Scene& scene, const Type& shape) { \
    scene.plural.push_back({shape, 0});              \
  }
ZRAKA_SHAPES(ZRAKA_ADD)
#undef ZRAKA_ADD

/// How many shapes of this kind the engine has made of a scene's.
template <class Kind>
std::int32_t count_of(const FrozenScene<float>& scene) {
#define ZRAKA_IF(Type, plural) \
  if constexpr (std::is_same_v<Kind, Type>) return scene.plural.count;
  ZRAKA_INLINED_KINDS(ZRAKA_IF)
#undef ZRAKA_IF
}

enum class Numbers { floats, doubles };

template <class Kind>
class Crowd {
 public:
  using Shape = decltype(Truth<Kind>::random(std::declval<Random&>(), Place{}));
  static constexpr int kShapes = 12;

  Crowd(const Place& where, unsigned seed) : place(where), random_(seed) {
    Scene scene;
    scene.materials = {{}};
    for (int i = 0; i < kShapes; ++i) {
      shapes.push_back(Truth<Kind>::random(random_, place));
      truths.emplace_back(shapes.back());
      add(scene, shapes.back());
    }
    const Vec3 from = on_unit_sphere(random_);
    scene.camera.eye = place.point({20 * from.x, 20 * from.y, 20 * from.z});
    scene.camera.window_center = place.origin;
    const Vec3 right{from.y - from.z, from.z - from.x, from.x - from.y};
    const auto wide = [&](double x) { return place.length(6 * x); };
    scene.camera.window_right = {wide(right.x), wide(right.y), wide(right.z)};
    scene.camera.window_up = {wide(from.y * right.z - from.z * right.y),
                              wide(from.z * right.x - from.x * right.z),
                              wide(from.x * right.y - from.y * right.x)};
    frozen_ = std::make_unique<Frozen>(scene);
    listed_ = freeze<float>(scene, profile_of(ProfileName::physical), frame());
    boxes.resize(kShapes);
    refer_to(listed_->scene, boxes.data());
    reorder_by_leaf(*listed_, {});
    const auto rays = static_cast<int>(ray_count(400));
    for (int i = 0; i < rays; ++i) rays_.push_back(random_ray(i, frame().point(scene.camera.eye)));
  }

  const Truth<Kind>& truth_of(const ProbeSurface& found) const {
    return truths[static_cast<std::size_t>(found.id)];
  }
  std::int32_t count() const { return count_of<Kind>(listed_->scene); }
  const Frame& frame() const { return frozen_->frame; }

  /// Rays from within the crowd and, each fourth, from the eye; directions are unit vectors as far
  /// as these numbers can say.
  std::vector<ProbeRay> rays(Numbers numbers) const {
    std::vector<ProbeRay> rays = rays_;
    for (ProbeRay& ray : rays) set_direction(ray, numbers, ray.direction);
    return rays;
  }

  /// What the rays meet. In floats every instruction set has to give the same bits, through the
  /// hierarchy and past the shapes one by one.
  std::vector<ProbeSurface> trace(const std::vector<ProbeRay>& rays, Numbers numbers) const {
    std::vector<ProbeSurface> first, found(rays.size());
    const FrozenScene<double>& doubles = frozen_->doubles->scene;
    for (const LanesProbe& probe : lanes_probes()) {
      if ((probe.isa == Isa::oracle) != (numbers == Numbers::doubles)) continue;
      for (const FrozenScene<float>* floats : {&frozen_->floats->scene, &listed_->scene}) {
        probe.surfaces(floats, &doubles, rays.data(), found.data(), rays.size());
        if (first.empty()) first = found;
        for (std::size_t i = 0; i < rays.size(); ++i)
          EXPECT_TRUE(same(found[i], first[i])) << "ray " << i << " by " << name_of(probe.isa);
      }
    }
    return first;
  }

  /// From the engine's frame to the world.
  Point world(const double (&p)[3]) const {
    return Point{p[0], p[1], p[2]} * (1 / Real{frame().scale}) + exact(frame().center);
  }
  Real world(Real length) const { return length / frame().scale; }
  Ray world(const ProbeRay& ray) const {
    return {world(ray.origin), {ray.direction[0], ray.direction[1], ray.direction[2]}};
  }

  /// Where a ray ends, in the world: at what it meets, or behind everything that is near.
  Real end(const Ray& ray, const ProbeSurface& found) const {
    if (found.id >= 0) return world(Real{found.t});
    return length(ray.origin - exact(place.origin)) + place.length(4);
  }

  /// How far off its surface a hit of the ray may be, in the world. In floats this is twice
  /// hit_margin(): of 100 000 rays one that grazes a sphere comes to 1.2 of it.
  Real error(const ProbeRay& ray, Numbers numbers) const {
    const auto largest = [](double x, double y, double z) {
      return std::max({std::fabs(x), std::fabs(y), std::fabs(z)});
    };
    const Real reach = 1 + largest(ray.origin[0], ray.origin[1], ray.origin[2]);
    if (numbers == Numbers::floats) return world(0x1p-21L * reach);
    return world(0x1p-49L * reach) + rounding();
  }
  /// The offset that a surface promises, in the world.
  Real offset(const ProbeSurface& found, Numbers numbers) const {
    return world(Real{found.offset}) + (numbers == Numbers::doubles ? rounding() : 0);
  }
  /// What is lost of numbers in double on the way from the world into the engine's frame.
  Real rounding() const {
    const Vec3& c = frame().center;
    return 0x1p-51L * (std::max({std::fabs(c.x), std::fabs(c.y), std::fabs(c.z)}) + world(1));
  }

  /// A ray that starts where the engine lets it: at the offset along the normal, or against it.
  static ProbeRay leave(const ProbeSurface& from, Real side, const Vec3& way, Numbers numbers) {
    ProbeRay ray{{}, {}, 1e20};
    for (int k = 0; k < 3; ++k) {
      const double at = from.point[k] + static_cast<double>(side) * from.normal[k] * from.offset;
      ray.origin[k] = numbers == Numbers::floats ? narrow(at) : at;
    }
    const double direction[] = {way.x, way.y, way.z};
    set_direction(ray, numbers, direction);
    return ray;
  }

  static void set_direction(ProbeRay& ray, Numbers numbers, const double* way) {
    const double length = std::sqrt(way[0] * way[0] + way[1] * way[1] + way[2] * way[2]);
    for (int k = 0; k < 3; ++k) {
      const double d = way[k] / length;
      ray.direction[k] = numbers == Numbers::floats ? narrow(d) : d;
    }
  }

  const Place place;
  std::vector<Shape> shapes;
  std::vector<Truth<Kind>> truths;
  std::vector<BuildRef> boxes;  ///< that the hierarchy is built of

 private:
  static double narrow(double v) { return static_cast<double>(static_cast<float>(v)); }

  ProbeRay random_ray(int i, const Vec3& eye) {
    const Vec3 from = in_cube(random_), to = in_cube(random_);
    const Vec3 origin =
        i % 4 == 0 ? eye : frame().point(place.point({2 * from.x, 2 * from.y, 2 * from.z}));
    const Vec3 target = frame().point(place.point(to));
    ProbeRay ray{{narrow(origin.x), narrow(origin.y), narrow(origin.z)}, {}, 1e20};
    const double way[] = {target.x - origin.x, target.y - origin.y, target.z - origin.z};
    const double along_axis[] = {i % 3 == 0 ? 1.0 : 0, i % 3 == 1 ? -1.0 : 0, i % 3 == 2 ? 1.0 : 0};
    set_direction(ray, Numbers::floats, i % 16 == 1 ? along_axis : way);
    return ray;
  }
  static bool same(const ProbeSurface& a, const ProbeSurface& b) {
    if (a.id != b.id || a.t != b.t) return false;
    if (a.id < 0) return true;
    for (int k = 0; k < 3; ++k)
      if (a.point[k] != b.point[k] || a.normal[k] != b.normal[k]) return false;
    return a.offset == b.offset && a.inside == b.inside;
  }

  Random random_;
  std::unique_ptr<Frozen> frozen_;
  std::unique_ptr<FrozenStore<float>> listed_;  ///< without a hierarchy
  std::vector<ProbeRay> rays_;
};

}  // namespace zraka::truth
