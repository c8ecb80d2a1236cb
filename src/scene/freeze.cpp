// SPDX-License-Identifier: Apache-2.0
// From the scene as read to the scene as traced: into the engine's frame in double, then narrowed.
#include "scene/freeze.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace zraka {
namespace {

/// The nearest value of R, the largest one for what is out of its range.
template <class R>
R narrow(double v) {
  constexpr double kLargest = std::numeric_limits<R>::max();
  return static_cast<R>(std::fmin(std::fmax(v, -kLargest), kLargest));
}

template <class R>
V3<R> narrow(const Vec3& v) {
  return {narrow<R>(v.x), narrow<R>(v.y), narrow<R>(v.z)};
}

template <class R>
V3<R> narrow(const Color& c) {
  return {narrow<R>(c.r), narrow<R>(c.g), narrow<R>(c.b)};
}

/// A light from so far that its direction is the same all over the scene: nearer, where squares
/// stay finite.
Vec3 within_reach(const Vec3& light) {
  constexpr double kFar = 0x1p+40;
  const double away = std::max({std::fabs(light.x), std::fabs(light.y), std::fabs(light.z)});
  return away > kFar ? Vec3{light.x / away * kFar, light.y / away * kFar, light.z / away * kFar}
                     : light;
}

template <class R>
FrozenCamera<R> freeze_camera(const Scene& scene, const Profile& profile, const Frame& frame) {
  const Camera& camera = scene.camera;
  const double width = scene.resolution.width;
  const double height = scene.resolution.height;
  const auto column =
      V3<double>{camera.window_right.x, camera.window_right.y, camera.window_right.z} *
      (frame.scale / width);
  const auto row = V3<double>{camera.window_up.x, camera.window_up.y, camera.window_up.z} *
                   (-frame.scale / height);
  // The sheet's pixel is its upper left corner, i = column - resolution/2; others look through
  // centres.
  const double in_pixel = profile.pixel_centers ? 0.5 : 0.0;
  const V3<double> center = {(camera.window_center.x - camera.eye.x) * frame.scale,
                             (camera.window_center.y - camera.eye.y) * frame.scale,
                             (camera.window_center.z - camera.eye.z) * frame.scale};
  const auto first = center + column * (in_pixel - width / 2) + row * (in_pixel - height / 2);
  const auto to_real = [](const V3<double>& v) {
    return V3<R>{narrow<R>(v.x), narrow<R>(v.y), narrow<R>(v.z)};
  };
  return {narrow<R>(frame.point(camera.eye)), to_real(first), to_real(column), to_real(row)};
}

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
  row[kReflection] = narrow<R>(m.reflection);
  row[kRefraction] = narrow<R>(m.refraction);
  const double into = profile.index_is_ratio ? m.refractive : 1 / m.refractive;
  row[kRatioIn] = narrow<R>(into);
  row[kRatioOut] = narrow<R>(1 / into);
}

}  // namespace

Frame frame_of(const Scene& scene) {
  constexpr std::uint64_t kSamples = 65536;
  const std::uint64_t step = scene.shape_count() / kSamples + 1;
  Box bounds;
  std::vector<double> x, y, z;
  std::uint64_t index = 0;
  const auto look_at = [&](const Box& box) {
    bounds.include(box);
    if (index++ % step != 0) return;
    x.push_back(box.lower.x / 2 + box.upper.x / 2);
    y.push_back(box.lower.y / 2 + box.upper.y / 2);
    z.push_back(box.lower.z / 2 + box.upper.z / 2);
  };
#define ZRAKA_LOOK(Type, plural) \
  for (const auto& object : scene.plural) look_at(ShapeTraits<Type>::bounds(object.shape));
  ZRAKA_SHAPES(ZRAKA_LOOK)
#undef ZRAKA_LOOK
  if (x.empty()) return {};
  const auto median = [](std::vector<double>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  };
  return Frame::around({median(x), median(y), median(z)}, bounds);
}

