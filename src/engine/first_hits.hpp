// SPDX-License-Identifier: Apache-2.0
// What rays from the eye hit first, without their trees: for who wants to know what is in a
// picture.
#pragma once

#include "engine/engine.hpp"

namespace zraka {

/// Traces the rays that stand in level 0, at most a batch of them, up to their first hits: which
/// rays have one is in the level's hits.ray, hit_count of them; distances and slots by ray, and
/// points, normals, materials and, where scratch.paths has room, paths by hit are in the scratch.
template <class R>
using TraceFirstHits = void(const FrozenScene<R>& scene, Workspace<R>& workspace);

/// The same for a ray through each pixel of a tile, as the picture's; workspace.samples says which
/// is which.
template <class R>
using TraceFirstHitsOfTile = void(const FrozenScene<R>& scene, const TileRect& tile,
                                  Workspace<R>& workspace);

// Defined by first_hits.cpp, once per instruction set that the build has.
namespace isa_avx512 {
TraceFirstHits<float> trace_first_hits;
TraceFirstHitsOfTile<float> trace_first_hits_of_tile;
}  // namespace isa_avx512
namespace isa_avx2 {
TraceFirstHits<float> trace_first_hits;
TraceFirstHitsOfTile<float> trace_first_hits_of_tile;
}  // namespace isa_avx2
namespace isa_portable {
TraceFirstHits<float> trace_first_hits;
TraceFirstHitsOfTile<float> trace_first_hits_of_tile;
}  // namespace isa_portable
namespace isa_oracle {
TraceFirstHits<double> trace_first_hits;
TraceFirstHitsOfTile<double> trace_first_hits_of_tile;
}  // namespace isa_oracle

}  // namespace zraka
