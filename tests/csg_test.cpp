// SPDX-License-Identifier: Apache-2.0
// CSG against membership of points: where a ray goes in and comes out is where points before and
// behind are not both inside, and nowhere before.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <optional>
#include <random>

#include "accel/body_surface.hpp"
#include "probed_scenes.hpp"
#include "truth/bodies.hpp"

namespace zraka {
namespace {

using truth::Point;
using truth::Random;
using truth::Real;
using Inside = std::function<bool(const Point&)>;

double between(double low, double high, Random& random) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

/// A turn and a move, whose way back is its transpose.
Transform random_motion(Random& random) {
  const Vec3 a = truth::on_unit_sphere(random), b = truth::on_unit_sphere(random);
  const Point x = truth::unit(truth::exact(a));
  const Point y = truth::unit(truth::cross(x, truth::exact(b))), z = truth::cross(x, y);
  const auto plain = [](const Point& p) {
    return Vec3{static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
  };
  return {plain(x), plain(y), plain(z), truth::in_cube(random)};
}
Point back(const Point& p, const Transform& t) {
  const Point from = p - truth::exact(t.origin);
  return {truth::dot(from, truth::exact(t.along_x)), truth::dot(from, truth::exact(t.along_y)),
          truth::dot(from, truth::exact(t.along_z))};
}

/// Trees of members, and what they hold.
class Grower {
 public:
  Grower(Scene& scene, unsigned seed) : scene_(scene), random_(seed) {}

  Inside grow(Csg& csg, int levels) {
    csg.operation = static_cast<CsgOperation>(random_() % 3);
    std::vector<Inside> of;
    const unsigned count = 2 + random_() % 2;
    for (unsigned i = 0; i < count; ++i) {
      CsgMember& member = csg.of.emplace_back();
      scene_.transforms.push_back(random_motion(random_));
      member.transform = static_cast<std::uint32_t>(scene_.transforms.size());
      const Transform motion = scene_.transforms.back();
      const Inside own = member_of(member, levels);
      of.push_back([own, motion](const Point& p) { return own(back(p, motion)); });
    }
    const CsgOperation operation = csg.operation;
    return [of, operation](const Point& p) {
      bool all = of[0](p);
      for (std::size_t i = 1; i < of.size(); ++i)
        all = operation == CsgOperation::unite       ? all || of[i](p)
              : operation == CsgOperation::intersect ? all && of[i](p)
                                                     : all && !of[i](p);
      return all;
    };
  }

 private:
  Inside member_of(CsgMember& member, int levels) {
    if (levels > 1) {
      Csg inner;
      const Inside inside = grow(inner, levels - 1);
      member.body = inner;
      return inside;
    }
    const auto size = [&] { return between(0.4, 1.2, random_); };
    switch (random_() % 5) {
      case 0:
        return take(member, Ellipsoid{{}, {size(), size(), size()}});
      case 1:
        return take(member, Box{{-size(), -size(), -size()}, {size(), size(), size()}, 0});
      case 2:
        return take(member, Torus{{}, {0.2, 1, 0.1}, size(), 0.3});
      case 3:
        return take(member, Frustum{{0, -size(), 0}, size(), {0, size(), 0}, 0.3, true});
      default:
        return take(member, Plane{{0, between(-0.5, 0.5, random_), 0}, {0.1, 1, 0.3}});
    }
  }
  template <class Shape>
  static Inside take(CsgMember& member, const Shape& shape) {
    member.body = shape;
    const auto held = std::make_shared<truth::Truth<Shape>>(shape);
    return [held](const Point& p) { return held->residual(p) < 0; };
  }

  Scene& scene_;
  Random random_;
};

struct Grown {
  Scene scene;
  Inside inside;

  Grown(int levels, unsigned seed) {
    scene.materials = {{}};
    scene.camera.eye = {0, 0, 6};
    Csg csg;
    inside = Grower(scene, seed).grow(csg, levels);
    scene.csgs.push_back({csg, 0});
    // Something with bounds to be the frame's middle, out of the way of all rays.
    scene.spheres.push_back({{{0, 0, -40}, 0.1}, 0});
  }
};

TEST(Csg, IsHitWherePointsBeforeAndBehindAreNotBothInside) {
  std::size_t hits = 0, rays_asked = 0, thin = 0;
  for (unsigned seed = 1; seed <= 24; ++seed) {
    const Grown grown(3, seed);
    ASSERT_TRUE(check(grown.scene).empty()) << check(grown.scene).front().message;
    const Frozen frozen(grown.scene);
    Random random(seed);
    std::vector<ProbeRay> rays;
    for (std::size_t i = 0; i < ray_count(60); ++i) {
      const Vec3 from = truth::in_cube(random), way = truth::on_unit_sphere(random);
      const Vec3 at = frozen.frame.point({2 * from.x, 2 * from.y, 2 * from.z});
      const auto narrow = [](double v) { return static_cast<double>(static_cast<float>(v)); };
      rays.push_back({{narrow(at.x), narrow(at.y), narrow(at.z)},
                      {narrow(way.x), narrow(way.y), narrow(way.z)},
                      1e20});
    }
    std::vector<ProbeSurface> first;
    for (const LanesProbe& probe : lanes_probes()) {
      std::vector<ProbeSurface> found(rays.size());
      probe.surfaces(&frozen.floats->scene, &frozen.doubles->scene, rays.data(), found.data(),
                     rays.size());
      if (probe.isa == Isa::oracle) continue;
      if (first.empty()) first = found;
      for (std::size_t i = 0; i < rays.size(); ++i) {
        ASSERT_EQ(found[i].id, first[i].id) << "ray " << i << " by " << name_of(probe.isa);
        ASSERT_EQ(found[i].t, first[i].t) << "ray " << i << " by " << name_of(probe.isa);
      }
    }
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const Vec3 o =
          frozen.frame.world_point({rays[i].origin[0], rays[i].origin[1], rays[i].origin[2]});
      const Point origin = truth::exact(o), way = truth::exact(rays[i].direction);
      const auto inside = [&](Real t) { return grown.inside(origin + way * t); };
      const bool hit = first[i].id == 1, began = inside(0);
      const Real end = hit ? Real{first[i].t} / frozen.frame.scale : 8;
      constexpr Real kClose = 4e-6L;
      ++rays_asked;
      for (int k = 1; k < 800; ++k) {
        const Real t = end * k / 800;
        if (t > end - kClose || t < kClose) continue;
        ASSERT_EQ(inside(t), began)
            << "seed " << seed << ", ray " << i << " at " << double(t) << " before " << double(end);
      }
      if (!hit) continue;
      ++hits;
      // What is thinner than this cannot be seen on both sides of it.
      if (inside(end + kClose) == began) ++thin;
    }
  }
  EXPECT_GT(hits, rays_asked / 10);
  EXPECT_LE(thin, hits / 200);
}

/// A CSG body of few members, scaled and moved, among what makes the frame larger than it.
struct Placed {
  Scene scene;
  Inside inside;
  double size, shift;

