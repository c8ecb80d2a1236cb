// SPDX-License-Identifier: Apache-2.0
// Explanations of bodies, CSG, instances and textures: folded to the picture's bits, and what they
// say of where on what a hit is, found again by other means.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>

#include "explain/json.hpp"
#include "explain/text.hpp"
#include "fold.hpp"
#include "shape_scenes.hpp"

namespace zraka {
namespace {

using nlohmann::json;

constexpr ProfileName kProfiles[] = {ProfileName::lab, ProfileName::physical, ProfileName::spd};
/// Of columns and rows, every so many are looked at.
constexpr std::uint32_t kStep = 3;
#if defined(ZRAKA_SANITIZED)
constexpr std::uint32_t kStepOfFold = 23;
#else
constexpr std::uint32_t kStepOfFold = 3;
#endif

RenderOptions with(ProfileName profile, Stage stage = Stage::refraction) {
  return {.terms = terms_of(stage), .profile = profile_of(profile)};
}

bool same_bits(const Float3& a, const float* b) {
  for (std::size_t c = 0; c < 3; ++c)
    if (std::bit_cast<std::uint32_t>(a[c]) != std::bit_cast<std::uint32_t>(b[c])) return false;
  return true;
}

/// Calls function(explanation) for pixels all over a picture.
template <class Function>
void each_explanation(const Scene& scene, const RenderOptions& options, std::uint32_t step,
                      const Function& function) {
  Explainer explainer = Explainer::create(scene, options).value();
  for (std::uint32_t y = 1; y < scene.resolution.height; y += step)
    for (std::uint32_t x = 1; x < scene.resolution.width; x += step)
      function(explainer.pixel(x, y).value());
}
template <class Function>
void each_ray_that_hits(const Scene& scene, const Function& function) {
  each_explanation(scene, with(ProfileName::physical), kStep, [&](const Explanation& e) {
    for (const ExplainedRay& ray : e.trees[0].rays)
      if (ray.hit) function(ray, *ray.hit);
  });
}

TEST(ExplainShapes, FoldToThePicturesBits) {
  for (const NamedScene& named : shape_scenes())
    for (const ProfileName profile : kProfiles) {
      const RenderOptions options = with(profile);
      const Image image = render(named.scene, options).value().image;
      each_explanation(named.scene, options, kStepOfFold, [&](const Explanation& e) {
        const json read = json::parse(to_json(e, "scene", "profile", "words"));
        ASSERT_TRUE(same_bits(Fold{read}.color(), image.row(e.y) + 3 * e.x))
            << named.name << " (" << e.x << ", " << e.y << "), " << name_of(profile);
      });
    }
}

double distance(const Vec3& a, const Vec3& b) {
  return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}
Vec3 moved(const Vec3& p, const Transform& t) {
  return {t.origin.x + p.x * t.along_x.x + p.y * t.along_y.x + p.z * t.along_z.x,
          t.origin.y + p.x * t.along_x.y + p.y * t.along_y.y + p.z * t.along_z.y,
          t.origin.z + p.x * t.along_x.z + p.y * t.along_y.z + p.z * t.along_z.z};
}

TEST(ExplainShapes, KnowTheirOwnSpace) {
  std::size_t seen = 0, in_groups = 0, of_members = 0;
  for (const NamedScene& named : shape_scenes())
    each_ray_that_hits(named.scene, [&](const ExplainedRay&, const ExplainedHit& hit) {
      if (!hit.transform) return;
      ++seen;
      in_groups += hit.path.instances.size() == 2;
      ASSERT_TRUE(hit.own);
      of_members += hit.own->uv && hit.path.member && hit.path.member->transform != Transform();
      EXPECT_LT(distance(moved(hit.own->point, *hit.transform), hit.point), 2e-6) << named.name;
    });
  EXPECT_GT(seen, 500u);
  EXPECT_GT(in_groups, 100u);
  EXPECT_GT(of_members, 20u) << "where textures move with a member";
}

TEST(ExplainShapes, LieOnWhatTheirPathNames) {
  // The equation of the shape at the end of the path, in the space that the hit is said to be in.
  const Scene scene = chairs_scene();
  std::size_t shanks = 0, feet = 0, seats = 0, drilled = 0;
  each_ray_that_hits(scene, [&](const ExplainedRay&, const ExplainedHit& hit) {
    if (!hit.path.inner) {
      EXPECT_EQ(hit.shape.id, (ShapeId{0, 0}));
      EXPECT_TRUE(hit.path.instances.empty());
      return;
    }
    ASSERT_FALSE(hit.path.instances.empty());
    EXPECT_EQ(hit.path.instances[0].shape.id, hit.shape.id);
    EXPECT_EQ(hit.path.instances[0].group_name, "chair");
    EXPECT_EQ(hit.shape.name, hit.shape.id.index == 0 ? "left" : "");
    const Vec3& p = hit.own->point;
    const std::string& name = hit.path.inner->name;
    if (name == "shank") {
      ++shanks;
      EXPECT_NEAR(std::hypot(p.x / 0.1, (p.y + 0.3) / 0.3, p.z / 0.1), 1, 1e-5);
    } else if (name == "foot") {
      ++feet;
      // A primitive is in the space of its group.
      EXPECT_NEAR(distance(p, {0, -0.65, 0}), 0.12, 1e-6);
    } else if (name == "seat") {
      ++seats;
      EXPECT_EQ(hit.path.instances.size(), 1u);
      const double off =
          std::max({std::fabs(p.x) - 0.4, std::fabs(p.z) - 0.4, std::fabs(p.y - 0.05) - 0.05});
      EXPECT_NEAR(off, 0, 1e-6);
    } else {
      ++drilled;
      EXPECT_TRUE(hit.path.member);
    }
    if (name == "shank" || name == "foot") {
      ASSERT_EQ(hit.path.instances.size(), 2u);
      EXPECT_EQ(hit.path.instances[1].group_name, "leg");
      EXPECT_EQ(hit.path.instances[1].shape.name,
                hit.path.instances[1].shape.id.index == 1 ? "right leg" : "");
    }
  });
  for (const std::size_t count : {shanks, feet, seats, drilled}) EXPECT_GT(count, 20u);
}

/// How far a point of drilled()'s own space is off a member's surface; below 0 within.
double residual(const std::string& name, const Vec3& p) {
  if (name == "block") return std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}) - 0.5;
  if (name == "ball") return std::hypot(p.x, p.y, p.z) - 0.65;
  return std::hypot(p.x / 0.3, p.y / 0.3, p.z / 2) - 1;
}
bool in_drilled(const Vec3& p) {
  return residual("block", p) < 0 && residual("ball", p) < 0 && residual("bore", p) > 0;
}

