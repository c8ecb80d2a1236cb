// SPDX-License-Identifier: Apache-2.0
// A frozen scene and its hierarchy: the boxes that it is built from, and the order that it gives.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <type_traits>

#include "core/in_parallel.hpp"
#include "scene/freeze.hpp"
#include "scene/narrow.hpp"
#include "scene/reals.hpp"

namespace zraka {

template <class R>
std::vector<std::int32_t> kind_starts_of(const FrozenScene<R>& scene) {
  std::vector<std::int32_t> starts;
  std::int32_t end = 0;
  const auto add = [&](const auto& shapes) {
    starts.push_back(shapes.first_slot);
    end = shapes.first_slot + shapes.count;
  };
#define ZRAKA_ADD(Type, plural) add(scene.plural);
  ZRAKA_INLINED_KINDS(ZRAKA_ADD)
#undef ZRAKA_ADD
  starts.push_back(end);
  if (scene.bodies.count == 0) return starts;
  starts.push_back(end + scene.bodies.bounded);
  return starts;
}

namespace {

BuildRef ref_of(const Bounds& box, double margin, std::int32_t slot) {
  return {{narrow<float>(box.lower.x - margin), narrow<float>(box.lower.y - margin),
           narrow<float>(box.lower.z - margin)},
          {narrow<float>(box.upper.x + margin), narrow<float>(box.upper.y + margin),
           narrow<float>(box.upper.z + margin)},
          slot};
}

}  // namespace

template <class R>
void refer_to(const FrozenScene<R>& scene, BuildRef* refs) {
  // Intersections err by a few units in the last place of the numbers that they are made of:
  // coordinates in the scene, mostly at most 1 in this frame, and the eye's. A third of the margin
  // is theirs (hit_margin()), the rest is more than rounding in the test of a box takes. It is less
  // than what shadow rays from a large flat shape start off its surface, so that they leave its box
  // at once.
  const V3<R>& eye = scene.camera.eye;
  const double margin =
      0x3p-22 *
      (static_cast<double>(scene.reach) +
       static_cast<double>(std::max({std::fabs(eye.x), std::fabs(eye.y), std::fabs(eye.z)}) +
                           scene.camera.beyond));
  const auto refer = [&]<class Shape>(const FrozenShapes<R, Shape>& shapes) {
    using Traits = ShapeTraits<Shape>;
    in_parallel(static_cast<std::size_t>(shapes.count), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        double numbers[Traits::kHitReals];
        for (int k = 0; k < Traits::kHitReals; ++k)
          numbers[k] = static_cast<double>(shapes.column[k][i]);
        const Bounds box = Traits::frozen_bounds(numbers);
        const std::int32_t slot = shapes.first_slot + static_cast<std::int32_t>(i);
        refs[slot] = ref_of(box, margin, slot);
      }
    });
  };
#define ZRAKA_REFER(Type, plural) refer(scene.plural);
  ZRAKA_INLINED_KINDS(ZRAKA_REFER)
#undef ZRAKA_REFER
  for (std::int32_t i = 0; i < scene.bodies.bounded; ++i) {
    const Bounds& box = scene.bodies.bounds[i];
    const std::int32_t slot = scene.bodies.first_slot + i;
    refs[slot] = ref_of(box, margin, slot);
  }
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
  ZRAKA_INLINED_KINDS(ZRAKA_COUNT)
#undef ZRAKA_COUNT
  store.rows.resize(static_cast<std::size_t>(reals));
  R* row = store.rows.data();
  const auto add = [&]<class Shape>(FrozenShapes<R, Shape>& shapes) {
    shapes.rows = row;
    for (std::int32_t i = 0; i < shapes.count; ++i, row += shapes.kRowReals)
      for (int k = 0; k < shapes.kRowReals; ++k)
        row[k] = k < ShapeTraits<Shape>::kHitReals ? shapes.column[k][i] : R(0);
  };
#define ZRAKA_ADD(Type, plural) add(scene.plural);
  ZRAKA_INLINED_KINDS(ZRAKA_ADD)
#undef ZRAKA_ADD
}

}  // namespace

template <class R>
void reorder_by_leaf(FrozenStore<R>& store, const BuiltHierarchy& hierarchy) {
  FrozenScene<R>& scene = store.scene;
  scene.hierarchy = {hierarchy.nodes.empty() ? nullptr : hierarchy.nodes.data(),
                     static_cast<std::int32_t>(hierarchy.nodes.size()),
                     hierarchy.rank.empty() ? nullptr : hierarchy.rank.data()};
  store.ids.resize(store.materials.size());
  std::int32_t* id = store.ids.data();
  const auto reorder_shapes = [&]<class Shape>(FrozenShapes<R, Shape>& shapes,
                                               const std::vector<std::int32_t>& parents) {
    const auto count = static_cast<std::size_t>(shapes.count);
    const std::int32_t* order =
        hierarchy.order.empty() ? nullptr : hierarchy.order.data() + shapes.first_slot;
    shapes.id = id;
    const std::size_t read = count - parents.size();
    in_parallel(count, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const std::int32_t before =
            order == nullptr ? static_cast<std::int32_t>(i) : order[i] - shapes.first_slot;
        id[i] = before + shapes.first_id;
        if (const auto at = static_cast<std::size_t>(before); at >= read)
          id[i] = parents[at - read] + shapes.first_id;
      }
    });
    std::fill_n(id + count, kColumnPadding, 0);
    id += count + kColumnPadding;
    if (order == nullptr) return;
    // One array for what stood there before, column after column: to touch new memory for the first
    // time takes longer than to copy into it.
    const auto memory_before =
        std::make_unique_for_overwrite<std::byte[]>(count * std::max(sizeof(R), sizeof(*id)));
    const auto reorder = [&]<class T>(const T* column, UnsetVector<T>& memory) {
      auto* const before = reinterpret_cast<T*>(memory_before.get());
      T* const after = memory.data() + (column - memory.data());
      in_parallel(count, [&](std::size_t begin, std::size_t end) {
        std::copy(column + begin, column + end, before + begin);
      });
      in_parallel(count, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
          after[i] = before[static_cast<std::size_t>(order[i] - shapes.first_slot)];
      });
    };
    for (const R* column : shapes.column) reorder(column, store.reals);
    reorder(shapes.material, store.materials);
  };
#define ZRAKA_REORDER(Type, plural) reorder_shapes(scene.plural, store.parents[kKindOf##Type]);
  ZRAKA_INLINED_KINDS(ZRAKA_REORDER)
#undef ZRAKA_REORDER
  reorder_bodies(
      hierarchy.order.empty() ? nullptr : hierarchy.order.data() + scene.bodies.first_slot,
      store.bodies, scene.bodies);
  if (std::is_same_v<R, float> && !hierarchy.order.empty() &&
      hierarchy.order.size() < kTooManyForRows)
    add_rows(store);
}

#define ZRAKA_FOR(R)                                                        \
  template std::vector<std::int32_t> kind_starts_of(const FrozenScene<R>&); \
  template void refer_to(const FrozenScene<R>&, BuildRef*);                 \
  template void reorder_by_leaf(FrozenStore<R>&, const BuiltHierarchy&);
ZRAKA_FOR_REALS(ZRAKA_FOR)
#undef ZRAKA_FOR

}  // namespace zraka