std::vector<BuildRef> references_to(const Scene& scene, const Frame& frame) {
  // Intersections err by a few units in the last place of the numbers that they are made of:
  // coordinates in the scene, at most 1 in this frame, and the eye's.
  const Vec3 eye = frame.point(scene.camera.eye);
  const double margin =
      0x1p-20 * (1 + std::max({std::fabs(eye.x), std::fabs(eye.y), std::fabs(eye.z)}));
  std::vector<BuildRef> refs;
  refs.reserve(scene.shape_count());
  const auto add = [&]<class Shape>(const std::vector<Object<Shape>>& objects, std::int32_t kind) {
    for (std::size_t i = 0; i < objects.size(); ++i) {
      const Box box = ShapeTraits<Shape>::bounds(objects[i].shape);
      const Vec3 lower = frame.point(box.lower), upper = frame.point(box.upper);
      refs.push_back({{narrow<float>(lower.x - margin), narrow<float>(lower.y - margin),
                       narrow<float>(lower.z - margin)},
                      static_cast<std::int32_t>(i),
                      {narrow<float>(upper.x + margin), narrow<float>(upper.y + margin),
                       narrow<float>(upper.z + margin)},
                      kind});
    }
  };
#define ZRAKA_ADD(Type, plural) add(scene.plural, kKindOf##Type);
  ZRAKA_SHAPES(ZRAKA_ADD)
#undef ZRAKA_ADD
  return refs;
}

template <class R>
std::unique_ptr<FrozenStore<R>> freeze(const Scene& scene, const Profile& profile,
                                       const Frame& frame, const BuiltHierarchy& hierarchy) {
  auto store = std::make_unique<FrozenStore<R>>();
  FrozenScene<R>& frozen = store->scene;
  frozen.camera = freeze_camera<R>(scene, profile, frame);
  frozen.background = narrow<R>(scene.background);
  frozen.ambient_light = narrow<R>(scene.ambient_light);

  for (const PointLight& light : scene.lights)
    store->lights.push_back(
        {narrow<R>(within_reach(frame.point(light.position))), narrow<R>(light.color)});
  frozen.lights = store->lights.data();
  frozen.light_count = static_cast<std::int32_t>(store->lights.size());

  // One array for all the numbers: materials first, then column by column of each kind of shape.
  std::size_t reals = scene.materials.size() * kMaterialReals;
#define ZRAKA_COUNT(Type, plural) \
  reals += (scene.plural.size() + kColumnPadding) * ShapeTraits<Type>::kReals;
  ZRAKA_SHAPES(ZRAKA_COUNT)
#undef ZRAKA_COUNT
  store->reals.resize(reals);
  store->indices.resize(2 * (scene.shape_count() + kKinds * kColumnPadding));
  R* real = store->reals.data();
  std::int32_t* index = store->indices.data();

  frozen.materials = real;
  for (const Material& material : scene.materials) {
    freeze_material(material, profile, real);
    real += kMaterialReals;
  }

  std::int32_t first_slot = 0;
  const auto freeze_shapes = [&]<class Shape>(const std::vector<Object<Shape>>& objects,
                                              FrozenShapes<R, Shape>& out, std::size_t kind) {
    using Traits = ShapeTraits<Shape>;
    const std::size_t room = objects.size() + kColumnPadding;
    R* column[Traits::kReals];
    for (int k = 0; k < Traits::kReals; ++k, real += room) out.column[k] = column[k] = real;
    std::int32_t* material = index;
    std::int32_t* id = index + room;
    index += 2 * room;
    out.material = material;
    out.id = id;
    out.count = static_cast<std::int32_t>(objects.size());
    out.first_slot = first_slot;
    first_slot += out.count;
    for (std::size_t slot = 0; slot < objects.size(); ++slot) {
      const std::size_t i =
          hierarchy.order.empty() ? slot : static_cast<std::size_t>(hierarchy.order[kind][slot]);
      double numbers[Traits::kReals];
      Traits::freeze(objects[i].shape, frame, numbers);
      for (int k = 0; k < Traits::kReals; ++k) column[k][slot] = narrow<R>(numbers[k]);
      material[slot] = static_cast<std::int32_t>(objects[i].material);
      id[slot] = out.first_slot + static_cast<std::int32_t>(i);
    }
  };
#define ZRAKA_FREEZE(Type, plural) freeze_shapes(scene.plural, frozen.plural, kKindOf##Type);
  ZRAKA_SHAPES(ZRAKA_FREEZE)
#undef ZRAKA_FREEZE
  frozen.hierarchy = {hierarchy.nodes.empty() ? nullptr : hierarchy.nodes.data(),
                      static_cast<std::int32_t>(hierarchy.nodes.size())};

  store->bytes = store->reals.size() * sizeof(R) + store->indices.size() * sizeof(std::int32_t) +
                 store->lights.size() * sizeof(FrozenLight<R>);
  return store;
}

template std::unique_ptr<FrozenStore<float>> freeze<float>(const Scene&, const Profile&,
                                                           const Frame&, const BuiltHierarchy&);
template std::unique_ptr<FrozenStore<double>> freeze<double>(const Scene&, const Profile&,
                                                             const Frame&, const BuiltHierarchy&);

}  // namespace zraka
