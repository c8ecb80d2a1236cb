// SPDX-License-Identifier: Apache-2.0
// The engine with MistakenSteps; TraceSettings::variation is the Mistake.
#pragma once

#include "engine/engine.hpp"

namespace zraka::isa_portable {

extern const Kernel<float> kMistakenKernel;
RecordTile<float> record_mistaken_tile;

}  // namespace zraka::isa_portable
