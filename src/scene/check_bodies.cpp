// SPDX-License-Identifier: Apache-2.0
#include "scene/check_bodies.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <set>
#include <type_traits>
#include <variant>
#include <vector>

#include "scene/bounds_of.hpp"
#include "scene/check_shape.hpp"
#include "scene/csg_size.hpp"

namespace zraka {
namespace {

bool all_finite(const Transform& t) {
  for (const Vec3& v : {t.along_x, t.along_y, t.along_z, t.origin})
    if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z)) return false;
  return true;
}

class Checker {
 public:
  Checker(const Scene& scene, const Complain& complain) : scene_(scene), tell_(complain) {}

  bool check() {
    for (std::size_t i = 0; i < scene_.transforms.size(); ++i)
      if (const std::string problem = problem_of(scene_.transforms[i]); !problem.empty())
        complain(fmt::format("transform {}: {}", i + 1, problem));
    check_lists(scene_, "", false);
    for (std::size_t i = 0; i < scene_.groups.size(); ++i)
      check_lists(scene_.groups[i], fmt::format(" of group {}", i + 1), true);
    if (!cyclic_) check_levels();
    for (std::size_t i = 0; i < scene_.textures.size(); ++i) check(scene_.textures[i], i);
    for (std::size_t i = 0; i < scene_.materials.size(); ++i) check(scene_.materials[i], i);
    return good_;
  }

 private:
  void complain(std::string message, std::string hint = {}) {
    good_ = false;
    tell_(std::move(message), std::move(hint));
  }

  void check_lists(const ShapeLists& shapes, const std::string& of, bool parts) {
#define ZRAKA_CHECK(Type, plural) \
  for (std::size_t i = 0; i < shapes.plural.size(); ++i) check(shapes.plural[i], i, of, parts);
    if (parts) {
      ZRAKA_PRIMITIVES(ZRAKA_CHECK)
    }  // those of the scene may be many, and are looked at by many threads
    ZRAKA_BODIES(ZRAKA_CHECK)
#undef ZRAKA_CHECK
    check_uvs(shapes.triangle_uvs, shapes.triangles.size(), "triangles", of);
    check_uvs(shapes.smooth_triangle_uvs, shapes.smooth_triangles.size(), "smooth triangles", of);
  }

  void check_uvs(const std::vector<CornerUvs>& uvs, std::size_t triangles, std::string_view what,
                 const std::string& of) {
    if (!uvs.empty() && uvs.size() != triangles)
      complain(
          fmt::format("{} {}{} have texture coordinates for {}", triangles, what, of, uvs.size()),
          "expected none, or as many");
    for (std::size_t i = 0; i < uvs.size(); ++i)
      for (const auto& [u, v] : uvs[i])
        if (!std::isfinite(u) || !std::isfinite(v))
          return complain(
              fmt::format("texture coordinates of {} {}{} are not finite", what, i + 1, of));
  }

  template <class Shape>
  void check(const Object<Shape>& object, std::size_t index, const std::string& of, bool part) {
    const auto tell = [&](const std::string& problem) {
      complain(fmt::format("{} {}{}: {}", ShapeTraits<Shape>::kName, index + 1, of, problem));
    };
    if (const std::string problem = problem_of_places(object.material, object.transform, part);
        !problem.empty())
      tell(problem);
    if constexpr (std::is_same_v<Shape, Instance>) {
      if (object.shape.group >= scene_.groups.size()) {
        cyclic_ = true;  // or worse
        tell(fmt::format("it is of group {}, but there are {}", object.shape.group,
                         scene_.groups.size()));
      }
    }
    if constexpr (std::is_same_v<Shape, Csg>) {
      if (const std::string problem = problem_of_members(object.shape, 1); !problem.empty())
        tell(problem);
      else if (const std::string size = problem_of_size(size_of(object.shape)); !size.empty())
        tell(size);
    } else if (part) {  // those of the scene itself are looked at with their bounds
      if (const std::string problem = problem_of_shape(object); !problem.empty()) tell(problem);
    }
  }

  template <class Shape>
  std::string problem_of_shape(const Object<Shape>& object) const {
    if constexpr (is_body<Shape>)
      return problem_of(object.shape,
                        object.transform == 0 || object.transform > scene_.transforms.size()
                            ? Transform{}
                            : scene_.transforms[object.transform - 1]);
    else
      return problem_of(object.shape);
  }

  std::string problem_of_places(std::uint32_t material, std::uint32_t transform, bool part) const {
    if (part && material >= scene_.materials.size() && material != kMaterialOfWhole)
      return fmt::format("it has material {}, but there are {}", material, scene_.materials.size());
    if (transform > scene_.transforms.size())
      return fmt::format("it has transform {}, but there are {}", transform,
                         scene_.transforms.size());
    return "";
  }

