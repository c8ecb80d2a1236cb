// SPDX-License-Identifier: Apache-2.0
// From the scene as read to the scene as traced: into the engine's frame in double, then narrowed.
#include "scene/freeze.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <type_traits>

#include "core/in_parallel.hpp"
#include "scene/freeze_camera.hpp"
#include "scene/freeze_lights.hpp"
#include "scene/narrow.hpp"
#include "scene/pieces.hpp"
#include "scene/reals.hpp"

namespace zraka {
namespace {

template <class R>
void freeze_material(const Material& m, const Profile& profile, R* row) {
  const auto put = [&](int column, const Color& c) {
    row[column] = narrow<R>(c.r);
    row[column + 1] = narrow<R>(c.g);
    row[column + 2] = narrow<R>(c.b);
  };
  put(kAmbient, m.ambient);
  put(kDiffuse, m.diffuse);
  put(kSpecular, m.specular);
  row[kShininess] = narrow<R>(m.shininess);
  row[kReflection] = narrow<R>(m.reflection.r);
  row[kRefraction] = narrow<R>(m.refraction.r);
  const double into = profile.index_is_ratio ? m.ior : 1 / m.ior;
  row[kRatioIn] = narrow<R>(into);
  row[kRatioOut] = narrow<R>(1 / into);
  row[kBlinn] = m.highlight == Highlight::blinn ? R(1) : R(0);
  std::fill(row + kBlinn + 1, row + kMaterialReals, R(0));
}

/// Which of the kinds that there are for them a scene's shapes become.
struct ChosenKinds {
  bool anchored_spheres, cylinders;
};

/// The objects that become shapes of this kind.
template <class Shape>
const auto& objects_as(const ShapeLists& scene, const ChosenKinds& chosen) {
  static const std::vector<Object<Sphere>> kNoSpheres;
  static const std::vector<Object<Cone>> kNoCones;
  if constexpr (std::is_base_of_v<Sphere, Shape>)
    return chosen.anchored_spheres == std::is_same_v<Shape, AnchoredSphere> ? scene.spheres
                                                                            : kNoSpheres;
  else if constexpr (std::is_base_of_v<Cone, Shape>)
    return chosen.cylinders == std::is_same_v<Shape, Cylinder> ? scene.cones : kNoCones;
#define ZRAKA_ELSE(Type, plural) \
  else if constexpr (std::is_same_v<Shape, Type>) return scene.plural;
  ZRAKA_PRIMITIVES(ZRAKA_ELSE)
#undef ZRAKA_ELSE
}

/// The index of the kind's first shape in the scene as it was read.
template <class Shape>
std::int32_t first_id_of(const ShapeLists& scene) {
  std::size_t first = 0;
#define ZRAKA_ADD(Type, plural)                 \
  if constexpr (std::is_base_of_v<Type, Shape>) \
    return static_cast<std::int32_t>(first);    \
  else                                          \
    first += scene.plural.size();
  ZRAKA_PRIMITIVES(ZRAKA_ADD)
#undef ZRAKA_ADD
  return static_cast<std::int32_t>(first);
}

/// The pieces of those triangles that are large beside what the camera sees and come near it: of
/// each the first takes its place, the others come after all triangles.
template <class Shape>
struct Pieces {
  std::vector<std::size_t> cut;  ///< positions of what is cut
  std::vector<Numbers<Shape>> first, others;
  std::vector<std::int32_t> parents;  ///< of the others, their positions
};

template <class Shape, class Read>
Pieces<Shape> pieces_of(const std::vector<Object<Read>>& objects, const Frame& frame) {
  // Enough for thousands of such triangles.
  constexpr std::size_t kMostOfOne = 4096, kMostOfAll = std::size_t{1} << 20;
  Pieces<Shape> all;
  if constexpr (kHasPieces<Shape>) {
    std::mutex adding;
    in_parallel(objects.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const Bounds box = ShapeTraits<Shape>::bounds(objects[i].shape);
        if (box.reach() <= std::max(kMostWidths * frame.width_seen, box.distance_to(frame.center)))
          continue;
        const std::lock_guard lock(adding);
        all.cut.push_back(i);
      }
    });
    std::sort(all.cut.begin(), all.cut.end());
    // Normals of smaller pieces have squares that floats cannot hold.
    const double fine = std::max(frame.length(frame.width_seen) * kMostWidths / 4, 0x1p-28);
    std::size_t kept = 0;
    for (const std::size_t i : all.cut) {
      Numbers<Shape> whole;
      ShapeTraits<Shape>::freeze(objects[i].shape, frame, whole.data());
      std::vector<Numbers<Shape>> pieces;
      if (all.others.size() > kMostOfAll ||
          !cut_to_pieces<Shape>(whole, fine, kMostOfOne, pieces) || pieces.size() < 2)
        continue;
      all.cut[kept++] = i;
      all.first.push_back(pieces.front());
      all.others.insert(all.others.end(), pieces.begin() + 1, pieces.end());
      all.parents.resize(all.others.size(), static_cast<std::int32_t>(i));
    }
    all.cut.resize(kept);
  }
  return all;
}

