// SPDX-License-Identifier: Apache-2.0
// add_spheres() in its parts, for who keeps arrays and adds them later.
#pragma once

#include <atomic>
#include <cstdint>
#include <zraka/bulk.hpp>

namespace zraka {

/// What add_spheres() would find wrong.
Result<void> check_spheres(const Scene& scene, const SphereArrays& arrays);
/// Adds arrays that check_spheres() finds nothing wrong with. Where `cancel` was set on the way,
/// not all are added.
Result<void> add_checked_spheres(Scene& scene, const SphereArrays& arrays,
                                 const std::atomic<bool>* cancel = nullptr);
/// A number that is another one, almost certainly, where any number in the arrays is.
std::uint64_t fingerprint(const SphereArrays& arrays);

}  // namespace zraka
