// SPDX-License-Identifier: Apache-2.0
#include "scene/bulk.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <new>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "core/in_parallel.hpp"

namespace zraka {
namespace {

template <int N>
std::array<double, N> item_of(const NumberArray<N>& numbers, std::size_t index) {
  const auto* at =
      static_cast<const char*>(numbers.data) + static_cast<std::ptrdiff_t>(index) * numbers.stride;
  std::array<double, N> item;
  for (double& number : item) {
    // Of any alignment.
    if (numbers.is_double) {
      std::memcpy(&number, at, sizeof number);
    } else {
      float narrow = 0;
      std::memcpy(&narrow, at, sizeof narrow);
      number = static_cast<double>(narrow);
    }
    at += numbers.step;
  }
  return item;
}

Vec3 point_of(const NumberArray<3>& numbers, std::size_t index) {
  const std::array<double, 3> p = item_of(numbers, index);
  return {p[0], p[1], p[2]};
}

/// So many items are a piece of work for a thread.
constexpr std::size_t kPiece = 32768;

/// Whether a number is finite and at least, or more than, `least`.
bool is_good(double number, double least, bool more) {
  return std::isfinite(number) && (number > least || (!more && number == least));
}

template <int N>
bool are_good(const NumberArray<N>& numbers, double least, bool more) {
  std::atomic<bool> good{true};
  in_parallel(
      numbers.count,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
          for (const double number : item_of(numbers, i))
            if (!is_good(number, least, more)) return good.store(false, std::memory_order_relaxed);
      },
      kPiece);
  return good;
}

/// What is wrong with the arrays of one kind of shape.
class Checker {
 public:
  explicit Checker(std::size_t count) : count_(count) {}

  /// All numbers of an array have to be at least, or more than, `least`.
  template <int N>
  void check(std::string_view name, const NumberArray<N>& numbers, double least, bool more,
             std::string_view expected) {
    if (numbers.count != count_)
      return complain(fmt::format("{} has {} items: expected {}, one for each shape", name,
                                  numbers.count, count_));
    if (numbers.count > 0 && numbers.data == nullptr)
      return complain(fmt::format("{} has no memory: its data is a null pointer", name));
    if (are_good(numbers, least, more)) return;
    for (std::size_t i = 0; i < count_; ++i) {
      const std::array<double, N> item = item_of(numbers, i);
      for (std::size_t k = 0; k < N; ++k) {
        if (is_good(item[k], least, more)) continue;
        const std::string at =
            N == 1 ? fmt::format("{}[{}]", name, i) : fmt::format("{}[{}, {}]", name, i, k);
        return complain(fmt::format("{} is {}: expected {}", at, item[k], expected));
      }
    }
  }
  void points(std::string_view name, const NumberArray<3>& numbers) {
    check(name, numbers, -std::numeric_limits<double>::infinity(), true, "a finite number");
  }
  void radii(const NumberArray<1>& numbers, double radius) {
    if (numbers.data != nullptr || numbers.count > 0)
      check("radii", numbers, 0, true, "a finite number greater than 0");
    else if (!(radius > 0 && std::isfinite(radius)))
      complain(fmt::format("radius is {}: expected a finite number greater than 0", radius));
  }
  void materials(const Scene& scene, const BulkMaterial& bulk) {
    if (bulk.material >= scene.materials.size())
      complain(fmt::format("material is {}: the scene has {} materials, counted from 0",
                           bulk.material, scene.materials.size()));
    if (bulk.colors.data != nullptr || bulk.colors.count > 0)
      check("colors", bulk.colors, 0, false, "a finite number, 0 or more");
  }
  Result<void> result() {
    if (problems_.empty()) return {};
    return tl::make_unexpected(std::move(problems_));
  }

 private:
  void complain(std::string message) { problems_.push_back({.message = std::move(message)}); }

  std::size_t count_;
  Diagnostics problems_;
};

/// The material of each shape: one for each colour that differs.
class Tints {
 public:
  Tints(Scene& scene, const BulkMaterial& bulk) : scene_(scene), bulk_(bulk) {}
  std::uint32_t of(std::size_t index) {
    if (bulk_.colors.count == 0) return bulk_.material;
    const std::array<double, 3> color = item_of(bulk_.colors, index);
    // Neighbours often are of one colour.
    if (last_ != 0 && color == last_color_) return last_;
    last_color_ = color;
    const auto next = static_cast<std::uint32_t>(scene_.materials.size());
    const auto [found, is_new] = by_color_.try_emplace(color, next);
    if (is_new) {
      Material material = scene_.materials[bulk_.material];
      const auto tint = [&](Color& c) { c = {c.r * color[0], c.g * color[1], c.b * color[2]}; };
      tint(material.ambient);
      tint(material.diffuse);
      scene_.materials.push_back(std::move(material));
    }
    return last_ = found->second;
  }

