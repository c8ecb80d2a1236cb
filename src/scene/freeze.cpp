// SPDX-License-Identifier: Apache-2.0
// From the scene as read to the scene as traced: into the engine's frame in double, then narrowed.
#include "scene/freeze.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "core/handover.hpp"
#include "core/in_parallel.hpp"
#include "scene/narrow.hpp"

namespace zraka {
namespace {

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
  const double into = profile.index_is_ratio ? m.ior : 1 / m.ior;
  row[kRatioIn] = narrow<R>(into);
  row[kRatioOut] = narrow<R>(1 / into);
  std::fill(row + kRatioOut + 1, row + kMaterialReals, R(0));
}

/// Calls function(box) for some shapes, evenly over all.
template <class Function>
void each_sample(const Scene& scene, const Function& function) {
  constexpr std::uint64_t kSamples = 65536;
  const std::uint64_t step = scene.shape_count() / kSamples + 1;
  std::uint64_t index = 0;  // over all kinds
#define ZRAKA_LOOK(Type, plural)                                    \
  for (; index < scene.plural.size(); index += step)                \
    function(ShapeTraits<Type>::bounds(scene.plural[index].shape)); \
  index -= scene.plural.size();
  ZRAKA_SHAPES(ZRAKA_LOOK)
#undef ZRAKA_LOOK
}

/// What `more` makes of all objects, from `none` on; `join` puts two parts' results together.
template <class T, class Shape, class More, class Join>
T reduced(const std::vector<Object<Shape>>& objects, const T& none, const More& more,
          const Join& join) {
  using Iterator = typename std::vector<Object<Shape>>::const_iterator;
  Handover handover;
  handover.give();
  const T all = tbb::parallel_reduce(
      tbb::blocked_range<Iterator>(objects.begin(), objects.end(), 65536), none,
      [&](const tbb::blocked_range<Iterator>& part, T sum) {
        handover.take();
        for (const Object<Shape>& object : part) more(sum, object.shape);
        handover.give();
        return sum;
      },
      join);
  handover.take();
  return all;
}

Box bounds_of(const Scene& scene) {
  Box bounds;
  const auto join = [](Box a, const Box& b) {
    a.include(b);
    return a;
  };
  const auto include = [&]<class Shape>(const std::vector<Object<Shape>>& objects) {
    const auto more = [](Box& sum, const Shape& shape) {
      sum.include(ShapeTraits<Shape>::bounds(shape));
    };
    bounds.include(reduced(objects, Box(), more, join));
  };
#define ZRAKA_INCLUDE(Type, plural) include(scene.plural);
  ZRAKA_SHAPES(ZRAKA_INCLUDE)
#undef ZRAKA_INCLUDE
  return bounds;
}

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Which of the kinds that there are for them a scene's shapes become.
struct ChosenKinds {
  bool anchored_spheres, cylinders;
};

/// The objects that become shapes of this kind.
template <class Shape>
const auto& objects_as(const Scene& scene, const ChosenKinds& chosen) {
  static const std::vector<Object<Sphere>> kNoSpheres;
  static const std::vector<Object<Cone>> kNoCones;
  if constexpr (std::is_base_of_v<Sphere, Shape>)
    return chosen.anchored_spheres == std::is_same_v<Shape, AnchoredSphere> ? scene.spheres
                                                                            : kNoSpheres;
  else if constexpr (std::is_base_of_v<Cone, Shape>)
    return chosen.cylinders == std::is_same_v<Shape, Cylinder> ? scene.cones : kNoCones;
#define ZRAKA_ELSE(Type, plural) \
  else if constexpr (std::is_same_v<Shape, Type>) return scene.plural;
  ZRAKA_SHAPES(ZRAKA_ELSE)
#undef ZRAKA_ELSE
}

/// The index of the kind's first shape in the scene as it was read.
template <class Shape>
std::int32_t first_id_of(const Scene& scene) {
  std::size_t first = 0;
#define ZRAKA_ADD(Type, plural)                 \
  if constexpr (std::is_base_of_v<Type, Shape>) \
    return static_cast<std::int32_t>(first);    \
  else                                          \
    first += scene.plural.size();
  ZRAKA_SHAPES(ZRAKA_ADD)
#undef ZRAKA_ADD
  return static_cast<std::int32_t>(first);
}

/// Is there a sphere so large beside most shapes that they need their digits where it passes them?
bool has_ground_sphere(const Scene& scene, const Frame& frame) {
  const double largest = frame.length(reduced(
      scene.spheres, 0.0, [](double& most, const Sphere& s) { most = std::max(most, s.radius); },
      [](double a, double b) { return std::max(a, b); }));
  std::vector<double> reaches;
  each_sample(scene, [&](const Box& box) {
    const Vec3 lower = frame.point(box.lower), upper = frame.point(box.upper);
    reaches.push_back(std::max({std::fabs(lower.x), std::fabs(lower.y), std::fabs(lower.z),
                                std::fabs(upper.x), std::fabs(upper.y), std::fabs(upper.z)}));
  });
  return !reaches.empty() && largest > 4 * median(reaches);
}

bool all_are_cylinders(const std::vector<Object<Cone>>& cones) {
  return std::all_of(cones.begin(), cones.end(), [](const Object<Cone>& object) {
    return object.shape.base_radius == object.shape.apex_radius;
  });
}

}  // namespace