  std::string problem_of_members(const Csg& csg, int depth) const {
    if (depth > kMostCsgDepth) return problem_of_size({.depth = depth});
    if (csg.of.empty()) return "it has no members";
    for (std::size_t i = 0; i < csg.of.size(); ++i) {
      const CsgMember& member = csg.of[i];
      std::string problem = problem_of_places(member.material, member.transform, true);
      if (problem.empty())
        problem = std::visit(
            [&]<class Shape>(const Shape& shape) { return problem_of_member(shape, depth); },
            member.body);
      if (!problem.empty()) return fmt::format("member {}: {}", i + 1, problem);
    }
    return "";
  }

  template <class Shape>
  std::string problem_of_member(const Shape& shape, int depth) const {
    if constexpr (std::is_same_v<Shape, std::monostate>) {
      return "it is nothing";
    } else if constexpr (std::is_same_v<Shape, Csg>) {
      return problem_of_members(shape, depth + 1);
    } else if constexpr (!ShapeTraits<Shape>::kClosed) {
      return fmt::format("{} is no closed body", ShapeTraits<Shape>::kName);
    } else {
      std::string problem = problem_of(shape, Transform{});
      if (problem.empty()) problem = zraka::problem_of_member(shape);
      return problem.empty() ? "" : fmt::format("{}: {}", ShapeTraits<Shape>::kName, problem);
    }
  }

  /// Groups that are in others come before them: what is never ready is in itself.
  void check_levels() {
    const std::size_t count = scene_.groups.size();
    std::vector<std::size_t> waits(count);
    std::vector<int> levels(count, 1);
    std::vector<std::vector<std::uint32_t>> in(count);
    for (std::uint32_t i = 0; i < count; ++i)
      for (const Object<Instance>& object : scene_.groups[i].instances) {
        in[object.shape.group].push_back(i);
        ++waits[i];
      }
    std::vector<std::uint32_t> ready;
    for (std::uint32_t i = 0; i < count; ++i)
      if (waits[i] == 0) ready.push_back(i);
    for (std::size_t next = 0; next < ready.size(); ++next)
      for (const std::uint32_t outer : in[ready[next]]) {
        levels[outer] = std::max(levels[outer], levels[ready[next]] + 1);
        if (--waits[outer] == 0) ready.push_back(outer);
      }
    for (std::size_t i = 0; i < count; ++i) {
      if (waits[i] > 0) return complain(fmt::format("group {} has itself in it", i + 1));
      if (levels[i] > kMostGroupLevels)
        return complain(fmt::format("group {} has groups in it {} deep: at most {} fit", i + 1,
                                    levels[i], kMostGroupLevels),
                        "");
    }
  }

  void check(const Texture& texture, std::size_t index) {
    const auto tell = [&](const std::string& problem) {
      complain(fmt::format("texture {}: {}", index + 1, problem));
    };
    if (const std::string problem = problem_of(texture.transform); !problem.empty())
      tell(fmt::format("its transform: {}", problem));
    if (texture.kind == TextureKind::image) {
      if (texture.image == nullptr) tell("it has no picture");
      return;
    }
    if (texture.colors.size() < 2) tell("it has fewer than two colours");
    for (const Color& c : texture.colors)
      if (!std::isfinite(c.r) || !std::isfinite(c.g) || !std::isfinite(c.b))
        return tell("a colour is not finite");
    if (!std::isfinite(texture.size) || !(texture.size > 0))
      tell("its size is no finite number above 0");
    const Vec3& d = texture.direction;
    if (!std::isfinite(d.x) || !std::isfinite(d.y) || !std::isfinite(d.z) || d == Vec3{})
      tell("its direction is 0, or not finite");
    if (!std::isfinite(texture.turbulence) || texture.turbulence < 0)
      tell("its turbulence is no finite number of 0 or more");
    if (texture.octaves < 1 || texture.octaves > kMostOctaves)
      tell(fmt::format("its octaves are none from 1 to {}", kMostOctaves));
  }

  void check(const Material& material, std::size_t index) {
    const auto in_range = [&](std::uint32_t texture) {
      if (texture >= scene_.textures.size())
        complain(fmt::format("material {} has texture {}, but there are {}", index + 1, texture,
                             scene_.textures.size()),
                 "");
    };
    for (const TextureUse& use : material.textures) in_range(use.texture);
    std::set<Coefficient> given;
    for (const TextureUse& use : material.textures)
      if (!given.insert(use.coefficient).second)
        complain(fmt::format("material {} has two textures for one coefficient", index + 1));
    if (material.normals.kind == NormalUse::Kind::none) return;
    in_range(material.normals.texture);
    if (!std::isfinite(material.normals.height))
      complain(fmt::format("material {}: how high its bumps are is not finite", index + 1));
  }

  const Scene& scene_;
  const Complain& tell_;
  bool good_ = true;
  bool cyclic_ = false;
};

}  // namespace

std::string problem_of(const Transform& transform) {
  if (!all_finite(transform)) return "it is not finite";
  return inverse(transform) ? "" : "it makes all that it moves flat";
}

bool check_references(const Scene& scene, const Complain& complain) {
  return Checker(scene, complain).check();
}

}  // namespace zraka
