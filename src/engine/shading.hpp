// SPDX-License-Identifier: Apache-2.0
// What the general engine computes of many hits at a time, in lanes of doubles (engine/shading.cpp).
#pragma once

#include "engine/engine.hpp"

namespace zraka::ZRAKA_ISA {

/// As Services::find_arriving().
template <class L>
void find_arriving(const OpticalLight& light, std::size_t n, Scratch<typename L::Real>& scratch,
                   const ArrivingLight& arriving);

/// As Services::find_highlights().
template <class L>
void find_highlights(std::size_t n, const Scratch<typename L::Real>& scratch, double* highlights);

}  // namespace zraka::ZRAKA_ISA
