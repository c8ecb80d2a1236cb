// SPDX-License-Identifier: Apache-2.0
// From the scene as read to the scene as traced.
#pragma once

#include <array>
#include <memory>
#include <vector>
#include <zraka/render.hpp>
#include <zraka/scene.hpp>

#include "core/unset_vector.hpp"
#include "math/frame.hpp"
#include "scene/freeze_bodies.hpp"
#include "scene/freeze_optics.hpp"
#include "scene/frozen.hpp"
#include "textures/texture_set.hpp"

namespace zraka {

/// The memory behind FrozenTextures.
struct StoredTextures {
  FrozenTextures frozen{};
  TextureSet set;
  std::vector<TextureUse> uses;
  std::vector<MaterialTextures> of_material;
  std::vector<Transform> to_shape;
};

/// The memory behind a FrozenScene.
template <class R>
struct FrozenStore {
  FrozenScene<R> scene{};
  BodyStore bodies;
  /// Groups of shapes, each in a frame of its own; their hierarchies are built like the scene's.
  std::vector<FrozenScene<R>> groups;
  std::vector<std::unique_ptr<FrozenStore<R>>> group_stores;
  std::vector<BuiltHierarchy> group_hierarchies;
  UnsetVector<R> reals, rows;
  FrozenScene<R> opaque{}, filtering{};
  UnsetVector<std::int32_t> materials, ids;
  std::vector<FrozenLight<R>> lights;
  /// By material, those whose shapes shadow rays go through; empty where there are none such.
  std::vector<std::uint8_t> shadowless;
  std::vector<std::uint8_t> passable, unfiltering;  ///< the same of FrozenScene::opaque and filtering
  /// By kind: of those shapes after the last one read that are pieces of others, which ones.
  std::array<std::vector<std::int32_t>, kKinds> parents;
  /// By kind: what textures need of shapes. Empty where no material has textures.
  std::array<std::vector<std::int32_t>, kKinds> transforms;
  std::array<std::vector<CornerUvs>, kKinds> uvs;
  std::array<std::vector<WholeTriangle>, kKinds> wholes;
  std::unique_ptr<StoredTextures> textures;
  std::unique_ptr<StoredOptics> optics;
  std::uint64_t bytes() const;
};

/// A surface that errs by 2^-20 of its distance from the frame's centre, as offsets of secondary
/// rays have it, is less than a tenth of a pixel off in a picture of a thousand pixels' width if
/// that distance is no more than so many such widths.
inline constexpr double kMostWidths = 64;

/// The engine's frame for a scene: centred on the median of its shapes, where most of the detail
/// is, unless that is far from what the camera sees; then on the nearest that it sees.
Frame frame_of(const Scene& scene);

/// Is there a sphere so large beside most shapes, or beside what the camera sees, that they need
/// their digits where it passes them?
bool has_ground_sphere(const ShapeLists& shapes, const Whereabouts& where, const Frame& frame);

/// Freezes a scene that check() finds nothing wrong with, its shapes in the order that they were
/// read; the scene is not needed any more then. R is float, or double for the oracle.
/// With `optics` also what the general engine needs, which it has in any case where the scene asks
/// for it.
template <class R>
std::unique_ptr<FrozenStore<R>> freeze(const Scene& scene, const Profile& profile,
                                       const Frame& frame, bool optics = false);

/// Where the slots of each kind of shape in the hierarchy begin, and where the last one's end.
template <class R>
std::vector<std::int32_t> kind_starts_of(const FrozenScene<R>& scene);

/// The boxes of all slots for the hierarchy's builder, enlarged by what intersections can err.
template <class R>
void refer_to(const FrozenScene<R>& scene, BuildRef* refs);

/// Puts the shapes into the order of the hierarchy, if there is one, and points the scene to its
/// nodes: the scene is then ready.
template <class R>
void reorder_by_leaf(FrozenStore<R>& store, const BuiltHierarchy& hierarchy);

/// Makes FrozenScene::opaque and filtering of a scene that is ready otherwise; shadow rays may pass what
/// is transparent, too, or only what casts no shadow.
template <class R>
void add_opaque_scene(FrozenStore<R>& store, bool transparent);

}  // namespace zraka