 private:
  Scene& scene_;
  const BulkMaterial& bulk_;
  std::map<std::array<double, 3>, std::uint32_t> by_color_;
  std::array<double, 3> last_color_{};
  std::uint32_t last_ = 0;
};

/// So many shapes are added in less than a millisecond.
constexpr std::size_t kBetweenLooks = 16384;

/// Adds shape(i) for each index, or nothing where memory is not enough.
template <class Shape, class Make>
Result<void> add_all(Scene& scene, std::vector<Object<Shape>>& shapes, std::size_t count,
                     const BulkMaterial& bulk, const Make& make,
                     const std::atomic<bool>* cancel = nullptr) {
  const std::size_t shapes_before = shapes.size(), materials_before = scene.materials.size();
  try {
    shapes.reserve(shapes_before + count);
    Tints tints(scene, bulk);
    for (std::size_t i = 0; i < count; ++i) {
      if (i % kBetweenLooks == 0 && cancel != nullptr && cancel->load(std::memory_order_relaxed))
        break;
      shapes.push_back({make(i), tints.of(i)});
    }
    return {};
  } catch (const std::bad_alloc&) {
  } catch (const std::length_error&) {
  }
  shapes.resize(shapes_before);
  scene.materials.resize(materials_before);
  return failure("", fmt::format("not enough memory for {} shapes more", count));
}

}  // namespace

Result<void> check_spheres(const Scene& scene, const SphereArrays& arrays) {
  Checker checker(arrays.centers.count);
  checker.points("centers", arrays.centers);
  checker.radii(arrays.radii, arrays.radius);
  checker.materials(scene, arrays);
  return checker.result();
}

Result<void> add_checked_spheres(Scene& scene, const SphereArrays& arrays,
                                 const std::atomic<bool>* cancel) {
  const auto sphere = [&](std::size_t i) {
    return Sphere{point_of(arrays.centers, i),
                  arrays.radii.count > 0 ? item_of(arrays.radii, i)[0] : arrays.radius};
  };
  return add_all(scene, scene.spheres, arrays.centers.count, arrays, sphere, cancel);
}

std::uint64_t fingerprint(const SphereArrays& arrays) {
  // A step of Fowler, Noll and Vo's, of 64 bits at once.
  const auto mixed = [](std::uint64_t sum, std::uint64_t more) {
    return (sum ^ more) * 0x100000001b3;
  };
  std::uint64_t sum = 0;
  const auto add = [&](const auto& numbers) {
    std::vector<std::uint64_t> pieces((numbers.count + kPiece - 1) / kPiece);
    in_parallel(
        pieces.size(),
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t p = begin; p < end; ++p)
            for (std::size_t i = p * kPiece; i < std::min((p + 1) * kPiece, numbers.count); ++i)
              for (const double number : item_of(numbers, i))
                pieces[p] = mixed(pieces[p], std::bit_cast<std::uint64_t>(number));
        },
        1);
    for (const std::uint64_t piece : pieces) sum = mixed(sum, piece);
  };
  add(arrays.centers);
  add(arrays.radii);
  add(arrays.colors);
  return sum;
}

Result<void> add_spheres(Scene& scene, const SphereArrays& arrays) {
  if (Result<void> good = check_spheres(scene, arrays); !good) return good;
  return add_checked_spheres(scene, arrays);
}

Result<void> add_cylinders(Scene& scene, const CylinderArrays& arrays) {
  Checker checker(arrays.starts.count);
  checker.points("starts", arrays.starts);
  checker.points("ends", arrays.ends);
  checker.radii(arrays.radii, arrays.radius);
  checker.materials(scene, arrays);
  if (Result<void> good = checker.result(); !good) return good;
  for (std::size_t i = 0; i < arrays.starts.count; ++i)
    if (point_of(arrays.starts, i) == point_of(arrays.ends, i))
      return failure("",
                     fmt::format("ends[{}] is where starts[{}] is: a cylinder has a length", i, i));
  return add_all(scene, scene.cones, arrays.starts.count, arrays, [&](std::size_t i) {
    const double radius = arrays.radii.count > 0 ? item_of(arrays.radii, i)[0] : arrays.radius;
    return Cone{point_of(arrays.starts, i), radius, point_of(arrays.ends, i), radius};
  });
}

Result<void> add_triangles(Scene& scene, const TriangleArrays& arrays) {
  Checker checker(arrays.a.count);
  checker.points("a", arrays.a);
  checker.points("b", arrays.b);
  checker.points("c", arrays.c);
  checker.materials(scene, arrays);
  if (Result<void> good = checker.result(); !good) return good;
  Result<void> added = add_all(scene, scene.triangles, arrays.a.count, arrays, [&](std::size_t i) {
    return Triangle{point_of(arrays.a, i), point_of(arrays.b, i), point_of(arrays.c, i)};
  });
  if (added && !scene.triangle_uvs.empty()) scene.triangle_uvs.resize(scene.triangles.size());
  return added;
}

}  // namespace zraka
