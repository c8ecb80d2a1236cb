// SPDX-License-Identifier: Apache-2.0
// From the scene as read to the scene as traced: into the engine's frame in double, then narrowed.
#include "scene/freeze.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "core/handover.hpp"

namespace zraka {
namespace {

/// The nearest value of R, the largest one for what is out of its range.
template <class R>
R narrow(double v) {
  constexpr double kLargest = std::numeric_limits<R>::max();
  return static_cast<R>(std::clamp(v, -kLargest, kLargest));
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

Box bounds_of(const Scene& scene) {
  Box bounds;
  const auto include = [&]<class Shape>(const std::vector<Object<Shape>>& objects) {
    using Iterator = typename std::vector<Object<Shape>>::const_iterator;
    Handover handover;
    handover.give();
    bounds.include(tbb::parallel_reduce(
        tbb::blocked_range<Iterator>(objects.begin(), objects.end(), 65536), Box(),
        [&](const tbb::blocked_range<Iterator>& part, Box sum) {
          handover.take();
          for (const Object<Shape>& object : part)
            sum.include(ShapeTraits<Shape>::bounds(object.shape));
          handover.give();
          return sum;
        },
        [](Box a, const Box& b) {
          a.include(b);
          return a;
        }));
    handover.take();
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

/// The place of the kind's first shape in the scene as it was read.
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

/// function(begin, end) for parts of [0, count), by all threads.
template <class Function>
void in_parallel(std::size_t count, const Function& function) {
  constexpr std::size_t kPart = 16384;
  if (count <= kPart) return function(std::size_t{0}, count);
  Handover to_tasks, from_tasks;
  to_tasks.give();
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, kPart),
                    [&](const tbb::blocked_range<std::size_t>& part) {
                      to_tasks.take();
                      function(part.begin(), part.end());
                      from_tasks.give();
                    });
  from_tasks.take();
}

/// Is there a sphere so large beside most shapes that they need their digits where it passes them?
bool has_ground_sphere(const Scene& scene, const Frame& frame) {
  double largest = 0;
  for (const Object<Sphere>& object : scene.spheres)
    largest = std::max(largest, frame.length(object.shape.radius));
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
    for (int k = 0; k < Traits::kReals; ++k, real += room) out.column[k] = column[k] = real;
    out.material = material;
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

template <class R>
std::vector<std::int32_t> kind_starts_of(const FrozenScene<R>& scene) {
  std::vector<std::int32_t> starts;
  std::int32_t end = 0;
  const auto add = [&](const auto& shapes) {
    starts.push_back(shapes.first_slot);
    end = shapes.first_slot + shapes.count;
  };
#define ZRAKA_ADD(Type, plural) add(scene.plural);
  ZRAKA_KINDS(ZRAKA_ADD)
#undef ZRAKA_ADD
  starts.push_back(end);
  return starts;
}

template <class R>
void refer_to(const FrozenScene<R>& scene, BuildRef* refs) {
  // Intersections err by a few units in the last place of the numbers that they are made of:
  // coordinates in the scene, at most 1 in this frame, and the eye's. A third of the margin is
  // theirs (hit_margin()), the rest is more than rounding in the test of a box takes. It is less
  // than what feelers from a large flat shape start off its surface, so that they leave its box at
  // once.
  const V3<R>& eye = scene.camera.eye;
  const double margin =
      0x3p-22 *
      (1 + static_cast<double>(std::max({std::fabs(eye.x), std::fabs(eye.y), std::fabs(eye.z)})));
  const auto refer = [&]<class Shape>(const FrozenShapes<R, Shape>& shapes) {
    using Traits = ShapeTraits<Shape>;
    in_parallel(static_cast<std::size_t>(shapes.count), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        double numbers[Traits::kHitReals];
        for (int k = 0; k < Traits::kHitReals; ++k)
          numbers[k] = static_cast<double>(shapes.column[k][i]);
        const Box box = Traits::frozen_bounds(numbers);
        const std::int32_t slot = shapes.first_slot + static_cast<std::int32_t>(i);
        refs[slot] = {{narrow<float>(box.lower.x - margin), narrow<float>(box.lower.y - margin),
                       narrow<float>(box.lower.z - margin)},
                      {narrow<float>(box.upper.x + margin), narrow<float>(box.upper.y + margin),
                       narrow<float>(box.upper.z + margin)},
                      slot};
      }
    });
  };
#define ZRAKA_REFER(Type, plural) refer(scene.plural);
  ZRAKA_KINDS(ZRAKA_REFER)
#undef ZRAKA_REFER
}

namespace {

/// From here on rows take longer to make than they save; where all shapes are of one kind, leaves
/// are full and make no pairs.
constexpr std::size_t kTooManyForRows = std::size_t{1} << 16;

/// What FrozenShapes::rows says, for all kinds.
template <class R>
void add_rows(FrozenStore<R>& store) {
  FrozenScene<R>& scene = store.scene;
  std::int32_t reals = 0;
#define ZRAKA_COUNT(Type, plural) reals += scene.plural.count * scene.plural.kRowReals;
  ZRAKA_KINDS(ZRAKA_COUNT)
#undef ZRAKA_COUNT
  store.rows.resize(static_cast<std::size_t>(reals));
  R* row = store.rows.data();
  const auto add = [&]<class Shape>(FrozenShapes<R, Shape>& shapes) {
    shapes.rows = row;
    for (std::int32_t i = 0; i < shapes.count; ++i, row += shapes.kRowReals)
      for (int k = 0; k < ShapeTraits<Shape>::kHitReals; ++k) row[k] = shapes.column[k][i];
  };
#define ZRAKA_ADD(Type, plural) add(scene.plural);
  ZRAKA_KINDS(ZRAKA_ADD)
#undef ZRAKA_ADD
}

}  // namespace

template <class R>
void finish(FrozenStore<R>& store, const BuiltHierarchy& hierarchy) {
  FrozenScene<R>& scene = store.scene;
  scene.hierarchy = {hierarchy.nodes.empty() ? nullptr : hierarchy.nodes.data(),
                     static_cast<std::int32_t>(hierarchy.nodes.size()),
                     hierarchy.place.empty() ? nullptr : hierarchy.place.data()};
  store.ids.resize(store.materials.size());
  std::int32_t* id = store.ids.data();
  const auto finish_shapes = [&]<class Shape>(FrozenShapes<R, Shape>& shapes) {
    const auto count = static_cast<std::size_t>(shapes.count);
    const std::int32_t* order =
        hierarchy.order.empty() ? nullptr : hierarchy.order.data() + shapes.first_slot;
    shapes.id = id;
    const std::int32_t to_id = shapes.first_id - shapes.first_slot;
    in_parallel(count, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        id[i] =
            order == nullptr ? shapes.first_id + static_cast<std::int32_t>(i) : order[i] + to_id;
    });
    id += count + kColumnPadding;
    if (order == nullptr) return;
    const auto reorder = [&]<class T>(const T* column, std::vector<T>& memory) {
      const std::vector<T> before(column, column + count);
      T* after = memory.data() + (column - memory.data());
      in_parallel(count, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
          after[i] = before[static_cast<std::size_t>(order[i] - shapes.first_slot)];
      });
    };
    for (const R* column : shapes.column) reorder(column, store.reals);
    reorder(shapes.material, store.materials);
  };
#define ZRAKA_FINISH(Type, plural) finish_shapes(scene.plural);
  ZRAKA_KINDS(ZRAKA_FINISH)
#undef ZRAKA_FINISH
  if (std::is_same_v<R, float> && !hierarchy.order.empty() &&
      hierarchy.order.size() < kTooManyForRows)
    add_rows(store);
}

template std::uint64_t FrozenStore<float>::bytes() const;
template std::uint64_t FrozenStore<double>::bytes() const;
template std::unique_ptr<FrozenStore<float>> freeze<float>(const Scene&, const Profile&,
                                                           const Frame&);
template std::unique_ptr<FrozenStore<double>> freeze<double>(const Scene&, const Profile&,
                                                             const Frame&);
template std::vector<std::int32_t> kind_starts_of(const FrozenScene<float>&);
template std::vector<std::int32_t> kind_starts_of(const FrozenScene<double>&);
template void refer_to(const FrozenScene<float>&, BuildRef*);
template void refer_to(const FrozenScene<double>&, BuildRef*);
template void finish(FrozenStore<float>&, const BuiltHierarchy&);
template void finish(FrozenStore<double>&, const BuiltHierarchy&);

}  // namespace zraka
