// SPDX-License-Identifier: Apache-2.0
#include "scene/freeze_bodies.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "shapes/bodies/csg.hpp"

namespace zraka {
namespace {

Transform into_frame(const Frame& frame) {
  const double s = frame.scale;
  return {{s, 0, 0}, {0, s, 0}, {0, 0, s}, frame.point({})};
}
Transform out_of_frame(const Frame& frame) {
  const double s = 1 / frame.scale;
  return {{s, 0, 0}, {0, s, 0}, {0, 0, s}, frame.center};
}

template <class Shape>
constexpr BodyType type_of() {
#define ZRAKA_IF(Type, plural) \
  if constexpr (std::is_same_v<Shape, Type>) return kType##Type;
  ZRAKA_BODIES(ZRAKA_IF)
#undef ZRAKA_IF
}

/// One list of bodies while it is filled.
class Filling {
 public:
  Filling(const Whereabouts& where, const Frame& frame, const std::vector<GroupPlace>& groups,
          std::vector<Transform>& transforms, BodyStore& store)
      : where_(where), frame_(frame), groups_(groups), transforms_(transforms), store_(store) {}

  template <class Shape>
  void add(const Shape& shape, const Transform& to_world, std::uint32_t material,
           std::uint32_t transform) {
    store_.type.push_back(type_of<Shape>());
    store_.start.push_back(static_cast<std::int32_t>(store_.numbers.size()));
    store_.material.push_back(static_cast<std::int32_t>(material));
    store_.transform.push_back(static_cast<std::int32_t>(transform));
    put(shape, to_world);
  }

  /// Members of CSG come after all bodies that are drawn by themselves.
  void add_members() {
    for (std::size_t i = 0; i < open_.size(); ++i) {
      const Open open = open_[i];
      const auto body = static_cast<std::int32_t>(store_.type.size());
      std::visit(
          [&]<class Shape>(const Shape& shape) {
            if constexpr (!std::is_same_v<Shape, std::monostate> && !std::is_same_v<Shape, Csg>)
              add(shape, open.to_world, open.material, index_of(open.to_world));
          },
          open.member->body);
      store_.numbers[open.place] = body;
      put_reach(store_.numbers.data() + store_.start.back(), store_.numbers.data() + open.reach);
    }
  }

 private:
  /// As Object::transform.
  std::uint32_t index_of(const Transform& to_world) {
    if (to_world == Transform()) return 0;
    if (transforms_.empty() || !(transforms_.back() == to_world)) transforms_.push_back(to_world);
    return static_cast<std::uint32_t>(transforms_.size());
  }

  template <class Shape>
  void put(const Shape& shape, const Transform& to_world) {
    const Placement placement = ShapeTraits<Shape>::place(shape);
    put_map(then(placement.from_own, to_world));
    store_.numbers.insert(store_.numbers.end(), placement.numbers,
                          placement.numbers + ShapeTraits<Shape>::kNumbers);
  }
  void put(const Instance& instance, const Transform& to_world) {
    const GroupPlace& group = groups_[instance.group];
    put_map(then(out_of_frame(group.frame), to_world));
    store_.numbers.push_back(instance.group);
    store_.numbers.push_back(group.reach);
  }

  /// A member of CSG that has its place in the whole's numbers, but is not there yet.
  struct Open {
    const CsgMember* member;
    Transform to_world;
    std::uint32_t material;
    std::size_t place, reach;
  };
  /// CsgNumbers::stretch() and CsgNumbers::shift() of the member of these numbers.
  static void put_reach(const double* member, double* out) {
    const auto size = [&](int k) { return std::fabs(member[k]); };
    const auto row = [&](int k) { return size(k) + size(k + 1) + size(k + 2); };
    out[0] = std::max({row(kBodyMatrix), row(kBodyMatrix + 3), row(kBodyMatrix + 6)});
    out[1] = out[0] * std::max({size(kBodyCenter), size(kBodyCenter + 1), size(kBodyCenter + 2)});
  }
  void put(const Csg& csg, const Transform& to_world) {
    std::vector<Open> members;
    std::vector<double> steps;
    list(csg, to_world, kMaterialOfWhole, members, steps);
    store_.numbers.push_back(static_cast<double>(members.size()));
    store_.numbers.push_back(static_cast<double>(steps.size()));
    const int count = static_cast<int>(members.size()), length = static_cast<int>(steps.size());
    store_.numbers.push_back(std::bit_cast<double>(
        count <= kMostCsgTableMembers ? csg_table(steps.data(), length, count) : std::uint64_t{0}));
    const std::size_t first = store_.numbers.size();
    for (std::size_t i = 0; i < members.size(); ++i) {
      members[i].place = first + i;
      members[i].reach = first + members.size() + steps.size() + 2 * i;
      open_.push_back(members[i]);
    }
    store_.numbers.resize(first + members.size());
    store_.numbers.insert(store_.numbers.end(), steps.begin(), steps.end());
    store_.numbers.resize(store_.numbers.size() + 2 * members.size());
  }
  /// Operands before operations; members of members have their material where they have none.
  void list(const Csg& csg, const Transform& to_world, std::uint32_t material,
            std::vector<Open>& members, std::vector<double>& steps) {
    for (const CsgMember& member : csg.of) {
      const Transform all = then(where_.transform(member.transform), to_world);
      const std::uint32_t own =
          member.material == kMaterialOfWhole ? material : member.material;
      if (const Csg* const inner = std::get_if<Csg>(&member.body)) {
        list(*inner, all, own, members, steps);
      } else {
        steps.push_back(static_cast<double>(members.size()));
        members.push_back({&member, all, own, 0, 0});
      }
    }
    steps.push_back(csg_step(csg.operation, static_cast<int>(csg.of.size())));
  }

