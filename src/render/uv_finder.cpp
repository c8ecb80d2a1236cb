// SPDX-License-Identifier: Apache-2.0
#include "render/uv_finder.hpp"

#include <algorithm>
#include <type_traits>

#include "accel/body_surface.hpp"
#include "scene/bounds_of.hpp"
#include "scene/narrow.hpp"
#include "scene/pieces.hpp"
#include "scene/reals.hpp"
#include "shapes/primitive_uv.hpp"

namespace zraka {
namespace {

/// The objects that shapes of this kind were read as.
template <class Shape>
const auto& objects_of(const ShapeLists& shapes) {
#define ZRAKA_IF(Type, plural)                  \
  if constexpr (std::is_base_of_v<Type, Shape>) \
    return shapes.plural;                       \
  else
  ZRAKA_PRIMITIVES(ZRAKA_IF)
#undef ZRAKA_IF
  return shapes.spheres;
}

/// Texture coordinates of a triangle's corners; nullptr where it has none.
template <class Shape>
const CornerUvs* corner_uvs(const ShapeLists& shapes, std::size_t index) {
  const std::vector<CornerUvs>* all = nullptr;
  if constexpr (std::is_same_v<Shape, Triangle>) all = &shapes.triangle_uvs;
  if constexpr (std::is_same_v<Shape, SmoothTriangle>) all = &shapes.smooth_triangle_uvs;
  return all == nullptr || all->empty() ? nullptr : &(*all)[index];
}

}  // namespace

template <class R>
UvFinder<R>::UvFinder(const Scene& scene, const FrozenStore<R>& store)
    : scene_(scene), store_(store) {
  for (const Transform& t : scene.transforms) to_shape_.push_back(inverse(t).value_or(Transform()));
}

template <class R>
template <class Shape>
bool UvFinder<R>::find(const Home& home, const FrozenShapes<R, Shape>& kind, std::int32_t slot,
                       const V3<double>& point, std::array<double, 2>& uv) const {
  const std::int32_t at = slot - kind.first_slot;
  if (at < 0 || at >= kind.count) return false;
  const auto index = static_cast<std::size_t>(kind.id[at] - kind.first_id);
  const auto& object = objects_of<Shape>(home.shapes)[index];
  Numbers<Shape> numbers;
  for (std::size_t k = 0; k < numbers.size(); ++k)
    numbers[k] = static_cast<double>(kind.column[k][at]);

  UvContext context;
  context.uvs = corner_uvs<Shape>(home.shapes, index);
  if (object.transform != 0) {
    const Transform& t = to_shape_[object.transform - 1];
    const double scale = 1 / home.frozen.frame_scale;
    context.x = vector_of(t.along_x) * scale;
    context.y = vector_of(t.along_y) * scale;
    context.z = vector_of(t.along_z) * scale;
  }
  Numbers<Shape> whole;
  if constexpr (kHasPieces<Shape>) {
    const Frame frame{.center = home.frozen.frame_center, .scale = home.frozen.frame_scale};
    ShapeTraits<Shape>::freeze(object.shape, frame, whole.data());
    const bool is_piece =
        !std::equal(whole.begin(), whole.begin() + 9, numbers.begin(),
                    [](double w, double n) { return static_cast<double>(narrow<R>(w)) == n; });
    if (is_piece) context.whole_corners = whole.data();
  }
  const BodySurface surface =
      uv_of(static_cast<const Shape*>(nullptr), numbers.data(), point, context);
  uv = {surface.u, surface.v};
  return true;
}

template <class R>
std::array<double, 2> UvFinder<R>::at(const HitPath& path, const V3<double>& point) const {
  const auto* const group = static_cast<const FrozenScene<R>*>(path.group);
  V3<double> in_home = point;
  if (group != nullptr) {
    const double(&m)[12] = path.to_frame;
    const Transform from_group{
        {m[0], m[1], m[2]}, {m[3], m[4], m[5]}, {m[6], m[7], m[8]}, {m[9], m[10], m[11]}};
    in_home = vector_of(moved(vec3_of(point), inverse(from_group).value_or(Transform())));
  }
  const Home home =
      group == nullptr
          ? Home{scene_, store_.scene}
          : Home{scene_.groups[static_cast<std::size_t>(group - store_.groups.data())], *group};
  std::array<double, 2> uv{};
#define ZRAKA_FIND(Type, plural) \
  if (find(home, home.frozen.plural, path.slot, in_home, uv)) return uv;
  ZRAKA_INLINED_KINDS(ZRAKA_FIND)
#undef ZRAKA_FIND
  const BodySurface on = isa_oracle::on_body(home.frozen.bodies, path.body, in_home);
  return {on.u, on.v};
}

#define ZRAKA_FOR(R) template class UvFinder<R>;
ZRAKA_FOR_REALS(ZRAKA_FOR)
#undef ZRAKA_FOR

}  // namespace zraka