TEST(ExplainShapes, NameTheMemberThatIsHitAndTheCrossingsBefore) {
  std::size_t seen = 0, from_inside = 0, several = 0;
  std::map<std::string, std::size_t> members;
  for (const Scene& scene : {csg_scene(), chairs_scene(), crowded_scene()})
    each_ray_that_hits(scene, [&](const ExplainedRay& ray, const ExplainedHit& hit) {
      ASSERT_EQ(hit.path.member.has_value(), hit.crossings.has_value());
      if (!hit.path.member || hit.path.member->name.empty()) return;
      ++seen;
      ++members[hit.path.member->name];
      EXPECT_NEAR(residual(hit.path.member->name, hit.own->point), 0, 2e-5);
      const ExplainedCrossings& way = *hit.crossings;
      ASSERT_FALSE(way.all.empty());
      EXPECT_EQ(way.left_out, 0u);
      EXPECT_NEAR(way.all.back().distance, hit.distance, 1e-5 * hit.distance + 2e-6);
      EXPECT_NE(way.all.back().inside, way.starts_inside);
      from_inside += way.starts_inside;
      several += way.all.size() > 1;
      // Between one crossing and the next the whole is what its definition says.
      for (std::size_t i = 0; i < way.all.size(); ++i) {
        const ExplainedCrossing& crossing = way.all[i];
        const double next =
            i + 1 < way.all.size() ? way.all[i + 1].distance : crossing.distance + 4e-5;
        const auto at = [&](double t) {
          const Vec3 world{ray.origin.x + t * static_cast<double>(ray.direction[0]),
                           ray.origin.y + t * static_cast<double>(ray.direction[1]),
                           ray.origin.z + t * static_cast<double>(ray.direction[2])};
          // Own = world by the inverse of a scaled rotation.
          const Transform& m = *hit.transform;
          const double scale = m.along_y.y;
          const Vec3 d{world.x - m.origin.x, world.y - m.origin.y, world.z - m.origin.z};
          const auto along = [&](const Vec3& v) {
            return (v.x * d.x + v.y * d.y + v.z * d.z) / (scale * scale);
          };
          return Vec3{along(m.along_x), along(m.along_y), along(m.along_z)};
        };
        EXPECT_NEAR(residual(way.members[crossing.member].name, at(crossing.distance)), 0, 1e-4);
        if (next - crossing.distance < 2e-5) continue;
        EXPECT_EQ(in_drilled(at((crossing.distance + next) / 2)), crossing.inside);
        EXPECT_EQ(
            residual(way.members[crossing.member].name, at((crossing.distance + next) / 2)) < 0,
            crossing.enters);
      }
    });
  EXPECT_GT(seen, 300u);
  EXPECT_GT(from_inside, 50u);
  EXPECT_GT(several, 100u);
  for (const char* name : {"block", "ball", "bore"}) EXPECT_GT(members[name], 20u) << name;
}