  void put_map(const Transform& own_to_world) {
    const Transform to_frame = then(own_to_world, into_frame(frame_));
    const Transform to_own = inverse(to_frame).value_or(Transform());
    for (const double number :
         {to_frame.origin.x, to_frame.origin.y, to_frame.origin.z, to_own.along_x.x,
          to_own.along_y.x, to_own.along_z.x, to_own.along_x.y, to_own.along_y.y,
          to_own.along_z.y, to_own.along_x.z, to_own.along_y.z, to_own.along_z.z})
      store_.numbers.push_back(number);
  }

  const Whereabouts& where_;
  const Frame& frame_;
  const std::vector<GroupPlace>& groups_;
  std::vector<Transform>& transforms_;
  BodyStore& store_;
  std::vector<Open> open_;
};

}  // namespace

std::uint64_t BodyStore::bytes() const {
  return type.size() + (start.size() + material.size() + transform.size() + id.size()) * 4 +
         numbers.size() * sizeof(double) + bounds.size() * sizeof(Bounds);
}

void freeze_bodies(const ShapeLists& shapes, const Whereabouts& where, const Frame& frame,
                   const std::vector<GroupPlace>& groups, std::int32_t first_id,
                   std::vector<Transform>& transforms, BodyStore& store, FrozenBodies& out) {
  Filling filling(where, frame, groups, transforms, store);
  // Those that have no bounds after the others.
  for (const bool bounded : {true, false}) {
    std::int32_t id = first_id;
    const auto add = [&](const auto& objects) {
      for (const auto& object : objects) {
        const Bounds box = where.bounds(object);
        const std::int32_t own_id = id++;
        if (box.bounded() != bounded) continue;
        store.id.push_back(own_id);
        filling.add(object.shape, where.transform(object.transform), object.material,
                    object.transform);
        if (bounded) store.bounds.push_back({frame.point(box.lower), frame.point(box.upper)});
      }
    };
#define ZRAKA_ADD(Type, plural) add(shapes.plural);
    ZRAKA_BODIES(ZRAKA_ADD)
#undef ZRAKA_ADD
    if (bounded) out.bounded = static_cast<std::int32_t>(store.type.size());
  }
  out.count = static_cast<std::int32_t>(store.type.size());
  out.first_id = first_id;
  filling.add_members();
  out.type = store.type.data();
  out.start = store.start.data();
  out.numbers = store.numbers.data();
  out.material = store.material.data();
  out.transform = store.transform.data();
  out.id = store.id.data();
  out.bounds = store.bounds.data();
}

void reorder_bodies(const std::int32_t* order, BodyStore& store, FrozenBodies& out) {
  if (order == nullptr) return;
  store.bounds = {};
  out.bounds = nullptr;
  const auto bounded = static_cast<std::size_t>(out.bounded);
  const auto reorder = [&](auto& column) {
    const auto before = column;
    for (std::size_t i = 0; i < bounded; ++i)
      column[i] = before[static_cast<std::size_t>(order[i] - out.first_slot)];
  };
  const std::vector<std::int32_t> start_before = store.start;
  reorder(store.type), reorder(store.material), reorder(store.transform), reorder(store.id);
  // Numbers follow, so that those of neighbours are neighbours: they stood one after the other in
  // the order of their bodies.
  const std::vector<double> before = std::move(store.numbers);
  store.numbers.clear();
  store.numbers.reserve(before.size());
  for (std::size_t i = 0; i < store.type.size(); ++i) {
    const std::size_t was =
        i < bounded ? static_cast<std::size_t>(order[i] - out.first_slot) : i;
    const auto begin = static_cast<std::size_t>(start_before[was]),
               end = was + 1 < start_before.size() ? static_cast<std::size_t>(start_before[was + 1])
                                                   : before.size();
    store.start[i] = static_cast<std::int32_t>(store.numbers.size());
    store.numbers.insert(store.numbers.end(), before.begin() + static_cast<std::ptrdiff_t>(begin),
                         before.begin() + static_cast<std::ptrdiff_t>(end));
  }
  out.numbers = store.numbers.data();
}

}  // namespace zraka
