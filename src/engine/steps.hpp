// SPDX-License-Identifier: Apache-2.0
// Steps of a batch that a kernel can replace as a whole, beside the optics of Rules.
#pragma once

#include "engine/light.hpp"
#include "engine/rules.hpp"
#include "engine/spawn.hpp"

namespace zraka::ZRAKA_ISA {

struct Steps : Rules {
  template <class L, class R>
  ZRAKA_INLINE void trace_shadow_rays(const FrozenScene<R>& scene, std::size_t shadow_rays,
                                      Scratch<R>& scratch) const {
    ZRAKA_ISA::trace_shadow_rays<L>(scene, shadow_rays, scratch);
  }
  template <class L, class R, class Recorder, class Ruling>
  ZRAKA_INLINE void add_light(const FrozenLight<R>& light,
                              const Terms& terms, Level<R>& level, Scratch<R>& scratch,
                              const Recorder& record, const Ruling& rules) const {
    ZRAKA_ISA::add_light<L>(light, terms, level, scratch, record, rules);
  }
  template <class L, class R, class Recorder, class Ruling>
  ZRAKA_INLINE void spawn_reflected(const TraceSettings& settings,
                                    Level<R>& level, const Scratch<R>& scratch, Level<R>& next,
                                    RayCounts& counts, const Recorder& record,
                                    const Ruling& rules) const {
    ZRAKA_ISA::spawn_reflected<L>(settings, level, scratch, next, counts, record, rules);
  }
};

}  // namespace zraka::ZRAKA_ISA
