// SPDX-License-Identifier: Apache-2.0
// An explanation for programs.
#pragma once

#include <string>
#include <zraka/explain.hpp>

namespace zraka {

/// The explanation as JSON (docs/explain.md says what each member is). Numbers of the engine have
/// the fewest digits that give the float back; what is no finite number is null. `scene` and
/// `profile` are names, `words` is the sentence about the pixel.
std::string to_json(const Explanation& explanation, const std::string& scene,
                    const std::string& profile, const std::string& words);

}  // namespace zraka