TEST(ExplainShapes, CountMembersLikeTheirExpression) {
  std::set<std::string> positions;
  each_ray_that_hits(csg_scene(), [&](const ExplainedRay&, const ExplainedHit& hit) {
    if (!hit.path.member) return;
    std::string position;
    for (const std::uint32_t i : hit.path.member->position) position += std::to_string(i) + ".";
    positions.insert(position + hit.path.member->name + std::to_string(hit.path.member->operands));
  });
  EXPECT_EQ(positions, (std::set<std::string>{"1.1.block2", "1.2.ball2", "2.bore2", "1.2", "2.2"}));
}

TEST(ExplainShapes, TellWhatTexturesGave) {
  const Scene scene = textured_scene();
  std::size_t floor = 0, globe = 0, bumpy = 0, bent = 0, dented = 0, bare = 0, mirrored = 0;
  each_ray_that_hits(scene, [&](const ExplainedRay& ray, const ExplainedHit& hit) {
    if (hit.textures.empty()) {
      bare += !hit.bent;
      if (hit.bent) {
        ++bumpy;
        EXPECT_EQ(hit.bent->kind, NormalUse::Kind::bump);
        EXPECT_EQ(hit.bent->texture.kind, TextureKind::noise);
        // The sphere's own normal.
        const Vec3 c{0.5, -0.2, -1.2};
        EXPECT_NEAR(static_cast<double>(hit.bent->smooth[0]), (hit.point.x - c.x) / 0.5, 1e-5);
        EXPECT_NEAR(static_cast<double>(hit.bent->smooth[1]), (hit.point.y - c.y) / 0.5, 1e-5);
        bent += hit.bent->smooth != hit.normal;
      }
      return;
    }
    ASSERT_TRUE(hit.own && hit.own->uv && hit.own->footprint);
    EXPECT_GT(*hit.own->footprint, 0);
    mirrored += ray.depth > 0;
    const ExplainedTexture& texture = hit.textures[0].texture;
    if (texture.name == "tiles") {
      ++floor;
      EXPECT_EQ(hit.textures.size(), 2u);
      EXPECT_EQ(hit.textures[0].value, hit.ka);
      EXPECT_EQ(hit.textures[1].value, hit.kd);
      // Sharp where the footprint is far from the borders of its cell.
      const auto cell = [](double v) { return std::floor(v / 0.5); };
      const auto clear = [&](double v) {
        return std::fabs(v / 0.5 - std::round(v / 0.5)) * 0.5 > 8 * *hit.own->footprint;
      };
      const Vec3& p = hit.own->point;
      if (!clear(p.x) || !clear(p.z)) return;
      const bool first = std::fmod(cell(p.x) + cell(p.z) + cell(-0.8), 2) == 0;
      EXPECT_EQ(hit.kd, (first ? Float3{0.9f, 0.8f, 0.7f} : Float3{0.1f, 0.2f, 0.3f}))
          << p.x << " " << p.z;
    } else if (texture.name == "wrapped") {
      ++globe;
      // Longitude and latitude of the unit sphere.
      const Vec3 q{hit.own->point.x / 0.5, hit.own->point.y / 0.4, hit.own->point.z / 0.4};
      constexpr double kPi = 3.14159265358979323846;
      EXPECT_NEAR((*hit.own->uv)[0], 0.5 + std::atan2(q.x, q.z) / (2 * kPi), 1e-4);
      EXPECT_NEAR((*hit.own->uv)[1], 0.5 + std::asin(q.y) / kPi, 1e-4);
      EXPECT_EQ(hit.textures[0].coefficient, Coefficient::diffuse);
      EXPECT_EQ(hit.textures[1].coefficient, Coefficient::reflection);
      EXPECT_EQ(hit.textures[1].value[0], hit.k1);
    } else {
      ++dented;
      EXPECT_EQ(hit.textures[0].coefficient, Coefficient::shininess);
      EXPECT_EQ(hit.textures[0].value[0], hit.shininess);
      ASSERT_TRUE(hit.bent);
      EXPECT_EQ(hit.bent->kind, NormalUse::Kind::normal_map);
      EXPECT_EQ(hit.bent->texture.name, "dents");
    }
  });
  for (const std::size_t count : {floor, globe, bumpy, dented, bare, mirrored})
    EXPECT_GT(count, 20u);
  // Noise is level here and there.
  EXPECT_GT(bent, bumpy * 9 / 10);
}

