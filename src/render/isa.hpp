// SPDX-License-Identifier: Apache-2.0
// Which ways to compute this build and this machine have.
#pragma once

#include <zraka/render.hpp>

#include "engine/engine.hpp"
#include "engine/first_hits.hpp"

namespace zraka {

/// The one asked for; else the one that ZRAKA_ISA names; else the fastest. Fails if it is not
/// there.
Result<Isa> choose_isa(std::optional<Isa> wanted);

/// The engine for an available instruction set; not for Isa::oracle.
const Kernel<float>& kernel_of(Isa isa);
/// First hits by the engine for an available instruction set.
TraceFirstHitsOfTile<float>& first_hits_of(Isa isa);
/// The engine that tells its terms; its bits are those of all sets.
RecordTile<float>& record_tile();

}  // namespace zraka