  Placed(unsigned seed, double its_size, double its_shift, double far)
      : size(its_size), shift(its_shift) {
    scene.materials = {{}};
    Csg csg;
    inside = Grower(scene, seed).grow(csg, 1 + seed % 2);
    scene.transforms.push_back({{size, 0, 0}, {0, size, 0}, {0, 0, size}, {shift, 0, -shift}});
    scene.csgs.push_back({csg, 0, static_cast<std::uint32_t>(scene.transforms.size())});
    scene.spheres.push_back({{{shift, 0, -shift - far * size}, 0.1 * size}, 0});
    scene.camera.eye = {shift, 0, 6 * size - shift};
  }
  /// Whether a place of the frame is inside; nothing where that is not certain.
  std::optional<bool> holds(const Frame& frame, const double (&place)[3]) const {
    const Vec3 p = frame.world_point({place[0], place[1], place[2]});
    const Point own{(Real{p.x} - Real{shift}) / Real{size}, Real{p.y} / Real{size},
                    (Real{p.z} + Real{shift}) / Real{size}};
    const bool here = inside(own);
    const Real apart = 1e-8L + 1e-15L * Real{shift} / Real{size};
    for (const Point& way : {Point{1, 0, 0}, Point{0, 1, 0}, Point{0, 0, 1}})
      if (inside(own + way * apart) != here || inside(own - way * apart) != here) return {};
    return here;
  }
};

/// By all crossings with all members: where a ray first crosses the whole's surface, -1 for never.
float first_change(const FrozenBodies& bodies, std::int32_t body, const ProbeRay& ray, bool began) {
  CsgCrossing all[kMostCsgCrossings];
  const int count = isa_oracle::csg_crossings(
      bodies, body, {ray.origin[0], ray.origin[1], ray.origin[2]},
      {ray.direction[0], ray.direction[1], ray.direction[2]}, all, kMostCsgCrossings);
  for (int k = 0; k < count; ++k)
    if (all[k].whole != began) return static_cast<float>(all[k].t);
  return -1;
}

ProbeRay narrowed(const Point& origin, const Point& direction) {
  const auto narrow = [](Real v) { return static_cast<double>(static_cast<float>(v)); };
  return {{narrow(origin.x), narrow(origin.y), narrow(origin.z)},
          {narrow(direction.x), narrow(direction.y), narrow(direction.z)},
          1e20};
}
/// From everywhere; and where `found` are the hits of such rays, from beside these and along the
/// surface there.
std::vector<ProbeRay> rays_at(const Frame& frame, const Placed& placed,
                              const std::vector<ProbeSurface>& found, Random& random) {
  std::vector<ProbeRay> rays;
  for (std::size_t i = 0; i < ray_count(160); ++i) {
    const Vec3 from = truth::in_cube(random);
    const double reach = 2 * placed.size;
    const Vec3 at = frame.point({placed.shift + reach * from.x, reach * from.y,
                                 reach * from.z - placed.shift});
    rays.push_back(narrowed(truth::exact(at), truth::exact(truth::on_unit_sphere(random))));
  }
  for (const ProbeSurface& hit : found) {
    if (hit.id != 1) continue;
    const Point at = truth::exact(hit.point), up = truth::exact(hit.normal);
    const Point any = truth::exact(truth::on_unit_sphere(random));
    const Point side = truth::unit(truth::cross(up, any));
    const Real off = Real{hit.offset} * (hit.inside ? -1 : 1);
    rays.push_back(narrowed(at + up * off, any));
    const Real away = Real{placed.size} * Real{frame.scale} * Real{between(0, 2, random)};
    rays.push_back(narrowed(at + up * off * Real{between(-3, 3, random)} - side * away, side));
  }
  return rays;
}

TEST(Csg, IsHitWhereAllItsCrossingsSayWhateverIsSpared) {
  std::size_t hits = 0, asked = 0, doubtful = 0;
  for (unsigned seed = 1; seed <= 120; ++seed) {
    const double size = seed % 3 == 0 ? 1 : seed % 3 == 1 ? 1e-6 : 1e6;
    const Placed placed(seed, size, seed % 4 == 3 ? 1e6 * size : 0, seed % 5 == 4 ? 1e5 : 5);
    const Frozen frozen(placed.scene);
    const FrozenBodies& bodies = frozen.floats->scene.bodies;
    Random random(seed);
    std::vector<ProbeSurface> before;
    for (int round = 0; round < 2; ++round) {
      const std::vector<ProbeRay> rays = rays_at(frozen.frame, placed, before, random);
      for (const LanesProbe& probe : lanes_probes()) {
        if (probe.isa == Isa::oracle) continue;
        std::vector<ProbeSurface> found(rays.size());
        probe.surfaces(&frozen.floats->scene, &frozen.doubles->scene, rays.data(), found.data(),
                       rays.size());
        for (std::size_t i = 0; i < rays.size(); ++i) {
          const auto began = placed.holds(frozen.frame, rays[i].origin);
          ++asked;
          if (!began) ++doubtful;
          if (!began || found[i].id == 0) continue;
          const float t = first_change(bodies, 0, rays[i], *began);
          ASSERT_EQ(found[i].id == 1, t > 0) << "seed " << seed << ", ray " << i << " at " << t
                                             << " by " << name_of(probe.isa);
          if (!(t > 0)) continue;
          ++hits;
          ASSERT_EQ(static_cast<float>(found[i].t), t)
              << "seed " << seed << ", ray " << i << " by " << name_of(probe.isa);
          ASSERT_EQ(found[i].inside, *began) << "seed " << seed << ", ray " << i;
        }
        before = found;
      }
    }
  }
  EXPECT_GT(hits, asked / 6);
  EXPECT_LT(doubtful, asked / 10);
}

}  // namespace
}  // namespace zraka
