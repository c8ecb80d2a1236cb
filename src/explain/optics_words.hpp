// SPDX-License-Identifier: Apache-2.0
// What there is to say of light and glass beyond the lab's, in lines: lights that are no points,
// what shadow rays pass, Fresnel, absorption, wavelengths, rays that are not worth tracing.
#pragma once

#include <string>
#include <vector>
#include <zraka/explain.hpp>

#include "core/words.hpp"

namespace zraka {

/// "light 2", "light 2 (spot)".
std::string light_title(Language language, const Explanation& explanation, std::size_t light);

/// "distance 3", or that it is infinitely far away.
std::string light_distance(Language language, const LightTerms& at);

/// What distance and a spot's cone leave of a light; no lines where that is all of it.
std::vector<std::string> fading_lines(Language language, const ExplainedLight& light,
                                      const LightTerms& at);

/// Whether it reaches the hit; where it is a surface, how much of it does.
struct ReachWords {
  std::vector<std::string> lines;
  bool in_shadow = false;
};
ReachWords reach_words(Language language, const ExplainedLight& light, const LightTerms& at);

/// The transparent bodies on its way, and what they leave; no lines for most.
std::vector<std::string> passed_lines(Language language, const LightTerms& at);
/// Whether they take anything of what arrives.
bool is_filtered(const LightTerms& at);

/// What the terms of a light that is a surface are the mean of.
std::string mean_of_samples(Language language, const LightTerms& at);

/// "inside of: sphere 1 'glass', box 2"; "" for most.
std::string inside_line(Language language, const ExplainedRay& ray);

/// What a ray has come through to its hit, and what that absorbs; "" for most.
std::string medium_line(Language language, const ExplainedHit& hit);

/// Of the ambient light, what arrives; "" for most.
std::string occlusion_line(Language language, const ExplainedHit& hit);

/// The share that the angle moves to the reflected ray; "" where that is none.
std::string fresnel_line(Language language, const ExplainedHit& hit);

/// "sky (gradient)", "background".
Word name_of_sky(const Explanation& explanation);

/// Whether the colour is the pixel's or one of its samples'.
inline Word color_of_what(const Explanation& explanation) {
  return explanation.samples > 1 ? Word::color_of_sample : Word::color_of_pixel;
}

/// What a child's share is made of: "k1", "k1 + k2·F", "k2·(1 - F)·w". `split`: of a wavelength.
std::string share_symbols(const ExplainedHit& hit, const Child& child, bool reflected, bool split);

/// Why there is no child; "" if there is nothing missing.
std::string absence_words(Language language, const Explanation& explanation,
                          const ExplainedHit& hit, const Child& child, bool reflected);

/// Whether all channels have the same value.
inline bool is_grey(const Float3& v) {
  return v[0] == v[1] && v[1] == v[2];
}

/// What becomes of the refracted share of a hit where there is total internal reflection.
Word after_total_reflection(const Explanation& explanation, const ExplainedHit& hit);

/// Channel by channel, what the wavelengths of a refracted ray bring together.
Float3 brought_by_split(const RayTree& tree, const ExplainedHit& hit);

/// Clamped to 0…1 where the profile does that.
Float3 after_clamp(const Explanation& explanation, const Float3& sum);

/// What a ray brings before fog: its hit's sum after the clamp, times what its medium leaves.
Float3 before_fog(const Explanation& explanation, const ExplainedRay& ray);

/// What fog makes of it; "" where there is none.
std::string fog_line(Language language, const Explanation& explanation, const ExplainedRay& ray);

/// What the sky adds in place of rays that are too deep; "" where nothing.
std::string sky_beyond_line(Language language, const ExplainedHit& hit);

}  // namespace zraka