bool all_are_cylinders(const std::vector<Object<Cone>>& cones) {
  return std::all_of(cones.begin(), cones.end(), [](const Object<Cone>& object) {
    return object.shape.base_radius == object.shape.apex_radius;
  });
}

std::int32_t first_body_id(const ShapeLists& shapes) {
  std::size_t first = 0;
#define ZRAKA_ADD(Type, plural) first += shapes.plural.size();
  ZRAKA_PRIMITIVES(ZRAKA_ADD)
#undef ZRAKA_ADD
  return static_cast<std::int32_t>(first);
}

template <class Shape>
constexpr std::int32_t kind_of_shape() {
#define ZRAKA_IF(Type, plural) \
  if constexpr (std::is_same_v<Shape, Type>) return kKindOf##Type;
  ZRAKA_INLINED_KINDS(ZRAKA_IF)
#undef ZRAKA_IF
}

/// What textures need of shapes of one kind.
template <class Shape, class Read>
void freeze_mapping(const ShapeLists& shapes, const std::vector<Object<Read>>& objects,
                    const std::vector<std::size_t>& cut, const Frame& frame,
                    std::vector<std::int32_t>& transforms, std::vector<CornerUvs>& uvs,
                    std::vector<WholeTriangle>& wholes, FrozenMapping& out) {
  if (std::any_of(objects.begin(), objects.end(),
                  [](const Object<Read>& object) { return object.transform != 0; })) {
    for (const Object<Read>& object : objects)
      transforms.push_back(static_cast<std::int32_t>(object.transform));
    out.transform = transforms.data();
  }
  if constexpr (std::is_same_v<Shape, Triangle>) uvs = shapes.triangle_uvs;
  if constexpr (std::is_same_v<Shape, SmoothTriangle>) uvs = shapes.smooth_triangle_uvs;
  if (!uvs.empty()) out.uvs = uvs.data();
  if constexpr (kHasPieces<Shape>) {
    for (const std::size_t i : cut) {
      Numbers<Shape> whole;
      ShapeTraits<Shape>::freeze(objects[i].shape, frame, whole.data());
      wholes.push_back({static_cast<std::int32_t>(i), {}});
      std::copy(whole.begin(), whole.begin() + 9, wholes.back().corners);
    }
    out.wholes = wholes.data();
    out.whole_count = static_cast<std::int32_t>(wholes.size());
  }
}

/// The shapes of the kinds that are inlined. Returns the number of their slots.
template <class R>
std::int32_t freeze_shapes(const ShapeLists& shapes, const Whereabouts& where,
                           const std::vector<Material>& materials, const Profile& profile,
                           const Frame& frame, bool textured, FrozenStore<R>& store) {
  FrozenScene<R>& frozen = store.scene;
  // One array for all the numbers: materials first, then column by column of each kind of shape.
  const ChosenKinds chosen{has_ground_sphere(shapes, where, frame),
                           all_are_cylinders(shapes.cones)};
  std::size_t reals = materials.size() * kMaterialReals, slots = 0;
  const auto add_room = [&]<class Shape>(const auto& objects, const Pieces<Shape>& pieces) {
    const std::size_t room = objects.size() + pieces.others.size() + kColumnPadding;
    reals += room * static_cast<std::size_t>(ShapeTraits<Shape>::kReals);
    slots += room;
  };
#define ZRAKA_COUNT(Type, plural)                                                     \
  auto pieces_of_##plural = pieces_of<Type>(objects_as<Type>(shapes, chosen), frame); \
  add_room(objects_as<Type>(shapes, chosen), pieces_of_##plural);
  ZRAKA_INLINED_KINDS(ZRAKA_COUNT)
#undef ZRAKA_COUNT
  store.materials.resize(slots);
  store.reals.resize(reals);
  R* real = store.reals.data();
  std::int32_t* material = store.materials.data();

  frozen.materials = real;
  for (const Material& one : materials) {
    freeze_material(one, profile, real);
    real += kMaterialReals;
  }

  std::int32_t first_slot = 0;
  const auto freeze_kind = [&]<class Shape>(const auto& objects, Pieces<Shape>& pieces,
                                            FrozenShapes<R, Shape>& out,
                                            std::vector<std::int32_t>& parents) {
    using Traits = ShapeTraits<Shape>;
    const std::size_t count = objects.size() + pieces.others.size();
    R* column[Traits::kReals];
    for (int k = 0; k < Traits::kReals; ++k, real += count + kColumnPadding) {
      out.column[k] = column[k] = real;
      std::fill_n(real + count, kColumnPadding, R(0));
    }
    out.material = material;
    std::fill_n(material + count, kColumnPadding, 0);
    out.count = static_cast<std::int32_t>(count);
    out.first_slot = first_slot;
    out.first_id = first_id_of<Shape>(shapes);
    first_slot += out.count;
    const auto put_numbers = [&](const double* numbers, std::size_t i) {
      for (int k = 0; k < Traits::kReals; ++k) column[k][i] = narrow<R>(numbers[k]);
    };
    in_parallel(objects.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        double numbers[Traits::kReals];
        Traits::freeze(objects[i].shape, frame, numbers);
        put_numbers(numbers, i);
        material[i] = static_cast<std::int32_t>(objects[i].material);
      }
    });
    for (std::size_t i = 0; i < pieces.cut.size(); ++i)
      put_numbers(pieces.first[i].data(), pieces.cut[i]);
    for (std::size_t i = 0; i < pieces.others.size(); ++i) {
      put_numbers(pieces.others[i].data(), objects.size() + i);
      material[objects.size() + i] = material[pieces.parents[i]];
    }
    material += count + kColumnPadding;
    parents = std::move(pieces.parents);
    if (textured) {
      constexpr std::int32_t kind = kind_of_shape<Shape>();
      freeze_mapping<Shape>(shapes, objects, pieces.cut, frame, store.transforms[kind],
                            store.uvs[kind], store.wholes[kind], out.mapping);
    }
  };