Frame frame_of(const Scene& scene) {
  std::vector<double> x, y, z;
  each_sample(scene, [&](const Box& box) {
    x.push_back(box.lower.x / 2 + box.upper.x / 2);
    y.push_back(box.lower.y / 2 + box.upper.y / 2);
    z.push_back(box.lower.z / 2 + box.upper.z / 2);
  });
  if (x.empty()) return {};
  return Frame::around({median(x), median(y), median(z)}, bounds_of(scene));
}

template <class R>
std::uint64_t FrozenStore<R>::bytes() const {
  return (reals.size() + rows.size()) * sizeof(R) +
         (materials.size() + ids.size()) * sizeof(std::int32_t) +
         lights.size() * sizeof(FrozenLight<R>);
}

template <class R>
std::unique_ptr<FrozenStore<R>> freeze(const Scene& scene, const Profile& profile,
                                       const Frame& frame) {
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
  const ChosenKinds chosen{has_ground_sphere(scene, frame), all_are_cylinders(scene.cones)};
  std::size_t reals = scene.materials.size() * kMaterialReals;
#define ZRAKA_COUNT(Type, plural)                                      \
  reals += (objects_as<Type>(scene, chosen).size() + kColumnPadding) * \
           static_cast<std::size_t>(ShapeTraits<Type>::kReals);
  ZRAKA_KINDS(ZRAKA_COUNT)
#undef ZRAKA_COUNT
  store->materials.resize(scene.shape_count() + kKinds * kColumnPadding);
  store->reals.resize(reals);
  R* real = store->reals.data();
  std::int32_t* material = store->materials.data();

  frozen.materials = real;
  for (const Material& one : scene.materials) {
    freeze_material(one, profile, real);
    real += kMaterialReals;
  }

  std::int32_t first_slot = 0;
  const auto freeze_shapes = [&]<class Shape>(const auto& objects, FrozenShapes<R, Shape>& out) {
    using Traits = ShapeTraits<Shape>;
    const std::size_t room = objects.size() + kColumnPadding;
    R* column[Traits::kReals];
    for (int k = 0; k < Traits::kReals; ++k, real += room) {
      out.column[k] = column[k] = real;
      std::fill_n(real + objects.size(), kColumnPadding, R(0));
    }
    out.material = material;
    std::fill_n(material + objects.size(), kColumnPadding, 0);
    out.count = static_cast<std::int32_t>(objects.size());
    out.first_slot = first_slot;
    out.first_id = first_id_of<Shape>(scene);
    first_slot += out.count;
    in_parallel(objects.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        double numbers[Traits::kReals];
        Traits::freeze(objects[i].shape, frame, numbers);
        for (int k = 0; k < Traits::kReals; ++k) column[k][i] = narrow<R>(numbers[k]);
        material[i] = static_cast<std::int32_t>(objects[i].material);
      }
    });
    material += room;
  };
#define ZRAKA_FREEZE(Type, plural) freeze_shapes(objects_as<Type>(scene, chosen), frozen.plural);
  ZRAKA_KINDS(ZRAKA_FREEZE)
#undef ZRAKA_FREEZE
  return store;
}

template std::uint64_t FrozenStore<float>::bytes() const;
template std::uint64_t FrozenStore<double>::bytes() const;
template std::unique_ptr<FrozenStore<float>> freeze<float>(const Scene&, const Profile&,
                                                           const Frame&);
template std::unique_ptr<FrozenStore<double>> freeze<double>(const Scene&, const Profile&,
                                                             const Frame&);

}  // namespace zraka
