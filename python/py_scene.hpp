// SPDX-License-Identifier: Apache-2.0
// A scene of Python's: many spheres stay in the arrays that they came in, until a picture of them
// is wanted.
#pragma once

#include <atomic>
#include <vector>

#include "arguments.hpp"

namespace zraka::python {

/// Fewer spheres are copied at once.
inline constexpr py::ssize_t kKeptFrom = 100'000;

/// Arrays of spheres and who owns their memory.
struct KeptSpheres {
  SphereArrays arrays;
  py::array centers, radii, colors;
  std::size_t spheres_before;  ///< of those that were copied
  std::uint64_t fingerprint;
};

struct PyScene {
  Scene scene{};  ///< what is not kept below
  std::vector<KeptSpheres> kept{};

  /// Takes arrays that check_spheres() finds nothing wrong with.
  void keep(const SphereArrays& arrays, py::array centers, py::array radii, py::array colors);
  std::uint64_t shape_count() const;
  /// The scene with all its spheres. Fails where kept arrays were changed. Needs no lock of
  /// Python's.
  Result<Scene> whole(const std::atomic<bool>* cancel = nullptr) const;
  /// What work(scene) returns, of the whole scene; where that is a copy, work has it for itself.
  template <class Work>
  auto with_whole(const std::atomic<bool>* cancel, const Work& work) const
      -> decltype(work(std::declval<const Scene&>())) {
    if (kept.empty()) return work(scene);
    Result<Scene> all = whole(cancel);
    if (!all) return tl::make_unexpected(std::move(all.error()));
    return work(std::move(*all));
  }
};

}  // namespace zraka::python
