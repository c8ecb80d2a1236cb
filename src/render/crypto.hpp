// SPDX-License-Identifier: Apache-2.0
// Cryptomatte: mattes of shapes by their names (Friedman and Jones, "Fully automatic ID mattes with
// support for motion blur and transparency", 2015; the names of its channels and notes are those of
// the Cryptomatte Specification, version 1.2.0).
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>
#include <zraka/layers.hpp>
#include <zraka/scene.hpp>

namespace zraka {

/// MurmurHash3 for 32 bits (Austin Appleby) of some bytes, seed 0.
std::uint32_t murmur_hash(std::string_view bytes);

/// A hash whose bits are a float that is finite and not denormal.
std::uint32_t hash_for_float(std::string_view name);

/// Adds the channels and notes for object ids, one a pixel, as Layer::object_id has them. What has
/// no name is called "object" and its id.
void add_cryptomatte(const Scene& scene, const std::vector<std::uint32_t>& ids, Layers& layers);

}  // namespace zraka
