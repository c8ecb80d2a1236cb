// SPDX-License-Identifier: Apache-2.0
// Builds the hierarchy.
#pragma once

#include <atomic>
#include <cstdlib>
#include <memory>
#include <new>
#include <vector>

#include "scene/hierarchy.hpp"

namespace zraka {

/// All references of a scene, in memory that can shrink without a copy.
class BuildRefs {
 public:
  explicit BuildRefs(std::size_t size);
  BuildRef* data() { return reinterpret_cast<BuildRef*>(memory_.get()); }
  std::size_t size() const { return size_; }
  BuildRef* begin() { return data(); }
  BuildRef* end() { return data() + size_; }
  BuildRef& operator[](std::size_t i) { return data()[i]; }
  /// The references' indices in their order; the references are gone.
  std::vector<std::int32_t> into_indices() &&;

 private:
  struct Free {
    void operator()(void* p) const { std::free(p); }
  };
  std::unique_ptr<void, Free> memory_;
  std::size_t size_;
};

/// A hierarchy over all references. Kind k holds the slots [kind_starts[k], kind_starts[k + 1]); a
/// leaf's first primitive counts from the start of its kind in the new order. The result does not
/// depend on the number of threads. Splits by the surface area heuristic over bins (Wald, "On fast
/// construction of SAH-based bounding volume hierarchies", 2007): large ranges straight into nodes
/// of sixteen, others as collapse.hpp says. Boxes must be finite. Needs 14 bytes a primitive
/// besides the references, which it uses up. Where `cancel` was set on the way, what it returns is
/// not to be used.
BuiltHierarchy build_hierarchy(BuildRefs refs, const std::vector<std::int32_t>& kind_starts,
                               const std::atomic<bool>* cancel = nullptr);

}  // namespace zraka