#define ZRAKA_FREEZE(Type, plural)                                                 \
  freeze_kind(objects_as<Type>(shapes, chosen), pieces_of_##plural, frozen.plural, \
              store.parents[kKindOf##Type]);
  ZRAKA_INLINED_KINDS(ZRAKA_FREEZE)
#undef ZRAKA_FREEZE
  return first_slot;
}

/// The textures of all materials; nullptr where there are none.
std::unique_ptr<StoredTextures> freeze_textures(const Scene& scene) {
  const bool any =
      std::any_of(scene.materials.begin(), scene.materials.end(), [](const Material& m) {
        return !m.textures.empty() || m.normals.kind != NormalUse::Kind::none;
      });
  if (!any && scene.sky.kind != Sky::Kind::image) return nullptr;
  auto stored = std::make_unique<StoredTextures>();
  stored->set = TextureSet(scene.textures);
  for (const Material& m : scene.materials)
    stored->uses.insert(stored->uses.end(), m.textures.begin(), m.textures.end());
  const TextureUse* uses = stored->uses.data();
  for (const Material& m : scene.materials) {
    const auto count = static_cast<std::int32_t>(m.textures.size());
    const auto any_use = [&](const auto& test) {
      return m.normals.kind != NormalUse::Kind::none || std::any_of(uses, uses + count, test);
    };
    const TextureSet& set = stored->set;
    MaterialTextures its{uses, count, m.normals, false, false, false, false, false};
    its.sees_uv = any_use(
        [&](const TextureUse& use) { return set.mapping(use.texture) == TextureMapping::uv; });
    its.sees_footprint =
        any_use([&](const TextureUse& use) { return set.sees_footprint(use.texture); });
    its.has_borders = any_use([&](const TextureUse& use) { return set.has_borders(use.texture); });
    its.of_children = std::any_of(uses, uses + count, [](const TextureUse& use) {
      return use.coefficient == Coefficient::reflection ||
             use.coefficient == Coefficient::refraction;
    });
    its.in_lanes = m.normals.kind == NormalUse::Kind::none && count > 0 &&
                   std::all_of(uses, uses + count,
                               [&](const TextureUse& use) { return set.in_lanes(use.texture); });
    stored->of_material.push_back(its);
    uses += count;
  }
  stored->frozen = {&stored->set, stored->of_material.data(), nullptr};
  return stored;
}

/// Frames of all groups: around what of them has bounds.
std::vector<GroupPlace> places_of_groups(const Scene& scene, const Whereabouts& where) {
  std::vector<GroupPlace> places;
  for (const Group& group : scene.groups) {
    Bounds bounds;
    bool unbounded = false;
    const auto include = [&](const auto& objects) {
      for (const auto& object : objects) {
        const Bounds box = where.bounds(object);
        if (box.bounded())
          bounds.include(box);
        else
          unbounded = true;
      }
    };
#define ZRAKA_INCLUDE(Type, plural) include(group.plural);
    ZRAKA_SHAPES(ZRAKA_INCLUDE)
#undef ZRAKA_INCLUDE
    const Vec3 middle = bounds.empty() ? Vec3()
                                       : Vec3{bounds.lower.x / 2 + bounds.upper.x / 2,
                                              bounds.lower.y / 2 + bounds.upper.y / 2,
                                              bounds.lower.z / 2 + bounds.upper.z / 2};
    const Frame frame = Frame::around(middle, bounds);
    const Vec3 corner = bounds.empty() ? Vec3() : frame.point(bounds.upper);
    // A little more than to its corners.
    const double reach =
        std::sqrt(corner.x * corner.x + corner.y * corner.y + corner.z * corner.z) * 1.01;
    places.push_back({frame, unbounded ? Bounds::kInfinity : reach});
  }
  return places;
}

/// All shapes of a scene or a group.
template <class R>
void freeze_all(const ShapeLists& shapes, const Whereabouts& where,
                const std::vector<Material>& materials, const Profile& profile, const Frame& frame,
                const std::vector<GroupPlace>& groups, bool textured,
                std::vector<Transform>& transforms, FrozenStore<R>& store) {
  store.scene.frame_scale = frame.scale;
  store.scene.frame_center = frame.center;
  const std::int32_t slots =
      freeze_shapes(shapes, where, materials, profile, frame, textured, store);
  FrozenShapes<R, Body>& bodies = store.scene.bodies;
  freeze_bodies(shapes, where, frame, groups, first_body_id(shapes), transforms, store.bodies,
                bodies);
  bodies.first_slot = slots;
}

}  // namespace

