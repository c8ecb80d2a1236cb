// SPDX-License-Identifier: Apache-2.0
#include "py_scene.hpp"

#include <fmt/format.h>

#include <new>
#include <utility>

#include "scene/bulk.hpp"

namespace zraka::python {

void PyScene::keep(const SphereArrays& arrays, py::array centers, py::array radii,
                   py::array colors) {
  kept.push_back({arrays, std::move(centers), std::move(radii), std::move(colors),
                  scene.spheres.size(), fingerprint(arrays)});
}

std::uint64_t PyScene::shape_count() const {
  std::uint64_t count = scene.shape_count();
  for (const KeptSpheres& spheres : kept) count += spheres.arrays.centers.count;
  return count;
}

Result<Scene> PyScene::whole(const std::atomic<bool>* cancel) const {
  for (const KeptSpheres& spheres : kept)
    if (fingerprint(spheres.arrays) != spheres.fingerprint)
      return failure(
          "",
          fmt::format("centers, radii or colors of {} spheres were changed after they "
                      "had been added to the scene, which keeps large arrays as they are",
                      spheres.arrays.centers.count),
          "add a copy: scene.spheres(centers.copy(), …)");
  Scene all = scene;
  all.spheres.clear();
  try {
    all.spheres.reserve(shape_count());
  } catch (const std::bad_alloc&) {
    return failure("", "not enough memory for the scene");
  }
  const auto copied = [this](std::size_t i) {
    return scene.spheres.begin() + static_cast<std::ptrdiff_t>(i);
  };
  std::size_t done = 0;
  for (const KeptSpheres& spheres : kept) {
    all.spheres.insert(all.spheres.end(), copied(done), copied(spheres.spheres_before));
    done = spheres.spheres_before;
    if (Result<void> added = add_checked_spheres(all, spheres.arrays, cancel); !added)
      return tl::make_unexpected(std::move(added.error()));
  }
  all.spheres.insert(all.spheres.end(), copied(done), scene.spheres.end());
  return all;
}

}  // namespace zraka::python