TEST(ExplainShapes, LeaveOutCrossingsFarBeforeTheHit) {
  // Twenty balls in a row that count only where the box behind them is.
  Scene scene = lab_scene(100);
  scene.materials = {{}};
  Csg balls{CsgOperation::unite, {}};
  for (int i = 0; i < 20; ++i)
    balls.of.push_back({Ellipsoid{{0, 0, -0.1 * i}, {0.5, 0.5, 0.04}}, kMaterialOfWhole, 0, ""});
  Csg both{CsgOperation::intersect, {}};
  both.of.push_back({balls, kMaterialOfWhole, 0, ""});
  both.of.push_back({Box{{-1, -1, -3}, {1, 1, -1.86}}, kMaterialOfWhole, 0, ""});
  scene.csgs.push_back({both, 0});
  const Explanation e = explain(scene, with(ProfileName::physical), 50, 50).value();
  const ExplainedHit& hit = *e.trees[0].rays[0].hit;
  // Nineteen balls in and out, the box, and the last one.
  EXPECT_EQ(hit.crossings->all.size(), kMostCrossingsKept);
  EXPECT_EQ(hit.crossings->left_out, 2u * 19 + 2 - kMostCrossingsKept);
  EXPECT_NEAR(hit.crossings->all.back().distance, 2 + 1.9 - 0.04, 1e-3);
  EXPECT_NE(to_text(e, {}).find("│     before: 8 crossings more\n"), std::string::npos);
  EXPECT_NE(to_json(e, "", "", "").find("\"left_out\": 8,"), std::string::npos);
}

TEST(ExplainShapes, NameWhatIsInGroupsAsBlockers) {
  std::size_t blocked = 0;
  each_ray_that_hits(chairs_scene(), [&](const ExplainedRay&, const ExplainedHit& hit) {
    for (const LightTerms& at : hit.lights) {
      if (!at.blocker || at.blocker->shape.id.kind == 0) continue;
      ++blocked;
      ASSERT_TRUE(at.blocker->path.inner);
      EXPECT_EQ(at.blocker->path.instances[0].shape.id, at.blocker->shape.id);
      EXPECT_EQ(at.blocker->path.member.has_value(), at.blocker->path.inner->name.empty());
    }
  });
  EXPECT_GT(blocked, 100u);
}

TEST(ExplainShapes, SayOfPlainShapesWhatTheyDid) {
  const auto keys = {"\"instances\"", "\"inner\"",    "\"csg\"", "\"transform\"",
                     "\"own\"",       "\"textures\"", "\"bent\""};
  for (const NamedScene& named : test_scenes(30)) {
    Explainer explainer = Explainer::create(named.scene, with(ProfileName::lab)).value();
    for (std::uint32_t i = 0; i < 30; ++i) {
      const std::string text = to_json(explainer.pixel(i, i).value(), "", "", "");
      for (const char* key : keys) EXPECT_EQ(text.find(key), std::string::npos) << key;
    }
  }
}

}  // namespace
}  // namespace zraka