template <class R>
std::unique_ptr<FrozenStore<R>> freeze(const Scene& scene, const Profile& profile,
                                       const Frame& frame, bool optics) {
  auto store = std::make_unique<FrozenStore<R>>();
  FrozenScene<R>& frozen = store->scene;
  frozen.camera = freeze_camera<R>(scene, profile, frame);
  frozen.reach = narrow<R>(frame.reach);
  frozen.background = narrow<R>(scene.background);
  frozen.ambient_light = narrow<R>(scene.ambient_light);

  for (const Light& light : scene.lights)
    store->lights.push_back(freeze_lean_light<R>(light, frame));
  frozen.lights = store->lights.data();
  frozen.light_count = static_cast<std::int32_t>(store->lights.size());

  if (optics || has_optics(scene)) {
    store->optics = freeze_optics(scene, profile, frame);
    frozen.optics = &store->optics->frozen;
  } else if (has_shadowless(scene)) {
    for (const Material& m : scene.materials) store->shadowless.push_back(m.casts_shadow ? 0 : 1);
    frozen.shadowless = store->shadowless.data();
  }

  const Whereabouts where(scene);
  if (store->optics && store->optics->frozen.has_caps)
    find_body_sizes(scene, where, frame, *store->optics);
  const std::vector<GroupPlace> places = places_of_groups(scene, where);
  store->textures = freeze_textures(scene);
  const bool textured = store->textures != nullptr;
  frozen.textures = textured ? &store->textures->frozen : nullptr;
  std::vector<Transform> transforms = scene.transforms;
  freeze_all(scene, where, scene.materials, profile, frame, places, textured, transforms, *store);
  store->groups.resize(scene.groups.size());
  frozen.bodies.groups = store->groups.data();
  for (std::size_t i = 0; i < scene.groups.size(); ++i) {
    auto group = std::make_unique<FrozenStore<R>>();
    // What it is made of is the scene's.
    freeze_all(scene.groups[i], where, {}, profile, places[i].frame, places, textured, transforms,
               *group);
    group->scene.materials = frozen.materials;
    group->scene.bodies.groups = store->groups.data();
    group->scene.reach = R(1);
    group->scene.camera.eye = {R(2), R(2), R(2)};  // rays come from no farther
    store->group_stores.push_back(std::move(group));
  }
  if (textured) {
    for (const Transform& t : transforms)
      store->textures->to_shape.push_back(inverse(t).value_or(Transform()));
    store->textures->frozen.to_shape = store->textures->to_shape.data();
  }
  return store;
}

template <class R>
std::uint64_t FrozenStore<R>::bytes() const {
  std::uint64_t bytes = (reals.size() + rows.size()) * sizeof(R) +
                        (materials.size() + ids.size()) * sizeof(std::int32_t) +
                        lights.size() * sizeof(FrozenLight<R>) + this->bodies.bytes();
  for (const auto& group : group_stores) bytes += group->bytes();
  return bytes;
}

#define ZRAKA_FOR(R)                                                                             \
  template std::uint64_t FrozenStore<R>::bytes() const;                                          \
  template std::unique_ptr<FrozenStore<R>> freeze<R>(const Scene&, const Profile&, const Frame&, \
                                                     bool);
ZRAKA_FOR_REALS(ZRAKA_FOR)
#undef ZRAKA_FOR

}  // namespace zraka
